#pragma once

#include <string>

namespace beadswim {

/// Converts an SVG document to PDF if the name `path` of the output file ends in .pdf, otherwise to PNG, with
/// the program rsvg-convert of librsvg. A PNG image has twice the size of the document, for a better
/// resolution in print. Throws InputError if rsvg-convert is not installed, and SolverError if it fails.
std::string converted_svg(const std::string& svg, const std::string& path);

}  // namespace beadswim
