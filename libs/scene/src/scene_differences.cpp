#include "beadswim/scene/scene_differences.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double tolerance = 1e-9;  // relative; small, since equal values are copies from one layout

bool agree(double a, double b) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

bool agree(const PropertyValue& a, const PropertyValue& b) {
  return std::ranges::equal(a.numbers, b.numbers, [](double x, double y) { return agree(x, y); });
}

/// Returns "4" for equal numbers, otherwise "4, 5, 4". The digits suffice to read the same numbers back.
std::string joined(const std::vector<double>& numbers) {
  if (numbers.empty()) return "none";
  if (std::ranges::count(numbers, numbers.front()) == std::ssize(numbers))
    return fmt::format("{}", numbers.front());
  return fmt::format("{}", fmt::join(numbers, ", "));
}

PropertyValue fluid_value(const Fluid& fluid) {
  return {{fluid.density, fluid.kinematic_viscosity},
          fmt::format("density {}, viscosity {}", fluid.density, fluid.kinematic_viscosity)};
}

// --- Swimmers that both scenes contain

/// A swimmer of a run and the swimmer with the same id in the reference.
struct Pair {
  const Swimmer& run;
  const Swimmer& reference;
};

std::vector<Pair> common_swimmers(const Layout& run, const Layout& reference) {
  std::vector<Pair> pairs;
  for (const Swimmer& swimmer : run.swimmers) {
    const auto same = std::ranges::find(reference.swimmers, swimmer.id, &Swimmer::id);
    if (same != reference.swimmers.end()) pairs.push_back({swimmer, *same});
  }
  return pairs;
}

// --- Placing

bool has_walls(const Domain& domain, int axis) {
  return (domain.box && !domain.box->is_periodic(axis)) ||
         (domain.half_space && domain.half_space->axis == axis);
}

/// Returns true if the background flow depends on the coordinate.
bool has_gradient(const Layout& layout, int axis) {
  return !layout.flow.velocity_gradient.col(axis).isZero(0);
}

/// Returns the translation that moves the swimmer of the run to the one of the reference, along axes on which
/// a translation changes nothing.
Vec3 translation(const Pair& pair, const Layout& run, const Layout& reference) {
  Vec3 shift = pair.reference.position - pair.run.position;
  for (int a = 0; a < 3; ++a)
    if ((has_walls(run.domain, a) && has_walls(reference.domain, a)) || has_gradient(run, a) ||
        has_gradient(reference, a))
      shift[a] = 0;
  return shift;
}

/// Returns the largest absolute value of all coordinates and box lengths [length].
double largest_coordinate(const Layout& layout) {
  double largest = layout.domain.box ? layout.domain.box->lengths.maxCoeff() : 0;
  for (const Swimmer& swimmer : layout.swimmers)
    largest = std::max(largest, swimmer.position.cwiseAbs().maxCoeff());
  return largest;
}

std::string vector_text(const Vec3& v) {
  return fmt::format("({:.10g}, {:.10g}, {:.10g})", v.x(), v.y(), v.z());
}

/// Returns the orientation as a quaternion w, x, y, z.
std::string orientation_text(const Swimmer& swimmer) {
  const Eigen::Quaterniond q(swimmer.orientation());
  constexpr double roundoff = 1e-12;
  const auto rounded = [](double part) { return std::abs(part) < roundoff ? 0 : part; };
  return fmt::format("({:.10g}, {:.10g}, {:.10g}, {:.10g})", rounded(q.w()), rounded(q.x()), rounded(q.y()),
                     rounded(q.z()));
}

