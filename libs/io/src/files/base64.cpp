#include "beadswim/io/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>

namespace beadswim {

std::string base64(std::span<const char> bytes) {
  constexpr std::size_t longest = 3U << 28;                  // OpenSSL counts bytes as int
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // it ends each piece with a zero
  auto* to = reinterpret_cast<unsigned char*>(text.data());
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(longest, bytes.size()))) {
    const auto piece = bytes.first(std::min(longest, bytes.size()));
    to += EVP_EncodeBlock(to, reinterpret_cast<const unsigned char*>(piece.data()),
                          static_cast<int>(piece.size()));
  }
  text.pop_back();
  return text;
}

}  // namespace beadswim
