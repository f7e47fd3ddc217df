#include "accepted.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "memory_file.hpp"

// Fuzz target: files with one run record or prediction, or with several as JSON lines, as beadswim-plot reads
// them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  std::size_t count = 0;
  const auto read = [&] {
    for (const SourceJson& document : read_json_documents(file.path(), "a run record or a prediction")) {
      swimming_from_json(document.json, document.source);
      ++count;
    }
  };
  if (accepts(read)) require(count > 0, "a file that is accepted holds a document");
  return 0;
}
