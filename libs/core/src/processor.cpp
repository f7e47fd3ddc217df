#include "beadswim/core/processor.hpp"

#include <fstream>

namespace beadswim {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t name = line.find(": ");
    if (line.starts_with("model name") && name != std::string::npos) return line.substr(name + 2);
  }
  return "unknown";
}

}  // namespace beadswim
