#include "beadswim/core/temporary_file.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

[[noreturn]] void fail(const char* problem) {
  throw SolverError(fmt::format("a temporary file cannot be {}: {}; free disk space for temporary files",
                                problem, std::strerror(errno)));
}

}  // namespace

OpenFile temporary_file() {
  OpenFile file(std::tmpfile());
  if (!file) fail("created");
  return file;
}

void append(const OpenFile& file, const std::string& text) {
  const bool is_at_end = std::fseek(file.get(), 0, SEEK_END) == 0;
  if (!is_at_end || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0)
    fail("written");
}

std::string read_bytes(const OpenFile& file, std::int64_t start, std::int64_t bytes) {
  std::string text(bytes, '\0');
  const ssize_t size = ::pread(::fileno(file.get()), text.data(), text.size(), start);
  if (size < 0) fail("read");
  text.resize(size);
  return text;
}

std::string read_all(const OpenFile& file) {
  std::string all;
  for (std::string part; !(part = read_bytes(file, std::ssize(all), 1 << 16)).empty();) all += part;
  return all;
}

}  // namespace beadswim
