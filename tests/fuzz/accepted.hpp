#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "beadswim/core/error.hpp"

// Functions for all fuzz targets. A target passes random bytes to a reader of the programs. The reader may
// refuse them with an exception that the programs report to users. If it accepts them, the result must have
// the properties that the reader promises. Everything else ends the process, which the fuzzer reports.

/// Entry function of each fuzz target, which libFuzzer calls with random bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace beadswim {

/// Ends the process and prints `promise` on standard error if `is_kept` is false.
void require(bool is_kept, const std::string& promise);

/// Returns the bytes as text.
std::string text_of(const std::uint8_t* data, std::size_t size);

/// Returns true if the reader accepts its input, and false if it throws InputError with a message. Other
/// exceptions are not caught and end the process.
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
