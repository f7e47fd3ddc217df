#include "beadswim/io/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>

namespace beadswim {

std::string base64(std::span<const char> bytes) {
  constexpr std::size_t max_piece_bytes = 3U << 28;          // OpenSSL takes the number of bytes as an int
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

}  // namespace beadswim
