#include "memory_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "accepted.hpp"

namespace beadswim {

std::string memory_folder() {
  const std::filesystem::path memory = "/dev/shm";
  return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

MemoryFile::MemoryFile(const std::uint8_t* data, std::size_t size)
    : path_(memory_folder() + "/beadswim-fuzz.XXXXXX") {
  const int descriptor = mkstemp(path_.data());
  require(descriptor >= 0, "the machine has room for a file");
  while (size > 0) {
    const ssize_t count = write(descriptor, data, size);
    require(count > 0, "the file can be written");
    data += count;
    size -= static_cast<std::size_t>(count);
  }
  close(descriptor);
}

MemoryFile::~MemoryFile() {
  unlink(path_.c_str());
}

}  // namespace beadswim
