#pragma once

#include <string>

#include "beadswim/core/error.hpp"

namespace beadswim {

/// Does `what`, and says why it cannot be done where it throws InputError or SolverError; empty if it can.
template <class What>
std::string reason_against(const What& what) {
  try {
    what();
    return {};
  } catch (const InputError& error) {
    return error.what();
  } catch (const SolverError& error) {
    return error.what();
  }
}

}  // namespace beadswim
