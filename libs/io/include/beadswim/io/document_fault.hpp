#pragma once

#include <string>
#include <vector>

namespace beadswim {

/// One thing wrong in a document.
struct DocumentFault {
  std::string pointer;  ///< JSON pointer (RFC 6901) to the place; "" is the whole document
  std::string message;  ///< the value, what is allowed, the remedy
};

/// Throws InputError with one line "source:/pointer: message" a fault, the first twenty. Returns if there is
/// none.
void refuse_faulty(const std::string& source, const std::vector<DocumentFault>& faults);

}  // namespace beadswim
