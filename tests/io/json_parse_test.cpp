#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Returns the message with which a text is refused; an empty text if it is accepted.
std::string refusal(const std::string& text) {
  try {
    parse_json(text, "in.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(JsonParse, BuildsWhatTheLibraryBuildsOfSoundText) {
  const std::string text =
      R"({"b":[1,-2,0.1,true,null,"x",{"y":[]},[[{}]]],"a":{"c":{"d":1e-300}},"e":18446744073709551615})";
  EXPECT_EQ(parse_json(text, "in.json"), Json::parse(text));
}

TEST(JsonParse, KeepsKeysInOrderAndDoublesToTheLastBit) {
  const Json document = parse_json(R"({"z":0.1,"a":2.2250738585072014e-308})", "in.json");
  EXPECT_EQ(document.dump(), R"({"z":0.1,"a":2.2250738585072014e-308})");
  EXPECT_EQ(document["z"].get<double>(), 0.1);
}

// The library's default keeps the last of two equal keys without a word.
TEST(JsonParse, RefusesAKeyGivenTwiceWithItsPointer) {
  EXPECT_THAT(refusal(R"({"a":1,"a":2})"), StartsWith("in.json:/a: "));
  EXPECT_THAT(refusal(R"({"s":[{"id":0},{"id":1,"x":[{}],"id":1}]})"), StartsWith("in.json:/s/1/id: "));
  EXPECT_THAT(refusal(R"({"p":{"a/b~c":1,"a/b~c":1}})"), StartsWith("in.json:/p/a~1b~0c: "));
}

TEST(JsonParse, AllowsTheSameKeyInDifferentObjects) {
  EXPECT_EQ(refusal(R"([{"a":{"a":1}},{"a":1}])"), "");
}

// Copies and validators go through documents level by level, on the stack.
TEST(JsonParse, RefusesDeepNesting) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  EXPECT_EQ(refusal(nested(200)), "");
  EXPECT_THAT(refusal(nested(201)), HasSubstr("nested more than 200 levels deep"));
  EXPECT_THAT(refusal(nested(1000000)), HasSubstr("nested more than 200 levels deep"));
}

// Compared one by one, ten times as many keys take a hundred times as long.
TEST(JsonParse, ManyKeysOfOneObjectTakeASecond) {
  std::string text = "{";
  for (int k = 0; k < 500000; ++k) text += "\"" + std::to_string(k) + "\":0,";
  EXPECT_EQ(refusal(text + "\"last\":0}"), "");
  EXPECT_THAT(refusal(text + "\"17\":0}"), HasSubstr("/17: this key is given twice"));
}

TEST(JsonParse, RefusesNumbersThatAreNotFinite) {
  for (const char* word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"}) {
    EXPECT_THAT(refusal(std::string("{\"a\":\n  ") + word + "}"), StartsWith("in.json: line 2, column "))
        << word;
    EXPECT_THAT(refusal(std::string("{\"a\":\n  ") + word + "}"), HasSubstr("finite number")) << word;
  }
  EXPECT_THAT(refusal("[1e999]"), HasSubstr("1e999 is beyond the range of a double"));
}

TEST(JsonParse, SaysLineAndColumnOfASyntaxError) {
  EXPECT_THAT(refusal("{\n  \"a\": 1,\n  \"b\" 2\n}"), StartsWith("in.json: line 3, column 7: "));
}

TEST(JsonParse, RefusesWhatJsonDoesNotHave) {
  for (const char* text :
       {"// comment\n{}", "{} {}", "[1,]", "{'a':1}", "[01]", "[.5]", "[1.]", "[+1]", "\"\xff\""}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

// The parser of nlohmann-json takes a NUL character for the end of the text.
TEST(JsonParse, RefusesNulCharactersAndOtherEncodings) {
  EXPECT_THAT(refusal(std::string("{}\n\0", 4)),
              StartsWith("in.json: line 2, column 1: the text contains a NUL"));
  EXPECT_THAT(refusal(std::string("[1,\0 2]", 7)), HasSubstr("line 1, column 4: the text contains a NUL"));
  const std::string utf16("{\0}\0", 4), utf32("{\0\0\0}\0\0\0", 8);
  for (const std::string& text : {"\xFF\xFE" + utf16, utf16, "\xFE\xFF" + std::string("\0{\0}", 4),
                                  std::string("\0{\0}", 4), "\xFF\xFE" + std::string(2, '\0') + utf32, utf32})
    EXPECT_THAT(refusal(text), HasSubstr("not UTF-8, but probably UTF-16")) << text;
  EXPECT_EQ(refusal("\xEF\xBB\xBF{}"), "");  // UTF-8 with a byte-order mark
}

// Cut anywhere, a document is refused; cut inside, the message says that its end is missing.
TEST(JsonParse, SaysThatATruncatedTextEndsTooEarly) {
  const std::string text = R"({"a":[1,"xy",true],"b":{"c":-0.5}})";
  for (std::size_t length = 1; length < text.size(); ++length) {
    EXPECT_THAT(refusal(text.substr(0, length)), HasSubstr("truncated")) << text.substr(0, length);
  }
  EXPECT_THAT(refusal(" \n"), HasSubstr("empty"));
}

}  // namespace
}  // namespace beadswim
