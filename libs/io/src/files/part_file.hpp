#pragma once

#include <string>

// A file is named PATH.part until it is complete.

namespace beadswim {

std::string part_name(const std::string& path);

/// Flushes PATH.part to the disk and renames it to PATH. Replaces an older file. Returns 0, or the value of
/// errno if this fails.
int name_finished_file(const std::string& path);

}  // namespace beadswim
