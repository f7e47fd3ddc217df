#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

// A record lists its fields once, in a static member function beside them:
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
// A visitor takes the name of a field, a reference to it, and marks (below) that it may ignore. Names and
// order are those of the keys in JSON. The list serves messages between ranks, hashes and checkpoints
// (core/message.hpp), JSON (io/fields_json.hpp) and columns in HDF5 (io/columns.hpp).

namespace beadswim {

struct IgnoreField {
  void operator()(const char*, auto&, auto...) const {}
};

/// A struct, const or not, that lists its fields.
template <class T>
concept HasFields = requires(T& record) {
  std::remove_const_t<T>::visit_fields(IgnoreField{}, record);
};

template <HasFields Record>
void visit_fields(auto&& visit, Record& record) {
  std::remove_const_t<Record>::visit_fields(visit, record);
}

/// Mark of a field whose key is missing in JSON where an optional has no value, or a list or text is empty.
/// Without it the key of an optional is null.
struct OmittedIfNone {};
inline constexpr OmittedIfNone omitted_if_none;

/// Mark of a number whose key is missing in JSON where it is 0.
struct OmittedIfZero {};
inline constexpr OmittedIfZero omitted_if_zero;

/// Mark of a number that is null in JSON where it is infinite.
struct NullIfInfinite {};
inline constexpr NullIfInfinite null_if_infinite;

/// Mark of a field that is no column in HDF5.
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

/// Whether values of the type take different numbers of bytes.
template <class T>
inline constexpr bool varies_in_size = is_optional<T>;
template <class T>
inline constexpr bool varies_in_size<std::vector<T>> = true;

}  // namespace beadswim