std::optional<SceneDifference> placing_difference(const Layout& run, const Layout& reference,
                                                  const std::vector<Pair>& pairs) {
  const auto difference = [](const Pair& pair, const char* what, const auto& own, const auto& other) {
    return SceneDifference{SceneProperty::placing, fmt::format("swimmer {} {} {}", pair.run.id, what, own),
                           fmt::format("swimmer {} {} {}", pair.run.id, what, other)};
  };
  const bool same_domain = agree(domain_value(run.domain), domain_value(reference.domain));
  const std::optional<Box> box = same_domain ? run.domain.box : std::nullopt;
  const double largest_distance =
      tolerance * std::max(largest_coordinate(run), largest_coordinate(reference));
  const Vec3 shift = pairs.empty() ? Vec3::Zero() : translation(pairs.front(), run, reference);
  for (const Pair& pair : pairs) {
    const Vec3 distance = nearest_separation(pair.run.position + shift, pair.reference.position, box);
    if (distance.norm() > largest_distance)
      return difference(pair, "at", vector_text(pair.run.position),
                        vector_text(pair.run.position + distance));
    if ((pair.run.orientation() - pair.reference.orientation()).norm() > tolerance) {
      if (pair.run.turn || pair.reference.turn)
        return difference(pair, "with orientation", orientation_text(pair.run),
                          orientation_text(pair.reference));
      return difference(pair, "with axis", vector_text(pair.run.axis), vector_text(pair.reference.axis));
    }
    const double offset = run.resolved_type(pair.run).driving.phase_offset;
    const double other = reference.resolved_type(pair.reference).driving.phase_offset;
    if (!agree(offset, other)) return difference(pair, "with phase offset", offset, other);
  }
  return std::nullopt;
}

/// Appends what joins which beads, where they are at rest, and the rest angles.
void append_shape(const SwimmerType& type, std::vector<double>& numbers) {
  for (const BeadAtRest& bead : type.beads) numbers.insert(numbers.end(), bead.at.begin(), bead.at.end());
  for (const Bond& bond : type.bonds) numbers.insert(numbers.end(), bond.beads.begin(), bond.beads.end());
  for (const Angle& angle : type.angles) {
    numbers.insert(numbers.end(), angle.beads.begin(), angle.beads.end());
    numbers.push_back(angle.rest);
  }
}

/// Amplitudes and phases of all drives, with what they drive.
struct DriveValues {
  PropertyValue amplitude, phase;
};

DriveValues drive_values(const Driving& driving) {
  std::vector<double> amplitudes, phases, targets;
  const auto add = [&](int target, const std::vector<Harmonic>& harmonics) {
    targets.push_back(target);
    for (const Harmonic& harmonic : harmonics) {
      amplitudes.push_back(harmonic.amplitude);
      phases.push_back(harmonic.phase);
      targets.push_back(harmonic.multiple);
    }
  };
  for (const ForceDrive& drive : driving.forces) {
    add(drive.bead, drive.harmonics);
    targets.insert(targets.end(), drive.direction.begin(), drive.direction.end());
    if (drive.constant != 0) amplitudes.push_back(drive.constant);
  }
  for (const BondDrive& drive : driving.bonds) {
    add(drive.bond, drive.harmonics);
    targets.push_back(static_cast<double>(drive.quantity));
  }
  for (const AngleDrive& drive : driving.angles) add(drive.angle, drive.harmonics);
  DriveValues values{.amplitude = numbers_value(amplitudes), .phase = numbers_value(phases)};
  values.amplitude.numbers.insert(values.amplitude.numbers.end(), targets.begin(), targets.end());
  return values;
}

}  // namespace

PropertyValue numbers_value(const std::vector<double>& numbers) {
  return {numbers, joined(numbers)};
}

PropertyValue domain_value(const Domain& domain) {
  if (domain.half_space) return {{static_cast<double>(domain.half_space->axis)}, in_words(domain)};
  if (!domain.box) return {{}, in_words(domain)};
  const Box& box = *domain.box;
  PropertyValue value{{box.lengths.begin(), box.lengths.end()},
                      fmt::format("{} x {} x {}", box.lengths.x(), box.lengths.y(), box.lengths.z())};
  std::vector<std::string> boundaries;
  for (const Boundary boundary : box.boundary) {
    value.numbers.push_back(static_cast<double>(boundary));
    boundaries.push_back(to_text(boundary));
  }
  value.text += fmt::format(", {}", fmt::join(boundaries, ", "));
  for (int a = 0; a < 3; ++a) {
    const WallVelocities& walls = box.walls[a];
    for (const Vec3& velocity : {walls.lower, walls.upper})
      value.numbers.insert(value.numbers.end(), velocity.begin(), velocity.end());
    if (walls.are_moving())
      value.text += fmt::format(", walls across {} with velocities ({}) and ({})", "xyz"[a],
                                fmt::join(walls.lower, ", "), fmt::join(walls.upper, ", "));
  }
  return value;
}

