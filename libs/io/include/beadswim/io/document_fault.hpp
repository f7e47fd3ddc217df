#pragma once

#include <string>
#include <vector>

namespace beadswim {

/// An invalid value in a document.
struct DocumentFault {
  std::string pointer;  ///< JSON pointer (RFC 6901) to the value; "" refers to the complete document
  std::string message;  ///< the value, the allowed values and the remedy
};

/// Throws InputError if there are faults. The message has one line "source:/pointer: message" per fault, for
/// at most twenty faults.
void throw_if_faulty(const std::string& source, const std::vector<DocumentFault>& faults);

}  // namespace beadswim
