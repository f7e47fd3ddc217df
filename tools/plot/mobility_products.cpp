#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/figure/figure.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/io/schema.hpp"
#include "kinds.hpp"

namespace beadswim {
namespace {

Json read_products(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  const Json document = parse_json(read_text(path), source);
  validate_json(document, "bench", source);
  if (!document.contains("mobility_products"))
    throw InputError(source, "has no mobility_products; make it with beadswim-bench --json --beads N,...");
  return document;
}

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

Figure product_figure(const std::vector<std::string>& files) {
  Panel panel{.x_label = {"beads"},
              .y_label = {"time of a product", "s"},
              .x_scale = ScaleKind::logarithmic,
              .y_scale = ScaleKind::logarithmic};
  Figure figure{.title = "Velocities of beads by forces on all", .panels = {}};
  for (const std::string& file : files) {
    const Json document = read_products(file);
    for (const Json& row : document.at("mobility_products")) {
      const int ranks = row.at("ranks").get<int>();
      const std::string where = row.at("surroundings") == "open" ? "open space" : "periodic box";
      Series& series = series_named(fmt::format("{}, {} rank{}", where, ranks, ranks == 1 ? "" : "s"), panel);
      series.x.push_back(row.at("beads").get<double>());
      series.y.push_back(row.at("seconds").get<double>());
    }
    const auto& rows = document.at("mobility_products");
    if (rows.empty() || !document.contains("processor")) continue;
    figure.notes.push_back(fmt::format("{}, {}; tolerance {:g}", document.at("processor").get<std::string>(),
                                       document.value("instruction_set", ""),
                                       rows.front().at("tolerance").get<double>()));
  }
  figure.panels.push_back(panel);
  return figure;
}

}  // namespace

Drawing add_product_flags(CLI::App&) {
  return [](const PlotFiles& files) { return figure_to_svg(product_figure(files.inputs)); };
}

}  // namespace beadswim
