#pragma once

#include <memory>
#include <span>
#include <string>

namespace beadswim {

/// SHA-256 of a stream of bytes.
class Sha256 {
 public:
  Sha256();

  void update(std::span<const std::byte> bytes);
  std::string hexadecimal();  ///< 64 digits; ends the stream

 private:
  struct Free {
    void operator()(void* context) const;
  };
  std::unique_ptr<void, Free> context_;
};

}  // namespace beadswim
