#include <gtest/gtest.h>

#include "beadswim/io/base64.hpp"

namespace beadswim {
namespace {

// The examples of RFC 4648, section 10. Would catch a zero or a line break left at the end.
TEST(Base64, IsThatOfItsStandard) {
  const std::string text = "foobar";
  const std::vector<std::string> encoded{"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t n = 0; n <= text.size(); ++n) EXPECT_EQ(base64(std::span(text).first(n)), encoded[n]);
}

// VTK files are written plane by plane: would catch line breaks within long texts.
TEST(Base64, OfPiecesOfMultiplesOfThreeBytesJoins) {
  const std::string text(300, '\xfe');
  EXPECT_EQ(base64(std::span(text).first(99)) + base64(std::span(text).subspan(99)), base64(text));
  EXPECT_EQ(base64(text).find('\n'), std::string::npos);
}

TEST(Base64, IsDecoded) {
  EXPECT_EQ(decoded_base64("Zm9vYmFy"), "foobar");
  EXPECT_EQ(decoded_base64("Zm8="), std::string("fo\0", 3));
  for (const char* wrong : {"Zm9", "Zm9v Zm9", "Zm*v", "\nm9v"})
    EXPECT_EQ(decoded_base64(wrong), std::nullopt) << wrong;
}

TEST(Base64, OfNumbersIsThatOfTheirBytes) {
  EXPECT_EQ(base64(std::vector<float>{1, -2}), "AACAPwAAAMA=");
}

}  // namespace
}  // namespace beadswim
