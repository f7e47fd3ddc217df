#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/json.hpp"

// Conversion between JSON and records (structs that list their fields in visit_fields, core/fields.hpp). To
// write a record, assign it to a Json. To read it, call json.get<Record>(). The JSON must have been validated
// against its schema before it is read.

namespace beadswim {

template <class T>
bool has_value(const T& field) {
  if constexpr (requires { field.empty(); }) {
    return !field.empty();
  } else {
    return field.has_value();
  }
}

/// Appends the fields of a record to a JSON object.
template <HasFields Record>
void add_fields(Json& json, const Record& record) {
  visit_fields(
      [&]<class Field, class... Marks>(const char* name, const Field& field, Marks...) {
        if constexpr (has_mark<OmittedIfNone, Marks...>) {
          if (!has_value(field)) return;
        }
        if constexpr (has_mark<OmittedIfZero, Marks...>) {
          if (field == 0) return;
        }
        json[name] = field;
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

/// Reads a record from a JSON object. A key may be missing if its field is a std::optional or has the mark
/// omitted_if_none or omitted_if_zero. The field then keeps its previous value.
template <HasFields Record>
void from_json(const Json& json, Record& record) {
  visit_fields(
      [&]<class Field, class... Marks>(const char* name, Field& field, Marks...) {
        if constexpr (is_optional<Field> || has_mark<OmittedIfNone, Marks...> ||
                      has_mark<OmittedIfZero, Marks...>) {
          const auto found = json.find(name);
          if (found != json.end()) found->get_to(field);
        } else if (has_mark<NullIfInfinite, Marks...> && json.at(name).is_null()) {
          field = std::numeric_limits<Field>::infinity();
        } else {
          json.at(name).get_to(field);
        }
      },
      record);
}

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
