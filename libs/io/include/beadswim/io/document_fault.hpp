#pragma once

#include <string>
#include <vector>

namespace beadswim {

/// An invalid value in a document.
struct DocumentFault {
  std::string pointer;  ///< JSON pointer (RFC 6901) to the value; "" refers to the complete document
  std::string message;  ///< states the invalid value, the allowed values and the remedy
};

/// Throws InputError if there are faults. The message has one line "source:/pointer: message" for each of the
/// first twenty faults. If there are more faults, the last line states how many.
void throw_if_faulty(const std::string& source, const std::vector<DocumentFault>& faults);

}  // namespace beadswim
