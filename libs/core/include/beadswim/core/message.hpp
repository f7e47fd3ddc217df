#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/core/fields.hpp"

// A message is a sequence of bytes that contains values: numbers, vectors, lists, and records (structs that
// list their fields, core/fields.hpp). Messages are sent between ranks or stored in files.
// The bytes are copied from memory, so they can be read only on machines with the same representation of
// numbers.
//
// OutgoingMessage writes values with the call message(value, ...), and IncomingMessage reads them with the
// same call. One function template can therefore both write and read a list of values.

namespace beadswim {

/// Group of a field in messages and checkpoints, which contain the fields of a record in this order:
///   1. numbers and other fields that belong to none of the groups 2 to 4
///   2. fields that are records themselves
///   3. fields that are arrays of records: element 0 of each array, then element 1 of each array, ...
///   4. fields whose number of bytes varies: optionals and vectors
/// Fields of the same group keep the order in which the record lists them.
template <class T>
inline constexpr int message_group = HasFields<T>         ? 2
                                     : is_record_array<T> ? 3
                                     : varies_in_size<T>  ? 4
                                                          : 1;

template <int group>
void for_each_field_of_group(auto& record, auto&& handle) {
  visit_fields(
      [&]<class Field>(const char*, Field& field, auto...) {
        if constexpr (message_group<std::remove_const_t<Field>> == group) handle(field);
      },
      record);
}

/// Transfers a value between memory and a message, which copies the bytes of plain values.
template <class T>
void transfer_value(auto& message, T& value) {
  using Value = std::remove_const_t<T>;
  const auto transfer_field = [&](auto& field) { transfer_value(message, field); };
  if constexpr (HasFields<Value>) {
    for_each_field_of_group<1>(value, transfer_field);
    for_each_field_of_group<2>(value, transfer_field);
    std::size_t longest = 0;
    for_each_field_of_group<3>(value, [&](auto& array) { longest = std::max(longest, array.size()); });
    for (std::size_t i = 0; i < longest; ++i)
      for_each_field_of_group<3>(value, [&](auto& array) {
        if (i < array.size()) transfer_value(message, array[i]);
      });
    for_each_field_of_group<4>(value, transfer_field);
  } else if constexpr (is_optional<Value>) {
    message.transfer_size(value);
    if (value) transfer_value(message, *value);
  } else if constexpr (std::is_trivially_copyable_v<Value> && !is_record_array<Value>) {
    message.copy(&value, sizeof value);
  } else {  // list, array or vector
    if constexpr (varies_in_size<Value>) message.transfer_size(value);
    for (auto& element : value) transfer_value(message, element);
  }
}

/// Message that is written: message(value, ...) appends the bytes of the values.
class OutgoingMessage {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (transfer_value(*this, values), ...);
  }

  void append(const OutgoingMessage& other) { copy(other.bytes_.data(), other.bytes_.size()); }

  const std::vector<char>& bytes() const { return bytes_; }

  // For transfer_value().

  void copy(const void* from, std::size_t size) {
    const auto* first = static_cast<const char*>(from);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  template <class T>
  void transfer_size(const std::vector<T>& list) {
    (*this)(list.size());
  }
  template <class T>
  void transfer_size(const std::optional<T>& value) {
    (*this)(static_cast<std::uint8_t>(value ? 1 : 0));
  }

 private:
  std::vector<char> bytes_;
};

/// Message that is read: message(value, ...) assigns the next values. They must have the types and the order
/// in which an OutgoingMessage wrote them. Throws DataError if the bytes are too few or damaged.
class IncomingMessage {
 public:
  explicit IncomingMessage(std::vector<char> bytes) : bytes_(std::move(bytes)) {}

  template <class... T>
  void operator()(T&... values) {
    (transfer_value(*this, values), ...);
  }

  bool is_at_end() const { return read_ == bytes_.size(); }
  std::size_t bytes_left() const { return bytes_.size() - read_; }

  // For transfer_value().

  void copy(void* to, std::size_t size) {
    require_bytes(size);
    std::memcpy(to, bytes_.data() + read_, size);
    read_ += size;
  }
  template <class T>
  void transfer_size(std::vector<T>& list) {
    std::size_t size = 0;
    (*this)(size);
    require_bytes(size);
    list.resize(size);
  }
  template <class T>
  void transfer_size(std::optional<T>& value) {
    std::uint8_t has_value = 0;  // not bool, because a damaged file may contain any byte
    (*this)(has_value);
    if (has_value > 1) throw DataError("data from another rank or from a checkpoint are damaged");
    value.reset();
    if (has_value == 1) value.emplace();
  }

 private:
  void require_bytes(std::size_t size) const {
    if (size > bytes_left()) throw DataError("data from another rank or from a checkpoint end too early");
  }

  std::vector<char> bytes_;
  std::size_t read_ = 0;
};

/// Returns the values as bytes, one after the other.
template <class T>
std::vector<char> bytes_of(const std::vector<T>& values) {
  OutgoingMessage message;
  for (const T& value : values) message(value);
  return message.bytes();
}

/// Inverse of bytes_of(). Throws DataError if the bytes are not valid.
template <class T>
std::vector<T> values_from_bytes(std::vector<char> bytes) {
  std::vector<T> values;
  IncomingMessage message(std::move(bytes));
  while (!message.is_at_end()) message(values.emplace_back());
  return values;
}

}  // namespace beadswim
