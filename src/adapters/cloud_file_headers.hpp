// Checks of file headers before PCL reads the file: its readers crash or allocate without bound on some
// damaged ones.
#pragma once

#include <istream>
#include <string>

namespace mixed_palletizing::adapters {

/// What is wrong with the header of a PCD file of `file_bytes` bytes; empty when nothing is.
std::string pcdHeaderProblem(std::istream& file, std::size_t file_bytes);

/// The same for a PLY file.
std::string plyHeaderProblem(std::istream& file, std::size_t file_bytes);

}  // namespace mixed_palletizing::adapters
