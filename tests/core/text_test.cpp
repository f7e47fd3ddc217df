#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/names.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/core/xml_text.hpp"

namespace beadswim {
namespace {

// RFC 3629 (UTF-8) and the production Char of XML 1.0. python3 of tests/cli reads such texts in whole
// documents.
TEST(XmlText, IsWhatXmlReadersGiveBack) {
  EXPECT_EQ(xml_text("a&b<c>\"d'"), "a&amp;b&lt;c&gt;&quot;d'");
  EXPECT_EQ(xml_text("a\tb\nc"), "a&#9;b&#10;c");  // plain ones become blanks in an attribute
  EXPECT_EQ(xml_text("λ 日 \xF0\x9F\x90\x9F"), "λ 日 \xF0\x9F\x90\x9F");
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(xml_text(std::string("a\0b", 3)), "a" + replaced + "b");
  for (const char* one : {"\x01", "\x1F", "\xFF", "\xA4", "\xEF\xBF\xBE"})  // the last one is U+FFFE
    EXPECT_THAT(xml_text(one), testing::MatchesRegex("(" + replaced + ")+")) << one;
  for (const char* several : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE6\x97"})  // not UTF-8
    EXPECT_THAT(xml_text(several), testing::MatchesRegex("(" + replaced + ")+")) << several;
}

TEST(XmlText, IsReadBack) {
  for (const std::string text : {"a&b<c>\"d'\t\n", "&amp;lt;", "&", "λ"})
    EXPECT_EQ(plain_text(xml_text(text)), text);
}

TEST(NearestName, FindsTheLikelyMeaning) {
  const std::vector<std::string> names{"radius", "density", "damping", "stiffness"};
  EXPECT_EQ(nearest_name("raduis", names), "radius");   // neighbours swapped
  EXPECT_EQ(nearest_name("dampng", names), "damping");  // a letter missing
  EXPECT_EQ(nearest_name("stifness", names), "stiffness");
  EXPECT_EQ(nearest_name("viscosty", {"schema", "kinematic_viscosity"}), "kinematic_viscosity");  // of a part
  EXPECT_EQ(nearest_name("LBM", {"rpy", "lbm"}), "lbm");
  EXPECT_EQ(nearest_name("log", {"linear", "log-y"}), "log-y");
}

TEST(NearestName, IsEmptyWhereNoneIsNear) {
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name("x", {"y"}), "");  // nothing in common
  EXPECT_EQ(nearest_name("foo", {"radius", "box"}), "");
  EXPECT_EQ(nearest_name("dt", {"tolerance", "time-limit"}), "");
  EXPECT_EQ(nearest_name("", {"radius"}), "");
  EXPECT_EQ(nearest_name(std::string(101, 'r'), {std::string(100, 'r')}),
            "");  // no name has a hundred letters
  EXPECT_EQ(format_suggestion("foo", {"radius"}), ".");
  EXPECT_EQ(format_suggestion("raduis", {"radius"}), "; did you mean \"radius\"?");
}

// NIST's examples, FIPS 180-2, appendix B.
TEST(Sha256, GivesThePublishedDigests) {
  const auto digest = [](const std::string& text) {
    Sha256 hash;
    hash.update(std::as_bytes(std::span(text)));
    return hash.hexadecimal();
  };
  EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Version, IsThreeNumbers) {
  int major = -1, minor = -1, patch = -1;
  EXPECT_EQ(std::sscanf(version().c_str(), "%d.%d.%d", &major, &minor, &patch), 3);
  EXPECT_FALSE(revision().empty());
}

}  // namespace
}  // namespace beadswim
