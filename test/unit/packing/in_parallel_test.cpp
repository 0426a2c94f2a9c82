#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/in_parallel.hpp>

namespace mixed_palletizing::packing {
namespace {

TEST(InParallel, everyIndexOnceAndTheFirstException) {
  for (const int threads : {1, 3}) {
    std::vector<int> calls(100, 0);
    inParallel(calls.size(), threads, [&](std::size_t worker, std::size_t i) {
      EXPECT_LT(worker, static_cast<std::size_t>(threads));
      ++calls[i];
    });
    EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), 100);
    EXPECT_EQ(std::set<int>(calls.begin(), calls.end()).size(), 1U);
    EXPECT_THROW(inParallel(10, threads,
                            [](std::size_t, std::size_t i) {
                              if (i == 5) throw std::runtime_error("five");
                            }),
                 std::runtime_error);
  }
  inParallel(0, 4, [](std::size_t, std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace mixed_palletizing::packing
