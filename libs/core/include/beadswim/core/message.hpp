#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

// Messages that contain plain values and records (core/fields.hpp). They are exchanged between ranks or
// stored in files, and are valid only on machines with the same representation of numbers. OutgoingMessage
// and IncomingMessage are called with a list of values, so that one function can serve both directions.

namespace beadswim {

/// Calls transfer(field) for each field of a record, in the order of messages and checkpoints:
///   1. plain values
///   2. nested records
///   3. arrays of records: element 0 of all arrays, then element 1, ...
///   4. fields that vary in size
/// Within each group the order is that of the record's list of fields.
template <HasFields Record>
void for_each_message_field(Record& record, auto&& transfer) {
  std::size_t longest = 0;
  visit_fields(
      [&]<class Field>(const char*, Field& field, auto...) {
        using Value = std::remove_const_t<Field>;
        if constexpr (is_record_array<Value>) {
          longest = std::max(longest, field.size());
        } else if constexpr (!HasFields<Value> && !varies_in_size<Value>) {
          transfer(field);
        }
      },
      record);
  visit_fields(
      [&]<class Field>(const char*, Field& field, auto...) {
        if constexpr (HasFields<Field>) transfer(field);
      },
      record);
  for (std::size_t i = 0; i < longest; ++i) {
    visit_fields(
        [&]<class Field>(const char*, Field& field, auto...) {
          if constexpr (is_record_array<std::remove_const_t<Field>>)
            if (i < field.size()) transfer(field[i]);
        },
        record);
  }
  visit_fields(
      [&]<class Field>(const char*, Field& field, auto...) {
        if constexpr (varies_in_size<std::remove_const_t<Field>>) transfer(field);
      },
      record);
}

/// A type whose values are copied byte by byte.
template <class T>
concept PlainValue =
    std::is_trivially_copyable_v<T> && !HasFields<T> && !is_record_array<T> && !varies_in_size<T>;

/// Collects values in a sequence of bytes.
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
  template <PlainValue T>
  void put(const T& value) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + sizeof(T));
    std::memcpy(bytes_.data() + end, &value, sizeof(T));
  }
  template <HasFields Record>
  void put(const Record& record) {
    for_each_message_field(record, [this](const auto& field) { put(field); });
  }
  void put(const Vec3& v) {
    for (int a = 0; a < 3; ++a) put(v[a]);
  }
  template <class T, std::size_t size>
  requires(!PlainValue<std::array<T, size>>) void put(const std::array<T, size>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put(list.size());
    for (const T& value : list) put(value);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(static_cast<std::uint8_t>(value ? 1 : 0));
    if (value) put(*value);
  }

  std::vector<char> bytes_;
};

/// Reads values from a sequence of bytes. Throws SolverError if the bytes are too few or damaged.
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
  template <PlainValue T>
  void get(T& value) {
    if (bytes_left() < sizeof(T)) throw SolverError("a message ends too early");
    std::memcpy(&value, bytes_.data() + read_, sizeof(T));
    read_ += sizeof(T);
  }
  template <HasFields Record>
  void get(Record& record) {
    for_each_message_field(record, [this](auto& field) { get(field); });
  }
  void get(Vec3& v) {
    for (int a = 0; a < 3; ++a) get(v[a]);
  }
  template <class T, std::size_t size>
  requires(!PlainValue<std::array<T, size>>) void get(std::array<T, size>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::vector<T>& list) {
    std::size_t size = 0;
    get(size);
    if (size > bytes_left()) throw SolverError("a message ends too early");
    list.resize(size);
    for (T& value : list) get(value);
  }
  template <class T>
  void get(std::optional<T>& value) {
    std::uint8_t has_value = 0;  // not bool: a damaged file may hold any byte
    get(has_value);
    if (has_value > 1) throw SolverError("a message is damaged");
    if (has_value == 1) get(value.emplace());
  }

  std::vector<char> bytes_;
  std::size_t read_ = 0;
};

}  // namespace beadswim
