#include "beadswim/io/document_stream.hpp"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r\n") == std::string::npos;
}

[[noreturn]] void refuse_unreadable(const std::string& source) {
  throw InputError(source, "the file cannot be read: {}; name a file, or - for standard input",
                   std::strerror(errno));
}

/// Reads the next line, with its end. Returns false at the end of the file. Throws InputError if the file
/// cannot be read.
bool read_line(std::FILE* file, std::string& line, const std::string& source) {
  char* text = nullptr;
  std::size_t capacity = 0;
  errno = 0;
  const ssize_t length = ::getline(&text, &capacity, file);
  const std::unique_ptr<char, decltype(&std::free)> owner(text, &std::free);
  if (length < 0 && std::ferror(file)) refuse_unreadable(source);
  line.assign(text ? text : "", static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  return length >= 0;
}

bool read_line_with_text(std::FILE* file, std::string& line, const std::string& source) {
  while (read_line(file, line, source))
    if (!is_blank(line)) return true;
  return false;
}

/// Returns a temporary file with the rest of a file, at its beginning.
OpenFile copy_of(std::FILE* file, const std::string& source) {
  OpenFile copy = temporary_file();
  std::string part(1 << 16, '\0');
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file))
    append(copy, part.substr(0, size));
  if (std::ferror(file)) refuse_unreadable(source);
  std::rewind(copy.get());
  return copy;
}

OpenFile open_file(const std::string& path, const std::string& source) {
  OpenFile file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse_unreadable(source);
  return file;
}

/// Returns a copy of a file that can be read only once, such as standard input or a pipe; nullptr for others.
OpenFile copy_if_read_once(const std::string& path, const std::string& source) {
  if (path == "-") return copy_of(stdin, source);
  const OpenFile file = open_file(path, source);
  struct stat status {};
  if (::fstat(::fileno(file.get()), &status) != 0) refuse_unreadable(source);
  if (S_ISDIR(status.st_mode))
    throw InputError(source, "this path is a folder; name a file, or - for standard input");
  return S_ISREG(status.st_mode) ? nullptr : copy_of(file.get(), source);
}

}  // namespace

OpenFile open_input(const std::string& path) {
  OpenFile copy = copy_if_read_once(path, path);
  return copy ? std::move(copy) : open_file(path, path);
}

std::string read_text(const std::string& path) {
  return read_all(open_input(path));
}

void require_one_standard_input(const std::vector<std::string>& paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw InputError("-", "standard input can be read only once; name files for the other inputs");
}

DocumentStream::DocumentStream(const std::vector<std::string>& paths) {
  require_one_standard_input(paths);
  for (const std::string& path : paths) {
    File& file = files_.emplace_back(File{.source = path == "-" ? "standard input" : path});
    file.copy = copy_if_read_once(path, file.source);
    file_ = files_.size() - 1;
    std::FILE* stream = open_at_start();
    std::string first, second;
    const bool has_first = read_line_with_text(stream, first, file.source);
    const bool has_second = has_first && read_line_with_text(stream, second, file.source);
    const bool is_first_complete = has_first && Json::accept(first);
    file.is_lines = is_first_complete || (has_second && second[0] == '{' && Json::accept(second));
    file.has_several = file.is_lines && has_second;
    is_lines_ = is_lines_ && file.is_lines;
  }
  rewind();
}

std::FILE* DocumentStream::open_at_start() {
  const File& file = files_[file_];
  open_ = file.copy ? nullptr : open_file(file.source, file.source);
  if (file.copy) std::rewind(file.copy.get());
  return stream();
}

std::optional<StreamMember> DocumentStream::next() {
  for (; file_ < files_.size(); ++file_, line_ = 0) {
    const File& file = files_[file_];
    if (line_ == 0) open_at_start();
    StreamMember member{.text = {}, .source = file.source};
    if (!file.is_lines && line_++ == 0) {
      for (std::string line; read_line(stream(), line, file.source);) member.text += line;
      member.number = ++number_;
      return member;
    }
    while (file.is_lines && read_line(stream(), member.text, file.source)) {
      ++line_;
      if (is_blank(member.text)) continue;
      member.text.erase(member.text.find_last_not_of("\r\n") + 1);
      if (file.has_several) member.source = fmt::format("{} line {}", file.source, line_);
      member.number = ++number_;
      return member;
    }
  }
  return std::nullopt;
}

void DocumentStream::rewind() {
  file_ = 0;
  line_ = number_ = 0;
}

}  // namespace beadswim