PropertyValue flow_value(const BackgroundFlow& flow) {
  std::vector<double> numbers(flow.velocity.begin(), flow.velocity.end());
  const Eigen::Matrix3d rows = flow.velocity_gradient.transpose();
  numbers.insert(numbers.end(), rows.data(), rows.data() + rows.size());
  return numbers_value(numbers);
}

PropertyValue body_force_value(const Vec3& force) {
  return numbers_value({force.begin(), force.end()});
}

PropertyValue swimmers_value(std::vector<int> ids) {
  std::ranges::sort(ids);
  std::string text = fmt::format("{} with id {}", ids.size(), ids.front());
  if (ids.size() > 1) text += fmt::format(" to {}", ids.back());
  return {{ids.begin(), ids.end()}, text};
}

SceneProperties common_properties(const Layout& layout) {
  std::vector<int> ids;
  for (const Swimmer& swimmer : layout.swimmers) ids.push_back(swimmer.id);
  return {{SceneProperty::fluid, fluid_value(layout.fluid)},
          {SceneProperty::domain, domain_value(layout.domain)},
          {SceneProperty::flow, flow_value(layout.flow)},
          {SceneProperty::body_force, body_force_value(layout.body_force)},
          {SceneProperty::swimmers, swimmers_value(ids)}};
}

SceneProperties swimmer_properties(const SwimmerType& type) {
  const auto numbers = [](const auto& parts, auto number) {
    std::vector<double> all;
    for (const auto& part : parts) all.push_back(std::invoke(number, part));
    return numbers_value(all);
  };
  const Driving& driving = type.driving;
  SceneProperties properties{
      {SceneProperty::period, numbers_value({driving.period})},
      {SceneProperty::frame, {{static_cast<double>(driving.frame)}, to_text(driving.frame)}},
      {SceneProperty::radius, numbers(type.beads, &Bead::radius)},
      {SceneProperty::bead_density, numbers(type.beads, &Bead::density)},
      {SceneProperty::arm, numbers(type.bonds, &Spring::rest_length)},
      {SceneProperty::stiffness, numbers(type.bonds, &Spring::stiffness)},
      {SceneProperty::damping, numbers(type.bonds, &Spring::damping)},
      {SceneProperty::angular_stiffness, numbers(type.angles, &Angle::stiffness)},
  };
  if (const auto three = three_bead_form(driving)) {
    properties[SceneProperty::amplitude] = numbers_value({three->amplitude[0], three->amplitude[1]});
    properties[SceneProperty::phase] = numbers_value({three->phase});
  } else {
    const DriveValues drives = drive_values(driving);
    properties[SceneProperty::amplitude] = drives.amplitude;
    properties[SceneProperty::phase] = drives.phase;
  }
  if (!three_bead_form(type)) append_shape(type, properties[SceneProperty::arm].numbers);
  return properties;
}

void add_differences(std::vector<SceneDifference>& differences, const SceneProperties& run,
                     const SceneProperties& reference, const std::string& prefix) {
  for (const auto& [property, value] : run) {
    const auto other = reference.find(property);
    if (other == reference.end() || agree(value, other->second)) continue;
    if (std::ranges::find(differences, property, &SceneDifference::property) != differences.end()) continue;
    const std::string note = value.text == other->second.text ? ", of another shape" : "";
    differences.push_back({property, prefix + value.text, prefix + other->second.text + note});
  }
}

std::vector<SceneDifference> scene_differences(const Layout& run, const Layout& reference) {
  std::vector<SceneDifference> differences;
  add_differences(differences, common_properties(run), common_properties(reference));
  const std::vector<Pair> pairs = common_swimmers(run, reference);
  for (const Pair& pair : pairs) {
    add_differences(differences, swimmer_properties(run.resolved_type(pair.run)),
                    swimmer_properties(reference.resolved_type(pair.reference)),
                    pairs.size() > 1 ? fmt::format("swimmer {}: ", pair.run.id) : "");
  }
  if (const auto difference = placing_difference(run, reference, pairs)) differences.push_back(*difference);
  std::ranges::sort(differences, {}, &SceneDifference::property);
  return differences;
}

}  // namespace beadswim
