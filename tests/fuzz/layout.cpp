#include "beadswim/documents/layout_document.hpp"
#include "documents_agree.hpp"

// Fuzz target: layouts, as every program reads them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // These members can be written in another form: units by name or by factor, axes and orientations
  // normalised to length 1 with rounding errors, and drivings that are equal to those of the type.
  require_rewritten_alike(text_of(data, size), {"units", "axis", "orientation", "driving"},
                          [](const Json& json) { return layout_to_json(layout_from_json(json, "layout")); });
  return 0;
}
