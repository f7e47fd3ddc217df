#include "accepted.hpp"
#include "beadswim/io/vti.hpp"
#include "memory_file.hpp"

// Fuzz target: arbitrary bytes in place of a flow file (.vti).

using namespace beadswim;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  accepts([&] {
    const VtiReader reader(file.path());
    const Index3 cells = reader.cells().cells;
    const std::size_t numbers = 3 * cells.head<2>().cast<std::size_t>().prod();
    for (const int z : {0, cells[2] - 1})
      require(reader.plane("velocity", 3, z).size() == numbers, "planes have all their cells");
  });
  return 0;
}
