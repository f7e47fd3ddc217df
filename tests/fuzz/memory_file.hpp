#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace beadswim {

/// A file, in memory where the machine has /dev/shm, that is gone with the object.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size);
  MemoryFile() : MemoryFile(nullptr, 0) {}
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Where such files lie.
std::string memory_folder();

}  // namespace beadswim
