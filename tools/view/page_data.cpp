#include "page_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "beadswim/compare/swimming.hpp"
#include "beadswim/io/base64.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/scene/layers.hpp"
#include "beadswim/scene/units.hpp"
#include "quantised.hpp"

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
  std::string text;
  for (const char c : dump_json_line(document)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return "<script type=\"application/json\" id=\"scene\">" + text + "</script>\n";
}

/// Replaces bytes that are not valid UTF-8 in a file name.
std::string replace_invalid_utf8(const std::string& name) {
  return Json::parse(Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
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
             {"box", nullptr},
             {"periodic", std::vector<bool>(3)}};
  if (const auto& box = layout.domain) {
    scene["box"] = std::vector<double>(box->lengths.begin(), box->lengths.end());
    scene["periodic"] = {box->is_periodic(0), box->is_periodic(1), box->is_periodic(2)};
  }
  Json ids = Json::array(), blocks = Json::array(), times = Json::array(), cycle_times = Json::array();
  for (const std::size_t index : file.in_layout) {
    const int id = layout.swimmers[index].id;
    ids.push_back(id);
    blocks.push_back(block_number(id, layers[index], options.block_swimmers));
  }
  const std::vector<double> all_times = file.reader.times();
  for (const std::size_t frame : frames) times.push_back(all_times[frame] / period);
  for (const TrajectoryCycle& cycle : cycles) cycle_times.push_back(cycle.time / period);
  scene.update(Json{{"ids", ids}, {"blocks", blocks}, {"times", times}, {"cycle_times", cycle_times}});
  return scene;
}

/// Returns for each swimmer the step with which displacements are stored as integers [length]. With this
/// step, the largest displacement of its beads since the first frame, along any axis, fits into 16 bits.
std::vector<float> swimmer_steps(const TrajectoryFile& file, const std::vector<std::size_t>& frames,
                                 const TrajectoryFrame& first) {
  std::vector<double> largest(first.positions.size() / 3, 0);
  for (const std::size_t index : frames) {
    const TrajectoryFrame frame = file.reader.frame(index);
    for (std::size_t b = 0; b < first.positions.size(); ++b) {
      const double displacement = (frame.positions[b] - first.positions[b]).cwiseAbs().maxCoeff();
      largest[b / 3] = std::max(largest[b / 3], displacement);
    }
  }
  std::vector<float> steps;
  for (const double displacement : largest) steps.push_back(smallest_step(displacement));
  return steps;
}

/// Returns the displacements of all beads since the first frame, as integer multiples of the steps of their
/// swimmers.
std::vector<std::int16_t> quantised_displacements(const TrajectoryFrame& frame, const TrajectoryFrame& first,
                                                  const std::vector<float>& steps) {
  std::vector<std::int16_t> flat;
  flat.reserve(3 * frame.positions.size());
  for (std::size_t b = 0; b < frame.positions.size(); ++b) {
    const Vec3 displacement = frame.positions[b] - first.positions[b];
    for (int a = 0; a < 3; ++a) flat.push_back(round_to_steps(displacement[a], steps[b / 3]));
  }
  return flat;
}

/// Function that returns one quantity of a swimmer in one cycle; NaN if the swimmer has not completed a cycle
/// yet.
using CycleQuantity = std::function<double(const CycleStatistics&)>;

std::string cycle_elements(const std::string& name, const std::vector<CycleStatistics>& cycles,
                           std::size_t swimmers, const CycleQuantity& number) {
  std::vector<double> rows;
  std::ranges::transform(cycles, std::back_inserter(rows), number);
  const QuantisedTable table = quantised(rows, swimmers);
  return data_element("cycle-" + name + "-step", table.steps) + data_element("cycle-" + name, table.values);
}

/// Returns the number of an arm; NaN if a file has none.
double number_of_arm(const std::vector<double>& numbers, std::size_t arm) {
  return arm < numbers.size() ? numbers[arm] : std::numeric_limits<double>::quiet_NaN();
}

std::string all_cycle_elements(const std::vector<TrajectoryCycle>& rows, const Layout& layout) {
  const std::size_t swimmers = layout.swimmers.size();
  std::vector<CycleStatistics> cycles;
  for (const TrajectoryCycle& row : rows)
    std::ranges::copy(records_of<CycleStatistics>(row.columns, swimmers), std::back_inserter(cycles));
  std::string text = cycle_elements("velocity", cycles, swimmers, [&](const CycleStatistics& cycle) {
    return velocity_relative_to_fluid(cycle, layout.domain);
  });
  for (const std::size_t arm : {0, 1}) {
    const std::string n = std::to_string(arm + 1);
    text += cycle_elements("arm" + n, cycles, swimmers, [=](const CycleStatistics& cycle) {
      return number_of_arm(cycle.arm_amplitudes, arm);
    });
    text += cycle_elements("phase" + n, cycles, swimmers, [=](const CycleStatistics& cycle) {
      return number_of_arm(cycle.arm_phases, arm);
    });
  }
  return text;
}

}  // namespace

std::vector<std::size_t> select_frames(std::size_t frames, std::size_t every) {
  std::vector<std::size_t> shown;
  for (std::size_t frame = 0; frame < frames; frame += every) shown.push_back(frame);
  if (shown.back() != frames - 1) shown.push_back(frames - 1);
  return shown;
}

std::string page_data(const TrajectoryFile& file, const PageOptions& options) {
  require_three_beads(file.layout, "beadswim-view shows", file.source);
  const std::vector<std::size_t> frames = select_frames(file.reader.frames(), options.every);
  const std::vector<TrajectoryCycle> cycles = file.reader.cycles(columns_of<CycleStatistics>({}));
  const TrajectoryHeader& header = file.reader.header();
  const TrajectoryFrame first = file.reader.frame(frames.front());
  const std::vector<float> steps = swimmer_steps(file, frames, first);
  std::string text = scene_element(scene_to_json(file, frames, cycles, options));
  text += data_element("radius", std::vector<float>(header.radius.begin(), header.radius.end()));
  text += data_element("start", flattened(first.positions)) + data_element("step", steps);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    text += data_element(fmt::format("frame-{}", f),
                         quantised_displacements(file.reader.frame(frames[f]), first, steps));
  }
  return text + all_cycle_elements(cycles, file.layout);
}

double expected_bytes(const TrajectoryFile& file, const PageOptions& options) {
  const auto beads = static_cast<double>(file.reader.header().radius.size());
  const auto frames = static_cast<double>(select_frames(file.reader.frames(), options.every).size());
  const double cycles = file.reader.times().back() / file.period();
  const double bytes = beads * (16 + 4.0 / 3 + 6 * frames) + beads / 3 * 5 * (4 + 2 * cycles);
  return bytes * 4 / 3;
}

}  // namespace beadswim
