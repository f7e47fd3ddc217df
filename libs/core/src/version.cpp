#include "beadswim/core/version.hpp"

#include <fstream>

#include "revision.hpp"

namespace beadswim {

std::string version() {
  return BEADSWIM_VERSION;
}
std::string revision() {
  return BEADSWIM_REVISION;
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t name = line.find(": ");
    if (line.starts_with("model name") && name != std::string::npos) return line.substr(name + 2);
  }
  return "unknown";
}

}  // namespace beadswim
