#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "beadswim/core/box.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

TEST(JsonDump, WritesShortValuesOnOneLineAndOpensLongOnes) {
  const Json document{
      {"short", {1, 2.5, "x"}}, {"long", Json(std::vector<int>(60, 7))}, {"empty", Json::object()}};
  const std::string text = dump_json(document);
  EXPECT_THAT(text, testing::StartsWith("{\n  \"short\": [1, 2.5, \"x\"],\n  \"long\": [\n    7,\n    7,"));
  EXPECT_THAT(text, testing::EndsWith("  ],\n  \"empty\": {}\n}\n"));
}

// Bitwise, over the whole range of exponents.
TEST(JsonDump, RoundTripsEveryDouble) {
  constexpr int seed = 7;
  RecordProperty("seed", seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-1022, 1023);
  Json document = Json::array();
  for (int i = 0; i < 2000; ++i) document.push_back(std::ldexp(mantissa(random), exponent(random)));
  const Json again = parse_json(dump_json(document), "dumped");
  for (std::size_t i = 0; i < document.size(); ++i) {
    EXPECT_EQ(again[i].get<double>(), document[i].get<double>());
  }
}

// Without the table of names nlohmann-json would write the enumerator's number.
TEST(JsonDump, WritesAnEnumerationByName) {
  const Json document{{"boundary", {Boundary::periodic, Boundary::no_slip}}};
  EXPECT_EQ(dump_json_line(document), "{\"boundary\":[\"periodic\",\"no-slip\"]}\n");
  EXPECT_EQ(document.at("boundary").at(1).get<Boundary>(), Boundary::no_slip);
}

// The library writes null for a number that is not finite, and so loses it.
TEST(JsonDump, RefusesNumbersThatAreNotFiniteWithTheirPointer) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Json document{{"swimmers", {{{"velocity", {0.0, value}}}}}};
    try {
      dump_json(document);
      FAIL() << "wrote " << value;
    } catch (const SolverError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("/swimmers/0/velocity/1"));
    }
  }
}

}  // namespace
}  // namespace beadswim
