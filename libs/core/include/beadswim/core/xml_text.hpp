#pragma once

#include <string>

namespace beadswim {

/// Returns the text as it stands in XML 1.0, between tags or in an attribute with double quotes. Bytes that
/// are not UTF-8 and characters that XML forbids, such as most control characters, become U+FFFD.
std::string xml_text(const std::string& text);

/// Returns the text whose xml_text() is given.
std::string plain_text(std::string xml);

}  // namespace beadswim
