#pragma once

#include <cstddef>

namespace beadswim {

/// Allocates zeroed memory, on huge pages of 2 MiB if the system provides them. A kernel that accesses many
/// arrays at once needs more small pages than the processor's translation lookaside buffer can store. Free
/// the memory with std::free. Throws std::bad_alloc.
void* allocate_zeros_on_huge_pages(std::size_t bytes);

}  // namespace beadswim
