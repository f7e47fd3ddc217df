#pragma once

#include <cstddef>

namespace beadswim {

/// Allocates zeroed memory, on huge pages if the system provides them. A kernel that streams through many
/// arrays at once would exceed the translation lookaside buffer for small pages. Free the memory with
/// std::free. Throws std::bad_alloc.
void* allocate_zeros_on_huge_pages(std::size_t bytes);

}  // namespace beadswim
