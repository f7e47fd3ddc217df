#pragma once

#include <cstddef>

namespace beadswim {

/// Zeroed memory, to be freed by std::free, on the large pages of the processor where the system grants them:
/// many streams at once exhaust the table of small ones. Throws std::bad_alloc.
void* zeros_on_huge_pages(std::size_t bytes);

}  // namespace beadswim
