#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/combine.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

struct CombineFlags {
  std::vector<std::string> files{"-"}, displacements, turns;
};

/// Parses "ANGLE AXIS", such as "90deg z" or "1.5 0,1,1".
Eigen::Quaterniond parse_turn(const std::string& text) {
  const auto refuse = [&text](const std::string& why) {
    throw InputError("--rotate", "\"{}\": {}; write \"ANGLE AXIS\", such as \"90deg z\" or \"90deg 0,1,1\"",
                     text, why);
  };
  const std::vector<std::string> parts = split_at(' ', text);
  if (parts.size() != 2) refuse("the value needs an angle and an axis");
  if (!angle()(parts[0]).empty()) refuse(fmt::format("\"{}\" is no angle", parts[0]));
  constexpr std::string_view letters = "xyz";
  Vec3 axis = Vec3::Zero();
  if (parts[1].size() == 1 && letters.find(parts[1][0]) != letters.npos)
    axis[static_cast<int>(letters.find(parts[1][0]))] = 1;
  else if (number_list({3}, finite())(parts[1]).empty())
    axis = parse_vector(parts[1]);
  if (axis.isZero(0)) refuse(fmt::format("\"{}\" is no axis", parts[1]));
  return Eigen::Quaterniond(Eigen::AngleAxisd(parse_angle(parts[0]), axis.stableNormalized()));
}

/// Returns the index of the layout to which the first value of a flag belongs: flags have one value for each
/// layout, or one for each but the first.
std::size_t first_with_value(const std::string& flag, std::size_t values, std::size_t layouts) {
  if (values == 0 || values == layouts) return 0;
  if (values + 1 == layouts) return 1;
  throw InputError(flag,
                   "the flag is given {} times for {} layouts; give it once for each layout, or once for "
                   "each but the first",
                   values, layouts);
}

/// Adds the values of a study; a quantity with different values in two layouts is no longer one of a study.
void merge_study(Json& study, const Json& added) {
  if (study.is_null()) study = added;
  for (const auto& [name, value] : added.items())
    if (study.value(name, value) != value) study.erase(name);
}

void combine_layouts(const CombineFlags& flags, const CLI::App& program) {
  DocumentStream stream(flags.files);
  std::vector<ScenePart> parts;
  LayoutDocument combined;
  while (const auto member = stream.next()) {
    LayoutDocument document = layout_of(*member);
    for (const Json& call : document.provenance) combined.provenance.push_back(call);
    merge_study(combined.study, document.study);
    parts.push_back({.layout = std::move(document.layout), .source = member->source});
  }
  std::size_t part = first_with_value("--at", flags.displacements.size(), parts.size());
  for (const std::string& displacement : flags.displacements)
    parts[part++].displacement = parse_vector(displacement);
  part = first_with_value("--rotate", flags.turns.size(), parts.size());
  for (const std::string& turn : flags.turns) parts[part++].turn = parse_turn(turn);
  combined.layout = combine(parts);
  require_sound(combined.layout, "the layouts together", "; --at moves swimmers");
  warn_of_fixed_forces(combined.layout);
  write_layout(std::move(combined), program, stream.is_lines() ? dump_json_line : dump_json);
}

}  // namespace

Command add_combine_command(CLI::App& program) {
  const auto flags = std::make_shared<CombineFlags>();
  CLI::App* const command = program.add_subcommand(
      "combine",
      "Writes one scene with the swimmers of several layouts, whose units, fluids and domains are equal. "
      "Swimmers get new ids.");
  add_layout_files(*command, flags->files);
  add_value(
      *command, "--at", flags->displacements, {"X,Y,Z", number_list({3}, finite())},
      "Displacement of the swimmers of one layout. Repeat the flag for each layout, or for each but the "
      "first; write negative values as --at=-1,0,0 [length]")
      ->allow_extra_args(false);
  add_value(*command, "--rotate", flags->turns, {"\"ANGLE AXIS\""},
            "Rotation of the swimmers of one layout about the mean of their positions, as \"90deg z\" or "
            "\"1.5 0,1,1\", before --at. Repeat the flag as --at [rad]")
      ->allow_extra_args(false);
  set_footer(
      *command,
      {"beadswim-layout combine layout.json layout.json --at 0,0,20 --rotate \"180deg z\" >pair.json",
       "beadswim-layout shape triangle | beadswim-layout combine - triangle.json --at 0,0,60 >two.json"},
      "swarms.md");
  return {command, [flags, &program] { combine_layouts(*flags, program); }};
}

}  // namespace beadswim
