#pragma once

#include <array>
#include <boost/preprocessor/punctuation/remove_parens.hpp>
#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

// A record is a struct that lists its fields once:
//
//   struct Load {
//     Vec3 force = Vec3::Zero();   ///< [mass length/time^2]
//     Vec3 torque = Vec3::Zero();  ///< about the centre [mass length^2/time^2]
//
//     BEADSWIM_FIELDS(force, torque)
//   };
//
// The list becomes a static member function visit_fields, which calls visit(name, field, marks...) once per
// field, in the order of the list: with the name of the field, a reference to the field, and optional marks.
// A mark is a small struct, defined below, that changes how some visitors treat the field; other visitors
// ignore it. A field with marks stands in brackets: (torque, omitted_if_none). A record whose names differ
// from its members defines visit_fields itself.
//
// This one list of fields determines the keys of JSON objects (io/fields_json.hpp), the contents of
// checkpoints and of messages between ranks (core/message.hpp), and the columns in HDF5 files
// (io/columns.hpp).

#define BEADSWIM_FIELDS(...)                                                       \
  static void visit_fields(auto&& visit, auto& record) {                           \
    BOOST_PP_SEQ_FOR_EACH(BEADSWIM_FIELD, , BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__)) \
  }
#define BEADSWIM_FIELD(r, data, field) BEADSWIM_EXPANDED_FIELD(BOOST_PP_REMOVE_PARENS(field))
#define BEADSWIM_EXPANDED_FIELD(...) BEADSWIM_VISIT(__VA_ARGS__)
#define BEADSWIM_VISIT(name, ...) visit(#name, record.name __VA_OPT__(, ) __VA_ARGS__);

namespace beadswim {

struct IgnoreField {
  void operator()(const char*, auto&, auto...) const {}
};

/// Is satisfied by a struct that lists its fields. T may be const.
template <class T>
concept HasFields = requires(T& record) {
  std::remove_const_t<T>::visit_fields(IgnoreField{}, record);
};

/// Calls visit(name, field, marks...) for each field of the record, in the order of its list of fields.
template <HasFields Record>
void visit_fields(auto&& visit, Record& record) {
  std::remove_const_t<Record>::visit_fields(visit, record);
}

/// Mark of a field: JSON output omits the field if it is an optional without value, an empty
/// list or an empty text. Without this mark, an optional without value is written as null.
struct OmittedIfNone {};
inline constexpr OmittedIfNone omitted_if_none;

/// Mark of a field: JSON output omits the field if it has this value.
template <class T>
struct OmittedIf {
  T value;
};
constexpr auto omitted_if(auto value) {
  return OmittedIf<decltype(value)>{value};
}

/// Mark of a field: JSON output omits the field if `is_omitted` is true.
struct OmittedWhen {
  bool is_omitted = false;
};
constexpr OmittedWhen omitted_when(bool is_omitted) {
  return {is_omitted};
}

/// Mark of an index, or of an array of indices: JSON contains the indices plus 1.
struct CountedFromOne {};
inline constexpr CountedFromOne counted_from_one;

/// Mark of a unit vector: JSON input may contain a vector of any length.
struct OfUnitLength {};
inline constexpr OfUnitLength of_unit_length;

/// Mark of a number: JSON output contains null if the number is infinite.
struct NullIfInfinite {};
inline constexpr NullIfInfinite null_if_infinite;

/// Mark of a field: HDF5 files do not contain the field as a column.
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
