#pragma once

#include <string>

#include "beadswim/core/error.hpp"

namespace beadswim {

/// Calls `action`. Returns the message of the InputError or SolverError that it throws, or an empty string.
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
