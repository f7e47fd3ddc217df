#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Messages of plain values. Both kinds are called with a list of values, so that one function
// (swimmer_message.hpp) serves both directions.

namespace beadswim {

class OutgoingMessage {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }

  void append(const OutgoingMessage& other) {
    bytes_.insert(bytes_.end(), other.bytes_.begin(), other.bytes_.end());
  }

  const std::vector<char>& bytes() const { return bytes_; }

 private:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + sizeof(T));
    std::memcpy(bytes_.data() + end, &value, sizeof(T));
  }
  void put(const Vec3& v) {
    for (int a = 0; a < 3; ++a) put(v[a]);
  }

  std::vector<char> bytes_;
};

class IncomingMessage {
 public:
  explicit IncomingMessage(std::vector<char> bytes) : bytes_(std::move(bytes)) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }

  bool is_at_end() const { return read_ == bytes_.size(); }

 private:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(T& value) {
    std::memcpy(&value, bytes_.data() + read_, sizeof(T));
    read_ += sizeof(T);
  }
  void get(Vec3& v) {
    for (int a = 0; a < 3; ++a) get(v[a]);
  }

  std::vector<char> bytes_;
  std::size_t read_ = 0;
};

}  // namespace beadswim
