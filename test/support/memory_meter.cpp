#include "memory_meter.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

std::atomic<std::size_t> allocations{0};
std::atomic<std::size_t> bytes{0};
std::atomic<long long> held{0};
std::atomic<long long> peak{0};

void* count(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  const auto size = static_cast<long long>(malloc_usable_size(block));
  ++allocations;
  bytes += static_cast<std::size_t>(size);
  const long long now = held += size;
  long long most = peak;
  while (now > most && !peak.compare_exchange_weak(most, now)) {
  }
  return block;
}

void release(void* block) noexcept {
  if (block == nullptr) return;
  held -= static_cast<long long>(malloc_usable_size(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return count(std::malloc(std::max<std::size_t>(size, 1))); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = std::max(static_cast<std::size_t>(alignment), sizeof(void*));
  return count(std::aligned_alloc(step, (std::max<std::size_t>(size, 1) + step - 1) / step * step));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace mixed_palletizing::test {

void startMemoryUse() {
  allocations = 0;
  bytes = 0;
  held = 0;
  peak = 0;
}

MemoryUse memoryUse() { return {allocations, bytes, static_cast<std::size_t>(peak.load())}; }

}  // namespace mixed_palletizing::test
