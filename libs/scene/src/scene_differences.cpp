#include "beadswim/scene/scene_differences.hpp"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/joined.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double tolerance = 1e-9;  // relative; small, since equal values are copies from one layout

bool agree(double a, double b) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

bool agree(const PropertyValue& a, const PropertyValue& b) {
  return std::ranges::equal(a.leaves, b.leaves, [](const FieldLeaf& x, const FieldLeaf& y) {
    return agree(x.number, y.number) && x.word == y.word;
  });
}

// --- Names of properties

enum class InText { always, unless_zero, never };

/// Property of the leaves whose pointers match a pattern, in which * stands for any text.
struct PropertyRow {
  const char* pattern;
  const char* property;
  InText in_text = InText::always;
};

/// The first row that matches a pointer applies. Without a row, the first key of the pointer names the
/// property. Texts contain the leaves in the order of the rows.
constexpr PropertyRow property_rows[]{
    {"/driving/period", "period"},
    {"/driving/frame", "frame"},
    {"/driving*/phase", "phase"},
    {"/driving/phase_offset", "placing"},
    {"/driving/amplitude*", "amplitude"},
    {"/driving/forces/*/amplitude", "amplitude"},
    {"/driving/forces/*/constant", "amplitude", InText::unless_zero},
    {"/driving/*/amplitude", "amplitude"},
    {"/driving*", "amplitude", InText::never},  // what is driven
    {"/beads/*/radius", "radius"},
    {"/beads/*/density", "bead_density"},
    {"/angular_stiffness", "angular_stiffness"},
    {"/angles/*/stiffness", "angular_stiffness"},
    {"/*/stiffness", "stiffness"},
    {"/*/damping", "damping"},
    {"/*/rest_length", "arm"},
    // where beads are at rest, what joins which beads, and the rest angles
    {"/beads*", "arm", InText::never},
    {"/springs*", "arm", InText::never},
    {"/bonds*", "arm", InText::never},
    {"/angles*", "arm", InText::never},
    {"/flow/velocity/*", "flow"},
    {"/id", "swimmers"},
    {"/type", "placing"},  // names of types do not matter
    {"/position*", "placing"},
    {"/axis*", "placing"},
    {"/orientation*", "placing"},
    {"/start*", "placing"},
};

const PropertyRow* row_of(const std::string& pointer) {
  return std::ranges::find_if(
      property_rows, [&](const PropertyRow& row) { return fnmatch(row.pattern, pointer.c_str(), 0) == 0; });
}

std::string property_of(const std::string& pointer) {
  const PropertyRow* const row = row_of(pointer);
  return row == std::end(property_rows) ? pointer.substr(1, pointer.find('/', 1) - 1) : row->property;
}

bool is_in_text(const FieldLeaf& leaf) {
  const PropertyRow* const row = row_of(leaf.pointer);
  return row == std::end(property_rows) || row->in_text == InText::always ||
         (row->in_text == InText::unless_zero && leaf.number != 0);
}

/// Returns "4" for equal values, otherwise "4, 5, 4". The digits suffice to read the same numbers back.
std::string text_of(const std::vector<FieldLeaf>& leaves) {
  std::vector<std::string> texts;
  for (const FieldLeaf& leaf : leaves)
    if (is_in_text(leaf)) texts.push_back(leaf.word.empty() ? fmt::format("{}", leaf.number) : leaf.word);
  if (texts.empty()) return "none";
  if (std::ranges::count(texts, texts.front()) == std::ssize(texts)) return texts.front();
  return joined(texts, ", ");
}

/// Returns true for a field of a layout that belongs to all swimmers. Units are equal, and the resolution is
/// a proposal.
bool is_common(const std::string& field) {
  return field != "units" && field != "types" && field != "swimmers" && field != "resolution" &&
         field != "seed";
}

std::string domain_text(const Domain& domain) {
  if (!domain.box) return in_words(domain);
  const Box& box = *domain.box;
  std::string text = fmt::format("{} x {} x {}", box.lengths.x(), box.lengths.y(), box.lengths.z());
  for (const Boundary boundary : box.boundary) text += ", " + to_text(boundary);
  for (int a = 0; a < 3; ++a) {
    const WallVelocities& walls = box.walls[a];
    if (walls.are_moving())
      text += fmt::format(", walls across {} with velocities ({}) and ({})", "xyz"[a],
                          joined(walls.lower, ", "), joined(walls.upper, ", "));
  }
  return text;
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
    return SceneDifference{"placing", fmt::format("swimmer {} {} {}", pair.run.id, what, own),
                           fmt::format("swimmer {} {} {}", pair.run.id, what, other)};
  };
  const bool same_domain =
      agree(PropertyValue{leaves_of(run.domain)}, PropertyValue{leaves_of(reference.domain)});
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
    if (pair.run.start.has_value() != pair.reference.start.has_value())
      return difference(pair, "starts", pair.run.start ? "as given" : "at rest",
                        pair.reference.start ? "as given" : "at rest");
    const double offset = run.driving_of(pair.run).phase_offset;
    const double other = reference.driving_of(pair.reference).phase_offset;
    if (!agree(offset, other)) return difference(pair, "with phase offset", offset, other);
  }
  return std::nullopt;
}

