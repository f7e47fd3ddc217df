#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "beadswim/core/box.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/json.hpp"

// Conversion between JSON and records (structs that list their fields, core/fields.hpp). To
// write a record, assign it to a Json. To read it, call json.get<Record>(). The JSON must have been validated
// against its schema before it is read.

namespace beadswim {

/// Returns true if JSON output omits a field with this mark.
bool is_omitted(const auto& /*field*/, auto /*mark*/) {
  return false;
}
template <class T>
bool is_omitted(const T& field, OmittedIfNone) {
  if constexpr (std::same_as<T, Json>) {
    return field.is_null();
  } else if constexpr (requires { field.empty(); }) {
    return field.empty();
  } else {
    return !field.has_value();
  }
}
template <class T>
bool is_omitted(const auto& field, const OmittedIf<T>& mark) {
  return field == mark.value;
}
bool is_omitted(const auto& /*field*/, OmittedWhen mark) {
  return mark.is_omitted;
}

inline int add_to_indices(int index, int number) {
  return index + number;
}
template <std::size_t size>
std::array<int, size> add_to_indices(std::array<int, size> indices, int number) {
  for (int& index : indices) index += number;
  return indices;
}

/// Returns the unit vector along a vector of any finite length. Zero and unit vectors stay as they are.
inline Vec3 unit_vector(const Vec3& vector) {
  constexpr double roundoff = 1e-15;  // of the norm of a unit vector
  const double largest = vector.cwiseAbs().maxCoeff();
  if (largest == 0 || std::abs(vector.norm() - 1) <= roundoff) return vector;
  return (vector / largest).normalized();  // the squares of the vector itself could underflow or overflow
}

inline std::optional<Vec3> unit_vector(const std::optional<Vec3>& vector) {
  return vector ? std::optional(unit_vector(*vector)) : std::nullopt;
}

/// Appends the fields of a record to a JSON object.
template <HasFields Record>
void add_fields(Json& json, const Record& record) {
  visit_fields(
      [&]<class Field, class... Marks>(const char* name, const Field& field, const Marks&... marks) {
        if ((is_omitted(field, marks) || ...)) return;
        if constexpr (has_mark<CountedFromOne, Marks...>) {
          json[name] = add_to_indices(field, 1);
        } else {
          json[name] = field;
        }
        if constexpr (has_mark<NullIfInfinite, Marks...>) {
          if (std::isinf(field)) json[name] = nullptr;
        }
      },
      record);
}

template <HasFields Record>
void to_json(Json& json, const Record& record) {
  json = Json::object();
  add_fields(json, record);
}

/// Reads the fields of a record that a JSON object contains. Other fields keep their values: those of the
/// record before the call, for example defaults, or the driving that an object overrides.
template <HasFields Record>
void from_json(const Json& json, Record& record) {
  visit_fields(
      [&]<class Field, class... Marks>(const char* name, Field& field, const Marks&...) {
        const auto found = json.find(name);
        if (found == json.end()) return;
        if constexpr (has_mark<NullIfInfinite, Marks...>) {
          field = found->is_null() ? std::numeric_limits<Field>::infinity() : found->template get<Field>();
        } else {
          found->get_to(field);
        }
        if constexpr (has_mark<CountedFromOne, Marks...>) field = add_to_indices(field, -1);
        if constexpr (has_mark<OfUnitLength, Marks...>) field = unit_vector(field);
      },
      record);
}

// The JSON of domains and boxes has another form than their fields. A domain is null, a box or
// {"half_space": {"axis": "z", "boundary": "no-slip"}}. An axis with walls that move has the boundary
// {"no-slip": {"lower_velocity": [..], "upper_velocity": [..]}}, every other axis a name.

void to_json(Json& json, const Box& box);
void from_json(const Json& json, Box& box);
void to_json(Json& json, const Domain& domain);
void from_json(const Json& json, Domain& domain);

}  // namespace beadswim

template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
  static void to_json(beadswim::Json& json, const std::optional<T>& value) {
    json = value ? beadswim::Json(*value) : beadswim::Json(nullptr);
  }
  static void from_json(const beadswim::Json& json, std::optional<T>& value) {
    if (json.is_null()) {
      value.reset();
    } else {
      json.get_to(value.emplace());
    }
  }
};

template <>
struct nlohmann::adl_serializer<beadswim::Vec3> {
  static void to_json(beadswim::Json& json, const beadswim::Vec3& vector) {
    json = {vector.x(), vector.y(), vector.z()};
  }
  static void from_json(const beadswim::Json& json, beadswim::Vec3& vector) {
    for (int a = 0; a < 3; ++a) json.at(a).get_to(vector[a]);
  }
};

template <>
struct nlohmann::adl_serializer<Eigen::Matrix3d> {
  static void to_json(beadswim::Json& json, const Eigen::Matrix3d& matrix) {
    json = beadswim::Json::array();
    for (int row = 0; row < 3; ++row) json.push_back(beadswim::Vec3(matrix.row(row)));
  }
  static void from_json(const beadswim::Json& json, Eigen::Matrix3d& matrix) {
    for (int row = 0; row < 3; ++row) matrix.row(row) = json.at(row).get<beadswim::Vec3>();
  }
};

/// A quaternion is the list of its components w, x, y, z.
template <>
struct nlohmann::adl_serializer<Eigen::Quaterniond> {
  static void to_json(beadswim::Json& json, const Eigen::Quaterniond& q) {
    json = {q.w(), q.x(), q.y(), q.z()};
  }
  static void from_json(const beadswim::Json& json, Eigen::Quaterniond& quaternion) {
    const auto [w, x, y, z] = json.get<std::array<double, 4>>();
    quaternion = {w, x, y, z};
  }
};
