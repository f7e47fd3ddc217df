#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

// A message is a sequence of bytes that contains values: numbers, vectors, lists, and records (structs that
// list their fields in visit_fields, core/fields.hpp). Messages are sent between ranks or stored in files.
// The bytes are copied from memory, so they can be read only on machines with the same representation of
// numbers.
//
// OutgoingMessage writes values with the call message(value, ...), and IncomingMessage reads them with the
// same call. One function template can therefore both write and read a list of values.

namespace beadswim {

/// Calls transfer(field) once for each field of a record, in the order in which messages and checkpoints
/// contain the fields:
///   1. numbers and other fields that belong to none of the groups 2 to 4
///   2. fields that are records themselves
///   3. fields that are arrays of records: element 0 of each array, then element 1 of each array, ...
///   4. fields whose number of bytes varies: optionals and vectors
/// Fields of the same group keep the order in which the record's visit_fields lists them.
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

/// A type whose values a message copies byte by byte, for example numbers.
template <class T>
concept PlainValue =
    std::is_trivially_copyable_v<T> && !HasFields<T> && !is_record_array<T> && !varies_in_size<T>;

/// Message that is written: message(value, ...) appends the bytes of the values.
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
    for_each_message_field(record, [this](const auto& field) { this->put(field); });
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

/// Message that is read: message(value, ...) assigns the next values. They must have the types and the order
/// in which an OutgoingMessage wrote them. Throws DataError if the bytes are too few or damaged.
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
    if (bytes_left() < sizeof(T))
      throw DataError("data from another rank or from a checkpoint end too early");
    std::memcpy(&value, bytes_.data() + read_, sizeof(T));
    read_ += sizeof(T);
  }
  template <HasFields Record>
  void get(Record& record) {
    for_each_message_field(record, [this](auto& field) { this->get(field); });
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
    if (size > bytes_left()) throw DataError("data from another rank or from a checkpoint end too early");
    list.resize(size);
    for (T& value : list) get(value);
  }
  template <class T>
  void get(std::optional<T>& value) {
    std::uint8_t has_value = 0;  // not bool, because a damaged file may contain any byte
    get(has_value);
    if (has_value > 1) throw DataError("data from another rank or from a checkpoint are damaged");
    if (has_value == 1) get(value.emplace());
  }

  std::vector<char> bytes_;
  std::size_t read_ = 0;
};

}  // namespace beadswim
