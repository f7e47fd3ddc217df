#pragma once

#include <cstddef>

namespace beadswim {

/// Allocates zeroed memory, on huge pages of 2 MiB if the system provides them. Huge pages make kernels
/// faster that access many arrays at once: with small pages, such a kernel needs more pages than the
/// translation lookaside buffer of the processor can store. Free the memory with std::free. Throws
/// std::bad_alloc.
void* allocate_zeros_on_huge_pages(std::size_t bytes);

}  // namespace beadswim
