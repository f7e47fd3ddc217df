#pragma once

#include <filesystem>
#include <string>

// A file is named PATH.part until it is complete. If PATH is a symbolic link, both names are those of its
// target.

namespace beadswim {

/// Returns the file, which need not exist, at the end of a chain of symbolic links; other paths are
/// unchanged. After 40 links, the limit of Linux, returns a folder that cannot be opened.
std::filesystem::path link_target(std::filesystem::path path);

std::string part_name(const std::string& path);

/// Flushes a complete file to the disk and renames it to `target`. Replaces an older file. Returns 0, or the
/// value of errno if this fails.
int rename_durably(const std::string& file, const std::filesystem::path& target);
/// Renames PATH.part to PATH in this way.
int name_finished_file(const std::string& path);

}  // namespace beadswim
