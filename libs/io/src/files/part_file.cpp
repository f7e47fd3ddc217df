#include "part_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

namespace fs = std::filesystem;

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

/// Returns the file, which need not exist, at the end of a chain of symbolic links; other paths are
/// unchanged. After 40 links, the limit of Linux, returns a folder that cannot be opened.
fs::path link_target(fs::path path) {
  std::error_code ignored;
  for (int n = 0; n < 40 && fs::is_symlink(path, ignored); ++n)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return fs::is_symlink(path, ignored) ? path / "" : path;
}

/// Flushes a complete file to the disk and renames it to `target`. Replaces an older file. Returns 0, or the
/// value of errno if this fails.
int rename_durably(const std::string& file, const fs::path& target) {
  if (const int reason = sync(file, O_RDONLY)) return reason;
  const fs::path folder = target.parent_path();
  if (std::rename(file.c_str(), target.c_str()) != 0) return errno;
  return sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
}

/// Writes text to a file. Returns 0, or the value of errno if this fails.
int write(const std::string& text, std::FILE* file) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return is_written && std::fflush(file) == 0 ? 0 : errno;
}

void require_written(int reason, const std::string& what) {
  if (reason != 0) throw SolverError(fmt::format("{} cannot be written: {}", what, std::strerror(reason)));
}

/// Creates or opens a file and writes text to it. Returns 0, or the value of errno if the text cannot be
/// written. Throws InputError for the file `path` if it cannot be created.
int write_file(const fs::path& file, const std::string& text, const std::string& path) {
  const OpenFile open(std::fopen(file.c_str(), "we"));
  if (!open)
    throw InputError(
        path, "the file cannot be created: {}; name a file in a folder that exists and that you may write to",
        std::strerror(errno));
  return write(text, open.get());
}

/// Creates a temporary file in the folder of `target` and gives it the name of the target.
void replace_file(const std::string& path, const std::string& text) {
  const fs::path target = link_target(path);
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) throw InputError(path, "this path is a folder; name a file");
  const std::string temporary = fmt::format("{}.tmp{}", target.string(), ::getpid());
  int reason = write_file(temporary, text, path);
  if (reason == 0) reason = rename_durably(temporary, target);
  if (reason != 0) ::unlink(temporary.c_str());
  require_written(reason, target.string() + ": the file");
}

}  // namespace

std::string part_name(const std::string& path) {
  return link_target(path).string() + ".part";
}

int name_finished_file(const std::string& path) {
  return rename_durably(part_name(path), link_target(path));
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") return require_written(write(text, stdout), "standard output: the text");
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  // A pipe or device has no earlier contents to preserve, and must not be replaced by a regular file.
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
    return require_written(write_file(path, text, path), path + ": the file");
  replace_file(path, text);
}

}  // namespace beadswim
