#pragma once

#include <span>
#include <string>
#include <vector>

namespace beadswim {

/// The bytes of numbers as they lie in memory.
template <class T>
std::span<const char> bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Base64 (RFC 4648) of bytes, without line breaks. Texts of pieces join if the pieces have multiples of 3
/// bytes.
std::string base64(std::span<const char> bytes);

/// Base64 of numbers as they lie in memory.
template <class T>
std::string base64(const std::vector<T>& values) {
  return base64(bytes_of(std::span(values)));
}

}  // namespace beadswim
