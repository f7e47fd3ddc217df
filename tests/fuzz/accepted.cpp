#include "accepted.hpp"

#include <cstdio>
#include <cstdlib>

namespace beadswim {

void require(bool is_kept, const std::string& promise) {
  if (is_kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise.c_str());
  std::abort();
}

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

}  // namespace beadswim
