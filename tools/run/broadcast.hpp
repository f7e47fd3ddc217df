#pragma once

#include <string>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Copies `text` from rank 0 to all ranks. Collective.
inline void broadcast(std::string& text, const Communicator& communicator) {
  std::int64_t size = std::ssize(text);
  MPI_Bcast(&size, 1, MPI_INT64_T, 0, communicator.get());
  text.resize(size);
  MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, communicator.get());
}

}  // namespace beadswim
