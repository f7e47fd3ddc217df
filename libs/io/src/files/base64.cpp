#include "beadswim/io/base64.hpp"

namespace beadswim {

void Base64::append(std::span<const char> bytes) {
  for (const char byte : bytes) {
    group_ = group_ << 8 | static_cast<unsigned char>(byte);
    if (++held_ == 3) flush(4);
  }
}

void Base64::finish() {
  if (held_ == 0) return;
  const int digits = held_ + 1;
  for (; held_ < 3; ++held_) group_ <<= 8;
  flush(digits);
  text_.append(4 - digits, '=');
}

void Base64::flush(int digits) {
  constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (int d = 0; d < digits; ++d) text_ += alphabet[group_ >> (18 - 6 * d) & 63];
  group_ = 0;
  held_ = 0;
}

}  // namespace beadswim
