#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace beadswim {

/// Source of values that are taken from the bytes of the fuzzer, one after the other. After the last byte,
/// all values are zero.
class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  bool is_at_end() const { return left_ == 0; }

  template <class Number>
  Number take() {
    Number number{};
    const std::size_t count = std::min(sizeof(Number), left_);
    if (count > 0) std::memcpy(&number, next_, count);
    skip(count);
    return number;
  }

  /// Takes a number from 0 to count - 1.
  std::size_t choice(std::size_t count) { return take<std::uint8_t>() % count; }

  /// Takes a text of at most `most` bytes.
  std::string text(std::size_t most) {
    const std::size_t count = std::min(most, left_);
    std::string result(reinterpret_cast<const char*>(next_), count);
    skip(count);
    return result;
  }

 private:
  void skip(std::size_t count) {
    next_ += count;
    left_ -= count;
  }

  const std::uint8_t* next_;
  std::size_t left_;
};

}  // namespace beadswim
