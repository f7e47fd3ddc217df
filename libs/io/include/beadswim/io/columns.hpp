#pragma once

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

// Conversion between records (structs that list their fields, core/fields.hpp) and columns of
// numbers. A field that becomes a column is a double, a Vec3, an array or a vector of doubles, or has data()
// and size() as they have, or is an optional one of these, which without a value is NaN. Other fields must
// have the mark not_a_column. Vectors may have different lengths in different records: the
// columns are as wide as those of an example, and NaN stands where a record has no number.

namespace beadswim {

/// Values of one field of several records.
struct Column {
  std::string name;
  std::vector<hsize_t> shape;   ///< shape of the field in one record: {} or {components}
  std::vector<double> numbers;  ///< values of all components of record 0, then of record 1, ...
};

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::span<double> numbers_of(auto& field) {
  if constexpr (requires { field.has_value(); }) {
    if (!field) std::ranges::fill(numbers_of(field.emplace()), no_number);
    return numbers_of(*field);
  } else if constexpr (requires { field.data(); }) {
    return {field.data(), static_cast<std::size_t>(field.size())};
  } else {
    return {&field, 1};
  }
}

/// Calls handle(name, field) for each field of the record that becomes a column.
template <HasFields Record>
void visit_columns(auto&& handle, Record& record) {
  visit_fields(
      [&]<class Field, class... Marks>(const char* name, Field& field, Marks...) {
        if constexpr (!has_mark<NotAColumn, Marks...>) handle(name, field);
      },
      record);
}

/// Calls handle(column, numbers) for each column and the values of its field in the record.
template <HasFields Record>
void visit_columns(auto& columns, Record& record, auto&& handle) {
  auto column = columns.begin();
  visit_columns([&](const char*, auto& field) { handle(*column++, numbers_of(field)); }, record);
}

/// Converts records to columns that are as wide as the fields of `example` and of all records. If there are
/// no records, the columns contain no numbers.
template <HasFields Record>
std::vector<Column> columns_of(std::vector<Record> records, Record example = {}) {
  std::vector<Column> columns;
  visit_columns(
      [&]<class Field>(const char* name, Field& field) {
        std::vector<hsize_t> shape{numbers_of(field).size()};
        if (std::same_as<Field, double>) shape.clear();
        columns.push_back({.name = name, .shape = std::move(shape), .numbers = {}});
      },
      example);
  for (Record& record : records)
    visit_columns(columns, record, [](Column& column, std::span<double> numbers) {
      if (!column.shape.empty()) column.shape[0] = std::max<hsize_t>(column.shape[0], numbers.size());
    });
  for (Record& record : records)
    visit_columns(columns, record, [](Column& column, std::span<double> numbers) {
      const std::size_t width = column.shape.empty() ? 1 : column.shape[0];
      column.numbers.insert(column.numbers.end(), numbers.begin(), numbers.end());
      column.numbers.resize(column.numbers.size() + width - numbers.size(), no_number);
    });
  return columns;
}

/// Converts columns to `count` records. Vectors are as wide as their column. Fields with the mark
/// not_a_column keep their default values.
template <HasFields Record>
std::vector<Record> records_of(const std::vector<Column>& columns, std::size_t count) {
  std::vector<Record> records(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto column = columns.begin();
    visit_columns(
        [&]<class Field>(const char*, Field& field) {
          if constexpr (std::same_as<Field, std::vector<double>>) field.resize(column->shape[0]);
          const std::span<double> numbers = numbers_of(field);
          std::copy_n(column->numbers.begin() + i * numbers.size(), numbers.size(), numbers.begin());
          if constexpr (requires { field.reset(); })
            if (std::ranges::all_of(numbers, [](double x) { return std::isnan(x); })) field.reset();
          ++column;
        },
        records[i]);
  }
  return records;
}

/// Returns a record in which all numbers that become columns are NaN.
template <HasFields Record>
Record record_of_nan() {
  Record record;
  visit_columns([](const char*, auto& field) { std::ranges::fill(numbers_of(field), no_number); }, record);
  return record;
}

}  // namespace beadswim
