// The same work for many indices on a few threads.
#pragma once

#include <cstddef>
#include <functional>

namespace mixed_palletizing::packing {

/// Calls body(worker, index) once for every index in 0 .. count - 1, ascending from one thread's view, with
/// worker in 0 .. threads - 1 telling the threads apart. One thread means the caller's own. The first
/// exception of a body ends the work early and is thrown again. Where the system has no more threads, fewer do it.
void inParallel(std::size_t count, int threads,
                const std::function<void(std::size_t worker, std::size_t index)>& body);

}  // namespace mixed_palletizing::packing
