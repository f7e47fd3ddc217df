#pragma once

#include <string>

namespace beadswim {

/// Converts an SVG document to PNG with the program rsvg-convert of librsvg. The image has twice the size of
/// the document, for a better resolution in print. `path` is the output file and serves only for messages.
/// Throws InputError if rsvg-convert is not installed, and SolverError if it fails.
std::string svg_to_png(const std::string& svg, const std::string& path);

}  // namespace beadswim
