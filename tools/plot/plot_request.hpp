#pragma once

#include <optional>
#include <string>
#include <vector>

#include "abscissa.hpp"
#include "beadswim/tools/program.hpp"
#include "swarm_figure.hpp"
#include "trajectory_figure.hpp"
#include "velocity_figure.hpp"

namespace beadswim {

inline constexpr const char* stroke_kind = "stroke";
inline constexpr const char* period_kind = "velocity-against-period";
inline constexpr const char* separation_kind = "separation";
inline constexpr const char* speed_kind = "speed-against-error";
inline constexpr const char* trajectories_kind = "trajectories";
inline constexpr const char* swarm_kind = "swarm";
inline constexpr const char* swimmer_kind = "swimmer";
inline constexpr const char* products_kind = "mobility-products";

/// The command line, as text.
struct PlotRequest {
  std::string kind;
  std::vector<std::string> files;
  std::string output = "-";
  std::vector<std::string> methods;
  std::string relative_to;
  std::string reference;
  std::string against = "cycle";
  std::string axes = "auto";
  std::string cycle = "last";
  std::string swimmers;
  std::string beads = "2";
  std::string along = "x";
  std::string frame = "last";
  std::string colours = "blocks";
  std::string block_swimmers = "1,3,3";
  std::string repeat = "1,1,1";
  std::vector<std::string> marks;
  bool distances = false;
};

void add_flags(CLI::App& program, PlotRequest& request);

/// Throws InputError for an unknown kind, and for a flag that the kind has no use for.
void require_consistent(const PlotRequest& request);

/// None: against the cycle. Throws InputError for an unknown name, as does the other.
std::optional<Abscissa> parse_against(const std::string& name);
Axes parse_axes(const std::string& name);

/// Of trajectories and swarm. Throw InputError naming flag, value and what is allowed.
TrajectoryFigureOptions trajectory_options(const PlotRequest& request);
SwarmFigureOptions swarm_options(const PlotRequest& request);

/// The one of a swimmer's sketch, if it is named.
std::optional<int> sketched_swimmer(const PlotRequest& request);

}  // namespace beadswim
