#include "failing_new.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> made{0};
std::atomic<long> failing{0};  ///< the one that fails, counted by `made`; 0 = none
std::atomic<bool> failed{false};

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (++made == failing) {
    failed = true;
    return nullptr;
  }
  const std::size_t whole = (size == 0 ? 1 : size) + alignment - 1;
  return alignment <= alignof(std::max_align_t) ? std::malloc(size == 0 ? 1 : size)
                                                : std::aligned_alloc(alignment, whole - whole % alignment);
}

void* allocateOrThrow(std::size_t size, std::size_t alignment) {
  void* const memory = allocate(size, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The other forms call these by default (C++17, [new.delete]).
void* operator new(std::size_t size) { return allocateOrThrow(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace mixed_palletizing::torture {

long allocations() { return made; }

void failAllocation(long count) {
  failed = false;
  failing = made + count;
}

bool stopFailing() {
  failing = 0;
  return failed;
}

}  // namespace mixed_palletizing::torture
