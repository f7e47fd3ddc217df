#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace beadswim {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// Returns a new, empty file without a name, for temporary data. Closing the file removes it. Throws
/// SolverError if the file cannot be created.
OpenFile temporary_file();

/// Appends text to a temporary file. Throws SolverError if it cannot be written.
void append(const OpenFile& file, const std::string& text);

/// Returns `bytes` bytes of a temporary file, from the byte `start` on; fewer at the end of the file. Throws
/// SolverError if it cannot be read.
std::string read_bytes(const OpenFile& file, std::int64_t start, std::int64_t bytes);

/// Returns all bytes of a temporary file. Throws SolverError if it cannot be read.
std::string read_all(const OpenFile& file);

}  // namespace beadswim
