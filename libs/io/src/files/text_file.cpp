#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"
#include "part_file.hpp"

namespace beadswim {
namespace {

namespace fs = std::filesystem;

std::string system_message() {
  return std::strerror(errno);
}

/// An open file descriptor, closed with the object.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }

  /// Returns 0, or the value of errno if the text cannot be written.
  int write(const std::string& text) const {
    for (std::size_t written = 0; written < text.size();) {
      const ssize_t count = ::write(number_, text.data() + written, text.size() - written);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return errno;
      written += static_cast<std::size_t>(count);
    }
    return 0;
  }

 private:
  int number_;
};

void require_written(int reason, const fs::path& path) {
  if (reason != 0)
    throw SolverError(
        fmt::format("{}: the file cannot be written: {}", path.string(), std::strerror(reason)));
}

InputError cannot_be_created(const std::string& path) {
  return InputError(
      path,
      fmt::format(
          "the file cannot be created: {}; name a file in a folder that exists and that you may write to",
          system_message()));
}

void write_stdout(const std::string& text) {
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() || std::fflush(stdout) != 0) {
    throw SolverError(fmt::format("standard output: the text cannot be written: {}", system_message()));
  }
}

void write_in_place(const fs::path& target, const std::string& text) {
  const Descriptor file(target, O_WRONLY);
  if (!file.is_open()) throw cannot_be_created(target);
  require_written(file.write(text), target);
}

/// Creates a temporary file in the folder of `target` and gives it the name of the target.
void replace_file(const std::string& path, const std::string& text) {
  const fs::path target = link_target(path);
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) throw InputError(path, "this path is a folder; name a file");
  const std::string temporary = fmt::format("{}.tmp{}", target.string(), ::getpid());
  int reason = 0;
  {
    const Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC);
    if (!file.is_open()) throw cannot_be_created(path);
    reason = file.write(text);
  }
  if (reason == 0) reason = rename_durably(temporary, target);
  if (reason != 0) ::unlink(temporary.c_str());
  require_written(reason, target);
}

}  // namespace

std::string read_text(const std::string& path) {
  std::ostringstream text;
  if (path == "-") {
    text << std::cin.rdbuf();
    return text.str();
  }
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw InputError(path, "this path is a folder; name a file, or - for standard input");
  const std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InputError(path, fmt::format("the file cannot be read: {}; name a file, or - for standard input",
                                       system_message()));
  }
  text << file.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") return write_stdout(text);
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  // A pipe or device has no earlier contents to preserve, and must not be replaced by a regular file.
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
    return write_in_place(path, text);
  }
  replace_file(path, text);
}

}  // namespace beadswim
