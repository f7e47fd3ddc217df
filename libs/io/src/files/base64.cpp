#include "beadswim/io/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <limits>

namespace beadswim {

std::string base64(std::span<const char> bytes) {
  constexpr std::size_t max_piece_bytes = 3U << 28;          // OpenSSL expects the number of bytes as an int
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // OpenSSL appends a zero to each piece
  auto* to = reinterpret_cast<unsigned char*>(text.data());
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(max_piece_bytes, bytes.size()))) {
    const auto piece = bytes.first(std::min(max_piece_bytes, bytes.size()));
    to += EVP_EncodeBlock(to, reinterpret_cast<const unsigned char*>(piece.data()),
                          static_cast<int>(piece.size()));
  }
  text.pop_back();
  return text;
}

std::optional<std::string> decoded_base64(const std::string& text) {
  if (text.size() % 4 != 0 || text.size() > std::numeric_limits<int>::max()) return std::nullopt;
  std::string bytes(text.size() / 4 * 3, '\0');
  const int decoded =
      EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                      reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  // OpenSSL skips white space, so that fewer bytes follow from it.
  if (decoded != static_cast<int>(bytes.size())) return std::nullopt;
  return bytes;
}

}  // namespace beadswim
