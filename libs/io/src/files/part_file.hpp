#pragma once

#include <string>

// An incomplete file is named PATH.part.

namespace beadswim {

std::string part_name(const std::string& path);

/// Flushes PATH.part to the disk and renames it to PATH. Replaces an older file. Returns 0, or the value of
/// errno if this fails.
int name_finished_file(const std::string& path);

}  // namespace beadswim
