#pragma once

#include <string>

namespace beadswim {

/// The SVG document as PNG, at twice its size so that it prints well, by librsvg's rsvg-convert. Messages
/// name `path`, the file that it is for. Throws InputError if rsvg-convert is not installed.
std::string svg_to_png(const std::string& svg, const std::string& path);

}  // namespace beadswim
