#include "beadswim/documents/trajectory_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"

namespace beadswim {
namespace {

/// Throws InputError about contents that no run writes.
[[noreturn]] void refuse_edited(const std::string& place, const std::string& fault) {
  throw InputError(
      place, fault + "; the file is damaged or was edited: give a trajectory file as beadswim-run wrote it");
}

bool have_equal_lengths(const std::optional<Box>& a, const std::optional<Box>& b) {
  return a && b ? a->lengths == b->lengths : a.has_value() == b.has_value();
}

Layout layout_of(const TrajectoryReader& reader, const std::string& path) {
  const std::string place = path + ":/parameters/layout";
  Layout layout = layout_from_json(parse_json(reader.header().layout, place), place).layout;
  if (layout.swimmers.size() != reader.header().swimmers()) {
    refuse_edited(place, fmt::format("the layout in the file has {} swimmers, but the file contains the "
                                     "positions of {} swimmers",
                                     layout.swimmers.size(), reader.header().swimmers()));
  }
  if (!have_equal_lengths(reader.header().box, layout.domain.box)) {
    refuse_edited(path + ":/particles/beads/box/edges",
                  "the box of the first frame differs from the box of the layout that the file contains");
  }
  return layout;
}

/// Returns for each swimmer in the trajectory file its index in layout.swimmers.
std::vector<std::size_t> indices_in(const Layout& layout, const TrajectoryReader& reader,
                                    const std::string& path) {
  std::map<int, std::size_t> index_of;
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) index_of[layout.swimmers[s].id] = s;
  std::vector<std::size_t> indices;
  const std::vector<int>& of_bead = reader.header().swimmer;
  std::vector<std::size_t> first = reader.header().first_beads();
  first.push_back(of_bead.size());
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    const int id = of_bead[first[s]];
    const auto found = index_of.find(id);
    if (found == index_of.end()) {
      refuse_edited(path + ":/particles/beads/swimmer",
                    fmt::format("swimmer {} is not in the layout that the file contains, or occurs twice in "
                                "this dataset",
                                id));
    }
    if (first[s + 1] - first[s] != layout.types.at(layout.swimmers[found->second].type).beads.size()) {
      refuse_edited(
          path + ":/particles/beads/species",
          fmt::format("swimmer {} has another number of beads than in the layout that the file contains",
                      id));
    }
    indices.push_back(found->second);
    index_of.erase(found);
  }
  return indices;
}

/// Returns the number of cycles that a swimmer has completed after `base_cycles` cycles of the base period.
/// `period`: its driving period; nullopt: the base period.
int count_cycles(double base_period, std::size_t base_cycles, std::optional<double> period) {
  constexpr double roundoff = 1e-9;  // of quotients that are whole numbers
  const double cycles = static_cast<double>(base_cycles) * (period ? base_period / *period : 1);
  return static_cast<int>(cycles * (1 + roundoff));
}

}  // namespace

double TrajectoryFile::period() const {
  return layout.resolved_type(layout.swimmers.front()).driving.period;
}

std::vector<int> TrajectoryFile::swimmers() const {
  const std::vector<int>& of_bead = reader.header().swimmer;
  std::vector<int> ids;
  for (const std::size_t bead : reader.header().first_beads()) ids.push_back(of_bead[bead]);
  return ids;
}

const SwimmerType& TrajectoryFile::type(std::size_t swimmer) const {
  return layout.types.at(layout.swimmers[in_layout[swimmer]].type);
}

std::optional<int> whole_cycles(double time, double period) {
  constexpr double roundoff = 1e-6;
  const double cycles = time / period;
  return std::abs(cycles - std::round(cycles)) <= roundoff
             ? std::optional(static_cast<int>(std::lround(cycles)))
             : std::nullopt;
}

bool is_trajectory(const std::string& path) {
  if (path.ends_with(".h5md") || path.ends_with(".h5md.part")) return true;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;  // a pipe can be read only once
  const std::string signature = "\x89HDF";
  std::string start(signature.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return file && start == signature;
}

TrajectoryFile open_trajectory(const std::string& path) {
  TrajectoryReader reader(path);
  if (reader.has_incomplete_frame())
    print_to_stderr(
        fmt::format("{}: {}: the last frame is incomplete and is left out; the run is still writing it, or "
                    "it was killed or the disk was full\n",
                    program_invocation_short_name, path));
  Layout layout = layout_of(reader, path);
  std::vector<std::size_t> in_layout = indices_in(layout, reader, path);
  return {.source = path,
          .reader = std::move(reader),
          .layout = std::move(layout),
          .in_layout = std::move(in_layout)};
}

RunRecord run_of_trajectory(const std::string& path) {
  const TrajectoryFile file = open_trajectory(path);
  const std::vector<TrajectoryCycle> cycles = file.reader.cycles(columns_of<CycleStatistics>({}));
  RunRecord record;
  record.model = "trajectory";
  set_surroundings(file.layout, base_period(file.layout), record);
  record.scene = file.layout;
  for (const std::size_t s : file.in_layout) {
    const Swimmer& swimmer = file.layout.swimmers[s];
    const double period = file.layout.resolved_type(swimmer).driving.period;
    SwimmerRecord& added = record.swimmers.emplace_back();
    added.id = swimmer.id;
    if (period != record.driving.period) added.period = period;
  }
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    const auto statistics = records_of<CycleStatistics>(cycles[c].columns, record.swimmers.size());
    for (std::size_t s = 0; s < statistics.size(); ++s) {
      if (std::isnan(statistics[s].velocity[0])) continue;  // has not completed a cycle
      SwimmerRecord& swimmer = record.swimmers[s];
      const int index = count_cycles(record.driving.period, c + 1, swimmer.period);
      if (!swimmer.cycles.empty() && swimmer.cycles.back().index == index) continue;  // the same cycle again
      CycleStatistics& cycle = swimmer.cycles.emplace_back(statistics[s]);
      cycle.index = index;
      cycle.speed_along_axis = cycle.velocity.dot(cycle.axis);
      if (cycle.dipole) cycle.dipole = dipole_in_frame(matrix_of(cycle.dipole->tensor));
      for (auto* arms : {&cycle.arm_amplitudes, &cycle.arm_phases, &cycle.arm_means})
        arms->resize(file.type(s).bonds.size());
    }
  }
  return record;
}

std::size_t swimmer_with_id(int id, const std::vector<int>& ids, const std::string& flag,
                            const std::string& source) {
  if (const auto found = std::ranges::find(ids, id); found != ids.end()) return found - ids.begin();
  const auto distance = [id](int other) { return std::abs(static_cast<long>(other) - id); };
  const int nearest = *std::ranges::min_element(ids, {}, distance);
  const auto [low, high] = std::ranges::minmax(ids);
  throw InputError(
      flag, "there is no swimmer with the id {} in {}; the nearest id is {}, and the ids range from {} to {}",
      id, source, nearest, low, high);
}

}  // namespace beadswim