/// Returns the properties of a swimmer of a layout except its placing.
SceneProperties swimmer_properties(const Layout& layout, const Swimmer& swimmer) {
  SceneProperties properties = swimmer_properties(layout.resolved_type(swimmer));
  properties.merge(properties_of(leaves_of(swimmer)));
  properties.erase("placing");
  return properties;
}

}  // namespace

const std::vector<std::string>& scene_property_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names{
        "period",  "amplitude",         "phase", "frame",  "radius", "bead_density", "arm",      "stiffness",
        "damping", "angular_stiffness", "fluid", "domain", "flow",   "body_force",   "swimmers", "placing"};
    const auto add = [&names](const std::string& key, const auto&...) {
      const std::string name = property_of("/" + key);
      if (is_common(key) && std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    const Layout layout;
    const SwimmerType type;
    const Swimmer swimmer;
    visit_fields(add, layout);
    visit_fields(add, type);
    visit_fields(add, swimmer);
    return names;
  }();
  return all;
}

SceneProperties properties_of(std::vector<FieldLeaf> leaves) {
  std::ranges::stable_sort(leaves, {}, [](const FieldLeaf& leaf) { return row_of(leaf.pointer); });
  SceneProperties properties;
  for (FieldLeaf& leaf : leaves) properties[property_of(leaf.pointer)].leaves.push_back(std::move(leaf));
  for (auto& [property, value] : properties) value.text = text_of(value.leaves);
  return properties;
}

SceneProperties common_properties(const Layout& layout) {
  std::vector<FieldLeaf> leaves;
  const auto append = [&]<class Field>(const std::string& name, const Field& field, const auto&...) {
    if constexpr (!std::same_as<Field, Units>)
      if (is_common(name)) append_leaves(leaves, "/" + name, field);
  };
  visit_fields(append, layout);
  SceneProperties properties = properties_of(std::move(leaves));
  const auto& [density, viscosity, thermal_energy] = layout.fluid;
  properties["fluid"].text = fmt::format("density {}, viscosity {}", density, viscosity);
  if (thermal_energy > 0) properties["fluid"].text += fmt::format(", kT {}", thermal_energy);
  properties["domain"].text = domain_text(layout.domain);
  std::vector<int> ids;
  for (const Swimmer& swimmer : layout.swimmers) ids.push_back(swimmer.id);
  properties["swimmers"] = swimmers_value(ids);
  return properties;
}

SceneProperties swimmer_properties(const SwimmerType& type) {
  const auto three = three_bead_form(type);
  SceneProperties properties = properties_of(three ? leaves_of(*three) : leaves_of(type));
  properties.try_emplace("phase");  // of a type without harmonics
  return properties;
}

PropertyValue swimmers_value(std::vector<int> ids) {
  std::ranges::sort(ids);
  std::string text = fmt::format("{} with id {}", ids.size(), ids.front());
  if (ids.size() > 1) text += fmt::format(" to {}", ids.back());
  return {leaves_of(ids), text};
}

void add_differences(std::vector<SceneDifference>& differences, const SceneProperties& run,
                     const SceneProperties& reference, const std::string& prefix) {
  for (const auto& [property, value] : run) {
    const auto other = reference.find(property);
    if (other == reference.end() || agree(value, other->second)) continue;
    if (std::ranges::find(differences, property, &SceneDifference::name) != differences.end()) continue;
    const std::string note = value.text == other->second.text ? ", of another shape" : "";
    differences.push_back({property, prefix + value.text, prefix + other->second.text + note});
  }
  std::ranges::stable_sort(differences, {}, [](const SceneDifference& difference) {
    return std::ranges::find(scene_property_names(), difference.name) - scene_property_names().begin();
  });
}

std::vector<SceneDifference> scene_differences(const Layout& run, const Layout& reference) {
  std::vector<SceneDifference> differences;
  const auto add = [&](SceneProperties one, SceneProperties other, const std::string& prefix) {
    for (const auto& [property, value] : one) other.try_emplace(property);  // without value
    for (const auto& [property, value] : other) one.try_emplace(property);
    add_differences(differences, one, other, prefix);
  };
  add(common_properties(run), common_properties(reference), "");
  const std::vector<Pair> pairs = common_swimmers(run, reference);
  for (const Pair& pair : pairs) {
    if (run.resolved_type(pair.run) == reference.resolved_type(pair.reference)) continue;
    add(swimmer_properties(run, pair.run), swimmer_properties(reference, pair.reference),
        pairs.size() > 1 ? fmt::format("swimmer {}: ", pair.run.id) : "");
  }
  if (const auto difference = placing_difference(run, reference, pairs)) differences.push_back(*difference);
  return differences;
}

}  // namespace beadswim
