#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace beadswim {

/// Base64 (RFC 4648) of a stream of bytes that comes in pieces, appended to a text.
class Base64 {
 public:
  explicit Base64(std::string& text) : text_(text) {}

  void append(std::span<const char> bytes);

  /// Ends the stream.
  void finish();

 private:
  void flush(int digits);

  std::string& text_;
  std::uint32_t group_ = 0;
  int held_ = 0;
};

/// The bytes of numbers as they lie in memory.
template <class T>
std::span<const char> bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Base64 of numbers as they lie in memory.
template <class T>
std::string base64(const std::vector<T>& values) {
  std::string text;
  Base64 encoded(text);
  encoded.append(bytes_of(std::span(values)));
  encoded.finish();
  return text;
}

}  // namespace beadswim
