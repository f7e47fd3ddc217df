#include "part_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace beadswim {
namespace {

/// The system's reason if the file or folder cannot be put on the disk, else 0.
int sync(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags | O_CLOEXEC);
  // Folders of some network file systems cannot be synchronised and say EINVAL.
  const bool failed = file < 0 || (fsync(file) != 0 && errno != EINVAL);
  const int reason = failed ? errno : 0;
  if (file >= 0) close(file);
  return reason;
}

}  // namespace

std::string part_name(const std::string& path) {
  return path + ".part";
}

int name_finished_file(const std::string& path) {
  if (const int reason = sync(part_name(path), O_RDONLY)) return reason;
  if (std::rename(part_name(path).c_str(), path.c_str()) != 0) return errno;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
}

}  // namespace beadswim
