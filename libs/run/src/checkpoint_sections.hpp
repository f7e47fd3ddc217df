#pragma once

#include <fmt/core.h>

#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/io/checkpoint_file.hpp"

// Sections of a checkpoint that do not depend on the model.

namespace beadswim {

constexpr const char* settings_section = "settings";
constexpr const char* program_section = "program";
constexpr const char* layout_section = "layout";
constexpr const char* moment_section = "moment";
constexpr const char* record_section = "record";

/// Returns the path of a checkpoint of a trajectory. `slot`: 0 or 1.
inline std::string slot_path(const std::string& trajectory, int slot) {
  return fmt::format("{}.ckpt.{}", trajectory, slot);
}

inline std::string this_program() {
  return version() + " (" + revision() + ")";
}

inline IncomingMessage moment_of(const CheckpointReader& checkpoint) {
  return IncomingMessage(checkpoint.bytes(moment_section));
}

[[noreturn]] inline void refuse_other_version(const CheckpointReader& checkpoint) {
  throw SolverError(
      fmt::format("{}: the checkpoint was written by another version of the program; continue with that "
                  "version, or begin "
                  "without {}",
                  checkpoint.path(), Setting::restart));
}

}  // namespace beadswim
