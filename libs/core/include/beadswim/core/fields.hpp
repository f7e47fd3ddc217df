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
// The function visit_fields calls visit(name, field, marks...) once per field, in the order of the list: with
// the name of the field, a reference to the field, and optional marks. A mark is a small struct, defined
// below, that changes how some visitors treat the field; other visitors ignore it.
//
// This one list of fields determines the keys of JSON objects (io/fields_json.hpp), the contents of
// checkpoints and of messages between ranks (core/message.hpp), and the columns in HDF5 files
// (io/columns.hpp).

namespace beadswim {

struct IgnoreField {
  void operator()(const char*, auto&, auto...) const {}
};

/// Is satisfied by a struct whose static member function visit_fields lists its fields. T may be const.
template <class T>
concept HasFields = requires(T& record) {
  std::remove_const_t<T>::visit_fields(IgnoreField{}, record);
};

/// Calls visit(name, field, marks...) for each field of the record, in the order of its list of fields.
template <HasFields Record>
void visit_fields(auto&& visit, Record& record) {
  std::remove_const_t<Record>::visit_fields(visit, record);
}

/// Mark of a field in visit_fields: JSON output omits the field if it is an optional without value, an empty
/// list or an empty text. Without this mark, an optional without value is written as null.
struct OmittedIfNone {};
inline constexpr OmittedIfNone omitted_if_none;

/// Mark of a field in visit_fields: JSON output omits the field if it has this value.
template <class T>
struct OmittedIf {
  T value;
};
constexpr auto omitted_if(auto value) {
  return OmittedIf<decltype(value)>{value};
}

/// Mark of a field in visit_fields: JSON output omits the field if `is_omitted` is true.
struct OmittedWhen {
  bool is_omitted = false;
};
constexpr OmittedWhen omitted_when(bool is_omitted) {
  return {is_omitted};
}

/// Mark of an index, or of an array of indices, in visit_fields: JSON contains the indices plus 1.
struct CountedFromOne {};
inline constexpr CountedFromOne counted_from_one;

/// Mark of a unit vector in visit_fields: JSON input may contain a vector of any length.
struct OfUnitLength {};
inline constexpr OfUnitLength of_unit_length;

/// Mark of a number in visit_fields: JSON output contains null if the number is infinite.
struct NullIfInfinite {};
inline constexpr NullIfInfinite null_if_infinite;

/// Mark of a field in visit_fields: HDF5 files do not contain the field as a column.
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

/// True for types such as std::optional and std::vector: the number of bytes that a value occupies in a
/// message depends on the value.
template <class T>
inline constexpr bool varies_in_size = is_optional<T>;
template <class T>
inline constexpr bool varies_in_size<std::vector<T>> = true;

}  // namespace beadswim
