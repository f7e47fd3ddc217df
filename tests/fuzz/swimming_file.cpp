#include "accepted.hpp"
#include "memory_file.hpp"
#include "swimming_files.hpp"

// Files of run records and predictions, one or, as JSON lines, several, as beadswim-plot reads them.

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  std::vector<SourceDocument> documents;
  if (accepts([&] { documents = read_swimming_file(file.path()); }))
    require(!documents.empty(), "a file that is accepted holds a document");
  return 0;
}
