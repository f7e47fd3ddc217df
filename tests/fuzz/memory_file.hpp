#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace beadswim {

/// A file, in memory if the machine has the folder /dev/shm. The destructor removes the file.
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

/// Returns the folder of such files.
std::string memory_folder();

}  // namespace beadswim
