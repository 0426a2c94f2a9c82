#pragma once

#include <stdexcept>

namespace mixed_palletizing::planning {

/// A journal cannot be used. The message says what is wrong with which file and what to do.
class JournalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mixed_palletizing::planning
