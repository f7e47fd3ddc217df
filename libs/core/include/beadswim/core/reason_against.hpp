#pragma once

#include <string>

#include "beadswim/core/error.hpp"

namespace beadswim {

/// Calls `action`. Returns the message of the InputError or SolverError that `action` throws, or an empty
/// string if it throws none.
template <class Action>
std::string reason_against(const Action& action) {
  try {
    action();
    return {};
  } catch (const InputError& error) {
    return error.what();
  } catch (const SolverError& error) {
    return error.what();
  }
}

}  // namespace beadswim
