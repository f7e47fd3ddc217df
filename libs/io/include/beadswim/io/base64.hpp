#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace beadswim {

/// Returns a view of the bytes of numbers in memory.
template <class T>
std::span<const char> bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Encodes bytes in Base64 (RFC 4648), without line breaks. If a stream is encoded in several pieces, the
/// size of each piece except the last must be a multiple of 3 bytes. The concatenated texts are then the
/// Base64 text of the stream.
std::string base64(std::span<const char> bytes);

/// Encodes the bytes of numbers in memory in Base64.
template <class T>
std::string base64(const std::vector<T>& values) {
  return base64(bytes_of(std::span(values)));
}

/// Returns the bytes that a Base64 text encodes, with a zero for each character = at its end. Returns nullopt
/// if the text has other characters or if its length is not a multiple of 4.
std::optional<std::string> decoded_base64(const std::string& text);

}  // namespace beadswim
