#include "beadswim/documents/layout_document.hpp"
#include "documents_agree.hpp"

// Layouts, as every program reads them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Units by name or factor, axes to roundoff of length 1, and drivings that are their type's are written
  // otherwise.
  require_rewritten_alike(text_of(data, size), {"units", "axis", "driving"},
                          [](const Json& json) { return layout_to_json(layout_from_json(json, "layout")); });
  return 0;
}
