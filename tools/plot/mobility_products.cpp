#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/figure/figure.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/io/schema.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

/// Reads measurements of beadswim-bench. Throws InputError if the file does not contain measurements of
/// mobility products.
Json read_products(const std::string& path) {
  const std::string source = source_name(path);
  const Json document = parse_json(read_text(path), source);
  validate_json(document, "bench", source);
  if (!document.contains("mobility_products"))
    throw InputError(source,
                     "the document has no key \"mobility_products\"; make a document with mobility products "
                     "by beadswim-bench --json --beads N,...");
  return document;
}

/// Returns the series of the panel that has this label. If there is none, adds an empty series with this
/// label first.
Series& series_named(const std::string& label, Panel& panel) {
  const auto found = std::ranges::find(panel.series, label, &Series::label);
  if (found != panel.series.end()) return *found;
  const int position = static_cast<int>(panel.series.size());
  panel.series.push_back({.label = label,
                          .mark = Mark::line_and_points,
                          .colour = position,
                          .shape = position,
                          .dash = position});
  return panel.series.back();
}

/// Returns a note for the figure that lists the processors and tolerances of all measurements.
Note measurements_note(const std::vector<Json>& documents) {
  std::set<std::string> processors;
  std::vector<double> tolerances;
  for (const Json& document : documents) {
    for (const Json& row : document.at("mobility_products"))
      tolerances.push_back(row.at("tolerance").get<double>());
    if (document.contains("processor"))
      processors.insert(fmt::format("{}, {}", document.at("processor").get<std::string>(),
                                    document.value("instruction_set", "")));
  }
  if (processors.empty() || tolerances.empty()) return {};
  const std::string tolerance = range_text(tolerances, 6);
  const std::string names =
      processors.size() == 1 ? *processors.begin() : fmt::format("{} processors", processors.size());
  return {.text = fmt::format("{}; tolerance {}", names, tolerance),
          .summary = fmt::format("tolerance {}", tolerance)};
}

Figure product_figure(const std::vector<std::string>& files) {
  Panel panel{.x_label = {"beads"},
              .y_label = {"time of a product", "s"},
              .x_scale = ScaleKind::logarithmic,
              .y_scale = ScaleKind::logarithmic};
  std::vector<Json> documents;
  for (const std::string& file : files) {
    documents.push_back(read_products(file));
    for (const Json& row : documents.back().at("mobility_products")) {
      const int ranks = row.at("ranks").get<int>();
      const std::string where = row.at("surroundings") == "open" ? "open space" : "periodic box";
      Series& series = series_named(fmt::format("{}, {} rank{}", where, ranks, ranks == 1 ? "" : "s"), panel);
      series.x.push_back(row.at("beads").get<double>());
      series.y.push_back(row.at("seconds").get<double>());
    }
  }
  return {.title = "Velocities of beads by forces on all",
          .panels = {std::move(panel)},
          .notes = {
              {.text = "A slope of one decade per decade means a time proportional to the number of beads."},
              measurements_note(documents)}};
}

}  // namespace

DrawFigure add_product_flags(CLI::App&) {
  return [](const PlotFiles& files) { return draw(product_figure(files.inputs)); };
}

}  // namespace beadswim
