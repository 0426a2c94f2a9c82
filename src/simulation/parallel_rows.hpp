// Rows of an image shared out among threads.
#pragma once

#include <functional>

namespace mixed_palletizing::simulation {

/// Calls work(row) once for every row in [0, rows), from `threads` threads (the caller's among them), in any
/// order. An exception of `work` is thrown again here.
void forEachRow(int rows, int threads, const std::function<void(int)>& work);

}  // namespace mixed_palletizing::simulation
