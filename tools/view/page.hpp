#pragma once

namespace beadswim {

/// The page, built from tools/view/page by esbuild; what it shows goes between its two halves.
struct Page {
  const char* before_data;  ///< nullptr if it could not be built
  const char* after_data;
  const char* fault;  ///< why not, and what to do; empty if it could
};

extern const Page page;  ///< defined in a file that the build writes

}  // namespace beadswim
