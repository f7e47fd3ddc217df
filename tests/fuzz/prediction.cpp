#include "beadswim/documents/prediction_document.hpp"
#include "documents_agree.hpp"

// Fuzz target: prediction documents, as beadswim-compare and beadswim-plot read them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The scene can be written in another form, as a layout (layout.cpp).
  require_rewritten_alike(text_of(data, size), {"scene"}, [](const Json& json) {
    return predictions_to_json(predictions_from_json(json, "prediction"));
  });
  return 0;
}
