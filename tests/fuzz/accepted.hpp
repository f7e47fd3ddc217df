#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "beadswim/core/error.hpp"

// What every fuzz target is made of: it calls the reader that programs call. Bad input may end in the errors
// that programs tell and exit with; what is accepted must hold what the reader promises. All else ends the
// process.

/// The entry of each target (libFuzzer's).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace beadswim {

/// Ends the process, with `promise` on standard error, if it is not kept.
void require(bool is_kept, const std::string& promise);

/// The input as text.
std::string text_of(const std::uint8_t* data, std::size_t size);

/// Whether a reader takes its input: not if it throws InputError, with a message. Other exceptions go on, and
/// end the process.
template <class Read>
bool accepts(const Read& read) {
  try {
    read();
    return true;
  } catch (const InputError& error) {
    require(*error.what() != '\0', "a refusal says why");
    return false;
  }
}

}  // namespace beadswim
