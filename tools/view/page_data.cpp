#include "page_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/io/base64.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/scene/swarm.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

/// Returns an HTML element that contains the values, encoded in base64.
template <class T>
std::string data_element(const std::string& id, const std::vector<T>& values) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, base64(values));
}

/// Returns an HTML element that contains the document as JSON. "<" is escaped, because it would begin a tag
/// in HTML.
std::string scene_element(const Json& document) {
  std::string text = dump_json_line(document);
  for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"scene\">" + text + "</script>\n";
}

// Quantisation stores a number as a 16-bit integer:  number = integer × step, |integer| <= 32767.

constexpr int max_steps = std::numeric_limits<std::int16_t>::max();
constexpr std::int16_t not_a_number = -32768;

/// Returns the smallest step with which every number up to the absolute value `largest` can be stored in 16
/// bits; 0 if `largest` is 0.
float smallest_step(double largest) {
  return std::nextafter(static_cast<float>(largest / max_steps), largest > 0 ? INFINITY : 0.F);
}

/// Returns number / step, rounded to the nearest integer, or `not_a_number` for NaN. The rounding error is at
/// most half a step.
std::int16_t round_to_steps(double number, float step) {
  const double steps = step > 0 ? std::round(number / step) : 0;
  if (std::isnan(number) || std::isnan(steps)) return not_a_number;
  return static_cast<std::int16_t>(std::clamp<double>(steps, -max_steps, max_steps));
}

