#pragma once

#include <string>

namespace beadswim {

/// Throws InputError unless `path` is "-" or ends in .svg or .png.
void require_figure_path(const std::string& path);

/// Writes an SVG document as it is (.svg, or stdout for "-") or as PNG (.png), through librsvg's
/// rsvg-convert. Throws InputError if that is not installed or the file cannot be created.
void write_figure(const std::string& path, const std::string& svg);

}  // namespace beadswim
