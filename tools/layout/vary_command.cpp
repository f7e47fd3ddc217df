#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/study/named_quantity.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "made_layout.hpp"
#include "swimmer_flags.hpp"
#include "variation_text.hpp"

namespace beadswim {
namespace {

struct VaryFlags {
  std::vector<std::string> files{"-"}, variations, relations;
  bool together = false;
};

/// A layout that varies: its JSON, and the flags of the command that made it, if it names one.
struct VariedLayout {
  Json json;
  std::set<std::string> parameters;
  std::string source;

  /// Returns a number of the layout by its name. Throws InputError if the layout does not state it.
  double number(const std::string& name) const {
    Json value;
    if (parameters.contains(name)) {
      value = json["made_by"]["parameters"].value(name, Json());
    } else if (name.starts_with('/') && json.contains(Json::json_pointer(name))) {
      value = json[Json::json_pointer(name)];
    }
    if (value.is_number()) return value.get<double>();
    throw InputError("--keep",
                     "{} does not state one number for \"{}\"; name a number by its JSON pointer, or give "
                     "the flag when you make the layout",
                     source, name);
  }
};

/// Returns the flags of the command that made the layout. Empty if the layout names no command, or if the
/// command makes another layout: then the layout was changed since.
std::set<std::string> parameters_of(const Json& json, const Layout& layout, const std::string& source) {
  if (!json.contains("made_by")) return {};
  const Json& made_by = json["made_by"];
  const bool is_unchanged =
      layout_to_json({.layout = made_layout(made_by, source).layout}) == layout_to_json({.layout = layout});
  return is_unchanged ? parameter_names(made_by["command"]) : std::set<std::string>();
}

/// Adds the quantities that follow the varied ones.
void add_others(StudyPoint& point, const std::vector<CoupledVariation>& variations) {
  for (const CoupledVariation& variation : variations) {
    const auto first = std::ranges::find(point, variation.first.name, &StudyPoint::value_type::first);
    const Json value = first->second;
    for (const auto& [name, sign] : variation.others) {
      if (sign < 0 && !value.is_number())
        throw InputError("--over", "\"{}\" has no opposite; give numbers", value.dump());
      point.emplace_back(name, sign < 0 ? Json(-value.get<double>()) : value);
    }
  }
}

/// Adds the quantity that follows from A + B, A B or A/B of the layout and the varied quantity of the two.
void add_kept(StudyPoint& point, const KeptRelation& relation, const VariedLayout& layout) {
  const auto find = [&point](const std::string& name) {
    return std::ranges::find(point, name, &StudyPoint::value_type::first);
  };
  const bool has_first = find(relation.first) != point.end(),
             has_second = find(relation.second) != point.end();
  if (has_first == has_second)
    throw InputError("--keep", "{} of \"{}\" and \"{}\" is varied; vary exactly one of them",
                     has_first ? "each" : "none", relation.first, relation.second);
  const std::string &varied = has_first ? relation.first : relation.second,
                    &other = has_first ? relation.second : relation.first;
  const Json& value = find(varied)->second;
  const double a = layout.number(relation.first), b = layout.number(relation.second);
  const double before = has_first ? a : b, number = value.is_number() ? value.get<double>() : NAN,
               kept = relation.sign == '+'   ? a + b - number
                      : relation.sign == '*' ? a * b / number
                                             : number / before * (has_first ? b : a);
  if (!std::isfinite(kept))
    throw InputError("--keep",
                     "\"{}\" has the value {}, from which \"{}\" does not follow; give other numbers", varied,
                     value.dump(), other);
  point.emplace_back(other, kept);
}

/// Returns the layout with the values. Parameters of the command that made it make it anew, other quantities
/// change it.
LayoutDocument varied(const VariedLayout& layout, const StudyPoint& point) {
  StudyPoint made, changed;
  for (const auto& [name, value] : point) {
    if (layout.parameters.contains(name)) {
      if (const NamedQuantity* quantity = find_quantity(name))
        if (const std::string fault = value_fault(*quantity, value); !fault.empty())
          throw InputError("--over", "{}: {}", name, fault);
      made.emplace_back(name, value);
      continue;
    }
    quantity_name(name, "--over");
    changed.emplace_back(name, value);
  }
  if (made.empty()) return with_values(layout.json, changed, layout.source, "--over");
  Json made_by = layout.json["made_by"];
  for (const auto& [name, value] : made) made_by["parameters"][name] = value;
  const MadeLayout anew = made_layout(made_by, layout.source);
  const LayoutDocument again{.layout = anew.layout,
                             .provenance = layout.json.value("provenance", Json::array()),
                             .study = layout.json.value("study", Json())};
  LayoutDocument document = with_values(layout_to_json(again), changed, layout.source, "--over", made);
  if (changed.empty()) document.made_by = anew.made_by;
  return document;
}

void vary(const VaryFlags& flags, const CLI::App& program) {
  std::vector<CoupledVariation> coupled;
  std::vector<Variation> variations;
  for (const std::string& text : flags.variations)
    variations.push_back(coupled.emplace_back(parse_variation(text)).first);
  std::vector<KeptRelation> relations;
  for (const std::string& text : flags.relations) relations.push_back(parse_relation(text));
  for (const Variation& variation : variations)
    for (const Json& value : variation.values)
      if (variation.name == "phase" && value.is_number())
        warn_of_turns(fmt::format("{}", value.get<double>()));
  if (flags.together) require_equal_counts(variations);
  std::vector<StudyPoint> points = study_points(variations, flags.together, "--over");
  for (StudyPoint& point : points) add_others(point, coupled);
  filter_layouts(flags.files, program, FilterOutput::lines,
                 [&](const StreamMember& member, const LayoutDocument& document, const auto& emit) {
                   const Json json = parse_json(member.text, member.source);
                   const VariedLayout layout{
                       .json = json,
                       .parameters = parameters_of(json, document.layout, member.source),
                       .source = member.source};
                   for (StudyPoint point : points) {
                     for (const KeptRelation& relation : relations) add_kept(point, relation, layout);
                     emit(varied(layout, point));
                   }
                 });
}

}  // namespace

Command add_vary_command(CLI::App& program) {
  const auto flags = std::make_shared<VaryFlags>();
  CLI::App* const command = program.add_subcommand(
      "vary",
      "Writes layouts that differ in the values of a few quantities (a study), one layout per line. "
      "beadswim-run, beadswim-theory and the commands of beadswim-layout take such a stream.");
  add_layout_files(*command, flags->files);
  add_value(*command, "--over", flags->variations, {"NAME=FROM:TO:COUNT[:log]|NAME=V1,V2,..."},
            "Flag of the command that made the layout, without --, or JSON pointer, and values. NAME,-NAME: "
            "opposite values. [X,Y]: a list. Repeated: all combinations.")
      ->required()
      ->allow_extra_args(false);
  add_value(*command, "--keep", flags->relations, {"A+B|A*B|A:B"},
            "Two numbers whose sum, product or ratio stays as in the layout: one of them is varied, the "
            "other follows")
      ->allow_extra_args(false);
  command->add_flag("--together", flags->together,
                    "Change all quantities in step, instead of writing all combinations.");
  set_footer(*command,
             {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-layout vary --over period=2000:32000:5:log --over phase=45deg,90deg >study.jsonl",
              "beadswim-theory study.jsonl --method rpy-perturbation >theory.jsonl"},
             "studies.md");
  return {command, [flags, &program] { vary(*flags, program); }};
}

}  // namespace beadswim
