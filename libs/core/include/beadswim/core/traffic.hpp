#pragma once

#include <cstdint>

namespace beadswim {

/// Number and total size of the messages that one rank has sent to other ranks.
struct Traffic {
  std::int64_t messages = 0;
  std::int64_t bytes = 0;

  void add_message(std::int64_t size) {
    ++messages;
    bytes += size;
  }
  void add(const Traffic& other) {
    messages += other.messages;
    bytes += other.bytes;
  }
};

}  // namespace beadswim
