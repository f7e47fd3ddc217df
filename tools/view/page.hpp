#pragma once

namespace beadswim {

/// HTML page in two parts, built from tools/view/page by esbuild. The data (page_data) are inserted between
/// the parts.
struct Page {
  const char* before_data;  ///< nullptr if the page could not be built
  const char* after_data;
  const char* build_error;  ///< reason why the page could not be built, and what to do; empty if it was built
};

extern const Page page;  ///< defined in page.cpp, which the build generates

}  // namespace beadswim
