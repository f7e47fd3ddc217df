#include "accepted.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "variation_text.hpp"

// Fuzz target: beadswim-layout vary. The input is {"over": [VARIATION, ...], "together": true, "layout":
// {...}}.

using namespace beadswim;

namespace {

constexpr std::size_t max_points = 8;  // bounds the time of an input

void vary(const Json& input) {
  const Json over = input.value("over", Json::array()), layout = input.value("layout", Json());
  if (!over.is_array()) return;
  std::vector<Variation> variations;
  for (const Json& text : over)
    if (text.is_string()) variations.push_back(parse_variation(text.get<std::string>()).first);
  if (variations.empty()) return;  // the program requires the flag
  const bool is_together = input.value("together", Json()) == true;
  if (is_together) require_equal_counts(variations);
  std::size_t left = max_points;
  for (const StudyPoint& point : study_points(variations, is_together, "--over")) {
    if (left-- == 0) return;
    const LayoutDocument varied = with_values(layout, point, "layout", "--over");
    for (const auto& [name, value] : point)
      require(varied.study.at(name) == value, "the study has the value of each quantity");
    const Json json = layout_to_json(varied);
    require(accepts([&] { layout_from_json(json, "layout"); }), "a varied layout is valid");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  accepts([&] {
    if (const Json input = parse_json(text_of(data, size), "study"); input.is_object()) vary(input);
  });
  return 0;
}
