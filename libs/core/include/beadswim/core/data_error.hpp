#pragma once

#include <string>

#include "beadswim/core/error.hpp"

namespace beadswim {

/// Invalid data in a file or in a message from another rank, for example because the file is damaged. The
/// message states what is wrong. The function that opens the file adds the remedy.
class DataError : public SolverError {
 public:
  using SolverError::SolverError;
  /// Constructs the message "PLACE: fault". `place` is a file or an object in a file.
  DataError(const std::string& place, const std::string& fault) : SolverError(place + ": " + fault) {}
};

}  // namespace beadswim
