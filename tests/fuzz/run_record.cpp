#include "beadswim/documents/results.hpp"
#include "documents_agree.hpp"

// Fuzz target: run records, as beadswim-compare, beadswim-plot and beadswim-theory --stroke-from read them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The scene can be written in another form, as a layout (layout.cpp).
  require_rewritten_alike(text_of(data, size), {"scene"}, [](const Json& json) {
    const RunRecord record = run_record_from_json(json, "run");
    for (const SwimmerRecord& swimmer : record.swimmers)
      accepts([&] { results_of(record, swimmer, CycleChoice{}, "run"); });
    return run_record_to_json(record, RecordProvenance::written);
  });
  return 0;
}
