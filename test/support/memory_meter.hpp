// Counts what a piece of code takes from the heap. memory_meter.cpp replaces operator new and delete of the program
// that it is linked into, also for the shared libraries.
#pragma once

#include <cstddef>

namespace mixed_palletizing::test {

struct MemoryUse {
  std::size_t allocations = 0;
  std::size_t bytes = 0;       ///< of all of them
  std::size_t peak_bytes = 0;  ///< most that was held at once, beyond what was held before
};

/// From now until memoryUse(), by all threads.
void startMemoryUse();
MemoryUse memoryUse();

}  // namespace mixed_palletizing::test