/// Replaces bytes that are not valid UTF-8 in a file name.
std::string replace_invalid_utf8(const std::string& name) {
  return Json::parse(Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

/// Returns the indices of the beads at the two ends of a swimmer whose beads are in line at rest; null for
/// other shapes. The axis of the swimmer is along this line.
Json ends_of_line(const SwimmerType& type) {
  if (type.beads.size() < 2 || !is_straight(type)) return nullptr;
  const auto x = [](const BeadAtRest& bead) { return bead.at.x(); };
  const auto [first, last] = std::ranges::minmax_element(type.beads, {}, x);
  return {first - type.beads.begin(), last - type.beads.begin()};
}

Json shape_to_json(const SwimmerType& type) {
  Json bonds = Json::array(), angles = Json::array();
  for (const Bond& bond : type.bonds) bonds.push_back(bond.beads);
  for (const Angle& angle : type.angles) angles.push_back(angle.beads);
  return {{"beads", type.beads.size()}, {"bonds", bonds}, {"angles", angles}, {"line", ends_of_line(type)}};
}

std::size_t count_bonds(const TrajectoryFile& file) {
  std::size_t bonds = 0;
  for (std::size_t s = 0; s < file.in_layout.size(); ++s) bonds += file.type(s).bonds.size();
  return bonds;
}

/// Returns the walls: the axis across each, and its coordinate along this axis.
Json walls_of(const Domain& domain) {
  Json walls = Json::array();
  const auto add = [&](int axis, double at) { walls.push_back({{"axis", axis}, {"at", at}}); };
  if (domain.half_space) add(domain.half_space->axis, 0);
  for (int axis = 0; axis < 3 && domain.box; ++axis) {
    if (domain.box->is_periodic(axis)) continue;
    add(axis, 0);
    add(axis, domain.box->lengths[axis]);
  }
  return walls;
}

Json flow_to_json(const FlowArrows& flow) {
  Json json{{"arrows", flow.places.size()}, {"spacing", flow.spacing}, {"mean_cycles", nullptr}};
  if (flow.mean_cycles) json["mean_cycles"] = *flow.mean_cycles;
  return json;
}

/// Returns the content of the HTML element "scene": data about file, box, swimmers, frames and cycles.
Json scene_to_json(const TrajectoryFile& file, const std::vector<std::size_t>& frames,
                   const std::vector<TrajectoryCycle>& cycles, const PageOptions& options) {
  const TrajectoryHeader& header = file.reader.header();
  const Layout& layout = file.layout;
  const std::vector<Layer> layers = swimmer_layers(layout);
  const double period = file.period();
  Json scene{{"file", replace_invalid_utf8(file.source.substr(file.source.rfind('/') + 1))},
             {"version", header.creator_version},
             {"length_unit", length_unit(layout.units)},
             {"velocity_unit", velocity_unit(layout.units)},
             {"period", period},
             {"space", in_words(layout.domain)},
             {"box", nullptr},
             {"periodic", std::vector<bool>(3)},
             {"walls", walls_of(layout.domain)},
             {"flow", options.flow ? flow_to_json(*options.flow) : Json()}};
  if (const auto& box = layout.domain.box) {
    scene["box"] = std::vector<double>(box->lengths.begin(), box->lengths.end());
    scene["periodic"] = {box->is_periodic(0), box->is_periodic(1), box->is_periodic(2)};
  }
  Json shapes = Json::array();
  std::map<std::string, std::size_t> shape_of;
  for (const auto& [name, type] : layout.types) {
    shape_of[name] = shapes.size();
    shapes.push_back(shape_to_json(type));
  }
  Json ids = Json::array(), shape = Json::array(), blocks = Json::array(), times = Json::array(),
       cycle_times = Json::array();
  for (const std::size_t index : file.in_layout) {
    const Swimmer& swimmer = layout.swimmers[index];
    ids.push_back(swimmer.id);
    shape.push_back(shape_of.at(swimmer.type));
    blocks.push_back(block_number(swimmer.id, layers[index], options.block_swimmers));
  }
  const std::vector<double> all_times = file.reader.times();
  for (const std::size_t frame : frames) times.push_back(all_times[frame] / period);
  for (const TrajectoryCycle& cycle : cycles) cycle_times.push_back(cycle.time / period);
  scene.update(Json{{"shapes", shapes},
                    {"ids", ids},
                    {"shape", shape},
                    {"blocks", blocks},
                    {"times", times},
                    {"cycle_times", cycle_times}});
  return scene;
}

std::vector<std::size_t> swimmers_of_beads(const TrajectoryHeader& header) {
  std::vector<std::size_t> swimmers;
  std::size_t begun = 0;
  for (const int bead : header.bead) {
    if (bead == 1) ++begun;
    swimmers.push_back(begun - 1);
  }
  return swimmers;
}

/// Returns for each swimmer the step with which displacements are stored as integers [length]. With this
/// step, the largest displacement of its beads since the first frame, along any axis, fits into 16 bits.
std::vector<float> swimmer_steps(const TrajectoryFile& file, const std::vector<std::size_t>& frames,
                                 const TrajectoryFrame& first) {
  const std::vector<std::size_t> swimmer = swimmers_of_beads(file.reader.header());
  std::vector<double> largest(file.reader.header().swimmers(), 0);
  for (const std::size_t index : frames) {
    const TrajectoryFrame frame = file.reader.frame(index);
    for (std::size_t b = 0; b < first.positions.size(); ++b) {
      const double displacement = (frame.positions[b] - first.positions[b]).cwiseAbs().maxCoeff();
      largest[swimmer[b]] = std::max(largest[swimmer[b]], displacement);
    }
  }
  std::vector<float> steps;
  for (const double displacement : largest) steps.push_back(smallest_step(displacement));
  return steps;
}

/// Returns the displacements of all beads since the first frame, as integer multiples of their steps.
/// `steps`: one per bead [length].
std::vector<std::int16_t> quantised_displacements(const TrajectoryFrame& frame, const TrajectoryFrame& first,
                                                  const std::vector<float>& steps) {
  std::vector<std::int16_t> flat;
  flat.reserve(3 * frame.positions.size());
  for (std::size_t b = 0; b < frame.positions.size(); ++b) {
    const Vec3 displacement = frame.positions[b] - first.positions[b];
    for (int a = 0; a < 3; ++a) flat.push_back(round_to_steps(displacement[a], steps[b]));
  }
  return flat;
}

/// Returns the elements of a table with one row per cycle, in which a swimmer that has not completed a cycle
/// has NaN. Each column has the smallest step that can store its largest number.
std::string cycle_elements(const std::string& name, const std::vector<double>& rows, std::size_t columns) {
  std::vector<double> largest(columns, 0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    largest[i % columns] = std::fmax(largest[i % columns], std::abs(rows[i]));
  std::vector<float> steps;
  for (const double number : largest) steps.push_back(smallest_step(number));
  std::vector<std::int16_t> values;
  for (std::size_t i = 0; i < rows.size(); ++i) values.push_back(round_to_steps(rows[i], steps[i % columns]));
  return data_element("cycle-" + name + "-step", steps) + data_element("cycle-" + name, values);
}

/// Appends one number per bond of a swimmer to a row of a table.
void append_bonds(const std::vector<double>& numbers, std::size_t bonds, std::vector<double>& row) {
  for (std::size_t bond = 0; bond < bonds; ++bond)
    row.push_back(bond < numbers.size() ? numbers[bond] : std::numeric_limits<double>::quiet_NaN());
}

std::string all_cycle_elements(const std::vector<TrajectoryCycle>& cycles, const TrajectoryFile& file) {
  const std::size_t swimmers = file.in_layout.size(), bonds = count_bonds(file);
  std::vector<double> velocity, amplitudes, phases;
  for (const TrajectoryCycle& cycle : cycles) {
    const auto records = records_of<CycleStatistics>(cycle.columns, swimmers);
    for (std::size_t s = 0; s < swimmers; ++s) {
      velocity.push_back(velocity_relative_to_fluid(records[s], file.layout.domain.box));
      append_bonds(records[s].arm_amplitudes, file.type(s).bonds.size(), amplitudes);
      append_bonds(records[s].arm_phases, file.type(s).bonds.size(), phases);
    }
  }
  return cycle_elements("velocity", velocity, swimmers) + cycle_elements("amplitude", amplitudes, bonds) +
         cycle_elements("phase", phases, bonds);
}

}  // namespace

std::vector<std::size_t> select_frames(std::size_t frames, std::size_t every) {
  std::vector<std::size_t> shown;
  for (std::size_t frame = 0; frame < frames; frame += every) shown.push_back(frame);
  if (shown.back() != frames - 1) shown.push_back(frames - 1);
  return shown;
}

std::string page_data(const TrajectoryFile& file, const PageOptions& options) {
  const std::vector<std::size_t> frames = select_frames(file.reader.frames(), options.every);
  const std::vector<TrajectoryCycle> cycles = file.reader.cycles(columns_of<CycleStatistics>({}));
  const TrajectoryHeader& header = file.reader.header();
  const TrajectoryFrame first = file.reader.frame(frames.front());
  const std::vector<float> steps = swimmer_steps(file, frames, first);
  std::vector<float> bead_steps;
  for (const std::size_t swimmer : swimmers_of_beads(header)) bead_steps.push_back(steps[swimmer]);
  std::string text = scene_element(scene_to_json(file, frames, cycles, options));
  text += data_element("radius", std::vector<float>(header.radius.begin(), header.radius.end()));
  text += data_element("start", flattened(first.positions)) + data_element("step", steps);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    text += data_element(fmt::format("frame-{}", f),
                         quantised_displacements(file.reader.frame(frames[f]), first, bead_steps));
  }
  if (options.flow) {
    text += data_element("flow-place", flattened(options.flow->places)) +
            data_element("flow-velocity", flattened(options.flow->velocities));
  }
  return text + all_cycle_elements(cycles, file);
}

double expected_bytes(const TrajectoryFile& file, const PageOptions& options) {
  const auto beads = static_cast<double>(file.reader.header().radius.size());
  const auto frames = static_cast<double>(select_frames(file.reader.frames(), options.every).size());
  const double cycles = file.reader.times().back() / file.period();
  const auto swimmers = static_cast<double>(file.in_layout.size());
  const double columns = swimmers + 2 * static_cast<double>(count_bonds(file));
  const auto arrows = static_cast<double>(options.flow ? options.flow->places.size() : 0);
  const double bytes = beads * (16 + 6 * frames) + swimmers * 4 + columns * (4 + 2 * cycles) + arrows * 24;
  return bytes * 4 / 3;
}

}  // namespace beadswim
