#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

// A record is a struct that lists its fields once, in a static member function:
//
//   struct Load {
//     Vec3 force = Vec3::Zero();   ///< [mass length/time^2]
//     Vec3 torque = Vec3::Zero();  ///< about the centre [mass length^2/time^2]
//
//     static void visit_fields(auto&& visit, auto& load) {
//       visit("force", load.force);
//       visit("torque", load.torque);
//     }
//   };
//
// A visitor takes the name of a field, a reference to the field, and marks (below), which it may ignore. The
// names are the keys in JSON, in the same order. The list is used for messages between ranks, hashes and
// checkpoints (core/message.hpp), for JSON (io/fields_json.hpp) and for columns in HDF5 (io/columns.hpp).

namespace beadswim {

struct IgnoreField {
  void operator()(const char*, auto&, auto...) const {}
};

/// A struct that lists its fields; T may be const.
template <class T>
concept HasFields = requires(T& record) {
  std::remove_const_t<T>::visit_fields(IgnoreField{}, record);
};

template <HasFields Record>
void visit_fields(auto&& visit, Record& record) {
  std::remove_const_t<Record>::visit_fields(visit, record);
}

/// Mark of a field that JSON omits if it is an optional without value, an empty list or an empty text.
/// Without this mark, an optional without value is written as null.
struct OmittedIfNone {};
inline constexpr OmittedIfNone omitted_if_none;

/// Mark of a number that JSON omits if it is 0.
struct OmittedIfZero {};
inline constexpr OmittedIfZero omitted_if_zero;

/// Mark of a number that is written as null in JSON if it is infinite.
struct NullIfInfinite {};
inline constexpr NullIfInfinite null_if_infinite;

/// Mark of a field that is not written as a column in HDF5.
struct NotAColumn {};
inline constexpr NotAColumn not_a_column;

template <class Mark, class... Marks>
inline constexpr bool has_mark = (std::same_as<Mark, Marks> || ...);

template <class T>
inline constexpr bool is_record_array = false;
template <HasFields Record, std::size_t size>
inline constexpr bool is_record_array<std::array<Record, size>> = true;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// True if the number of bytes of a value in a message depends on the value.
template <class T>
inline constexpr bool varies_in_size = is_optional<T>;
template <class T>
inline constexpr bool varies_in_size<std::vector<T>> = true;

}  // namespace beadswim
