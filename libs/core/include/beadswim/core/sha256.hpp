#pragma once

#include <memory>
#include <span>
#include <string>

struct evp_md_ctx_st;  // of OpenSSL

namespace beadswim {

/// Computes the SHA-256 hash of a stream of bytes.
class Sha256 {
 public:
  Sha256();

  void update(std::span<const std::byte> bytes);
  std::string hexadecimal();  ///< ends the stream and returns the hash as 64 hexadecimal digits

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

}  // namespace beadswim
