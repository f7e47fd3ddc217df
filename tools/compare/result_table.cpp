#include "result_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "beadswim/core/csv.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/results.hpp"
#include "beadswim/tools/program.hpp"
#include "comparison_inputs.hpp"

namespace beadswim {
namespace {

std::vector<RunFile> read_runs(const std::vector<std::string>& files) {
  ReadDocuments read = read_documents(files, "a run record", run_from_json);
  report_left_out("beadswim-compare", read.failures, read.count());
  std::vector<RunFile> runs;
  for (SourceDocument& file : read.documents)
    runs.push_back({file.source, std::get<RunRecord>(std::move(file.document))});
  return runs;
}

/// Throws InputError if the run has failed, or has other units than the first one.
void require_usable(const RunFile& run, const RunFile& first) {
  require_success(run.record, run.source);
  if (run.record.units != first.record.units)
    throw InputError(
        run.source,
        "the units of this file differ from the units of {}; all runs of a table must have the same units",
        first.source);
}

/// Returns the names of the quantities in the studies of the runs, in order.
std::vector<std::string> studied(const std::vector<RunFile>& runs) {
  std::set<std::string> names;
  for (const RunFile& run : runs) {
    const Json study = run.record.study.value_or(Json::object());
    for (const auto& [name, value] : study.items()) names.insert(name);
  }
  return {names.begin(), names.end()};
}

/// Returns the first fields of the rows of a run.
std::vector<std::string> names_of(const RunFile& run, const std::vector<std::string>& variables) {
  std::vector<std::string> names{quoted(run.source)};
  const Json study = run.record.study.value_or(Json::object());
  for (const std::string& variable : variables) {
    const Json value = study.value(variable, Json());
    names.push_back(value.is_string() ? quoted(value.get<std::string>())
                    : value.is_null() ? ""
                                      : value.dump());
  }
  return names;
}

/// A number of a quantity.
struct TableColumn {
  ResultQuantity quantity;
  std::size_t number;
  std::string name;  ///< with the unit
};

/// Returns the columns of all quantities; those of arms have one per arm of the swimmer that has most.
std::vector<TableColumn> columns_of(const std::vector<RunFile>& runs) {
  std::size_t arms = 0;
  for (const RunFile& run : runs)
    for (const SwimmerRecord& swimmer : run.record.swimmers)
      for (const CycleStatistics& cycle : swimmer.cycles) arms = std::max(arms, cycle.arm_amplitudes.size());
  std::vector<TableColumn> columns;
  for (const ResultRow& row : result_rows) {
    const std::string unit = unit_of(row.quantity, runs.front().record.units);
    for (std::size_t i = 0; i < (row.is_per_arm ? arms : 1); ++i)
      columns.push_back(
          {.quantity = row.quantity,
           .number = i,
           .name = fmt::format("{}{}{}", row.name, row.is_per_arm ? fmt::format("_{}", i + 1) : "",
                               unit.empty() ? "" : fmt::format(" ({})", unit))});
  }
  return columns;
}

std::string field_of(const Results& results, const TableColumn& column) {
  const auto number = number_of(results, column.quantity, column.number);
  return number ? fmt::format("{}", *number) : "";
}

/// Returns the lines of a run. `first_fields`: of each line.
std::string lines_of(const RunFile& run, const std::vector<std::string>& first_fields,
                     const std::vector<TableColumn>& columns, std::optional<int> swimmer) {
  std::map<int, std::string> types;
  if (run.record.scene)
    for (const Swimmer& placed : run.record.scene->swimmers) types[placed.id] = quoted(placed.type);
  const SwimmerRecord* only = swimmer ? &find_swimmer(run.record, swimmer, run.source) : nullptr;
  std::string lines;
  for (const SwimmerRecord& each : run.record.swimmers) {
    if (only != nullptr && only != &each) continue;
    for (const CycleStatistics& cycle : each.cycles) {
      const CycleChoice choice{CycleChoice::Kind::index, cycle.index};
      const Results results = results_of(run.record, each, choice, run.source);
      std::vector<std::string> fields = first_fields;
      fields.insert(fields.end(),
                    {fmt::format("{}", each.id), types[each.id], fmt::format("{}", cycle.index)});
      for (const TableColumn& column : columns) fields.push_back(field_of(results, column));
      lines += joined(fields, ",") + "\n";
    }
  }
  return lines;
}

}  // namespace

std::string result_table(const std::vector<std::string>& files, std::optional<int> swimmer) {
  const std::vector<RunFile> runs = read_runs(files);
  const bool is_several = runs.size() > 1;
  for (const RunFile& run : runs) require_usable(run, runs.front());
  const std::vector<std::string> variables = is_several ? studied(runs) : std::vector<std::string>();
  const std::vector<TableColumn> columns = columns_of(runs);
  std::vector<std::string> header;
  if (is_several) header.emplace_back("run");
  for (const std::string& variable : variables) header.push_back(quoted(variable));
  header.insert(header.end(), {"swimmer", "type", "cycle"});
  for (const TableColumn& column : columns) header.push_back(quoted(column.name));
  std::string lines;
  for (const RunFile& run : runs)
    lines +=
        lines_of(run, is_several ? names_of(run, variables) : std::vector<std::string>(), columns, swimmer);
  if (lines.empty()) select_cycles({}, {}, runs.front().source);  // throws
  return joined(header, ",") + "\n" + lines;
}

}  // namespace beadswim
