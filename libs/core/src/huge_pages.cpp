#include "beadswim/core/huge_pages.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace beadswim {

void* allocate_zeros_on_huge_pages(std::size_t bytes) {
  constexpr std::size_t huge_page = std::size_t{1} << 21;
  const std::size_t rounded_bytes = (bytes + huge_page - 1) / huge_page * huge_page;
  void* memory = std::aligned_alloc(huge_page, rounded_bytes);
  if (memory == nullptr) throw std::bad_alloc();
  madvise(memory, rounded_bytes, MADV_HUGEPAGE);  // a hint, which the system may ignore
  std::memset(memory, 0, rounded_bytes);
  return memory;
}

}  // namespace beadswim
