#include "part_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace beadswim {
namespace {

/// Flushes a file or a folder to the disk. Returns 0, or the value of errno if this fails.
int sync(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags | O_CLOEXEC);
  // Some folders cannot be opened, although files in them can be renamed. Some network file systems cannot
  // synchronise folders and return EINVAL.
  const bool failed = file < 0 ? (flags & O_DIRECTORY) == 0 : fsync(file) != 0 && errno != EINVAL;
  const int reason = failed ? errno : 0;
  if (file >= 0) close(file);
  return reason;
}

}  // namespace

std::filesystem::path link_target(std::filesystem::path path) {
  std::error_code ignored;
  for (int n = 0; n < 40 && std::filesystem::is_symlink(path, ignored); ++n)
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  return std::filesystem::is_symlink(path, ignored) ? path / "" : path;
}

std::string part_name(const std::string& path) {
  return link_target(path).string() + ".part";
}

int rename_durably(const std::string& file, const std::filesystem::path& target) {
  if (const int reason = sync(file, O_RDONLY)) return reason;
  const std::filesystem::path folder = target.parent_path();
  if (std::rename(file.c_str(), target.c_str()) != 0) return errno;
  return sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
}

int name_finished_file(const std::string& path) {
  return rename_durably(part_name(path), link_target(path));
}

}  // namespace beadswim
