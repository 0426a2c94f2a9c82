#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <mixed_palletizing/packing/in_parallel.hpp>

namespace mixed_palletizing::packing {

void inParallel(std::size_t count, int threads,
                const std::function<void(std::size_t worker, std::size_t index)>& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&](std::size_t worker) {
    try {
      for (std::size_t i = next++; i < count; i = next++) body(worker, i);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  const std::size_t wanted = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
  try {
    for (std::size_t worker = 1; worker < wanted; ++worker) others.emplace_back(work, worker);
  } catch (const std::exception&) {
    // No memory or no thread to be had: those there are do the work.
  }
  work(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace mixed_palletizing::packing
