#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/core/vec3.hpp"

// Messages of plain values, between ranks of one machine and in its files. Both kinds are called with a list
// of values, so that one function (such as coupling's transfer_swimmer) serves both directions.

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
  template <class T>
  void put(const std::vector<T>& list) {
    put(list.size());
    for (const T& value : list) put(value);
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
  std::size_t bytes_left() const { return bytes_.size() - read_; }

 private:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(T& value) {
    if (bytes_left() < sizeof(T)) throw SolverError("a message ends too early");
    std::memcpy(&value, bytes_.data() + read_, sizeof(T));
    read_ += sizeof(T);
  }
  void get(Vec3& v) {
    for (int a = 0; a < 3; ++a) get(v[a]);
  }
  template <class T>
  void get(std::vector<T>& list) {
    std::size_t size = 0;
    get(size);
    if (size > bytes_left()) throw SolverError("a message ends too early");
    list.resize(size);
    for (T& value : list) get(value);
  }

  std::vector<char> bytes_;
  std::size_t read_ = 0;
};

}  // namespace beadswim
