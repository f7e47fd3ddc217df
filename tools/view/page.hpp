#pragma once

namespace beadswim {

/// The web page in two parts; the data of a run (page_data) are inserted between them. The build makes both
/// parts from the sources in tools/view/page with esbuild.
struct Page {
  const char* before_data;  ///< nullptr if the page could not be built
  const char* after_data;
  const char* build_error;  ///< why the page could not be built, and what to do; empty if built
};

extern const Page page;  ///< defined in page.cpp, which the build generates

}  // namespace beadswim
