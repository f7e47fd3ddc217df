#include <fmt/core.h>

#include "beadswim/tools/program.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "swimmer_flags.hpp"
#include "variation_text.hpp"

namespace beadswim {
namespace {

struct VaryFlags {
  std::vector<std::string> files{"-"}, variations;
  bool together = false;
};

void vary(const VaryFlags& flags, const CLI::App& program) {
  std::vector<Variation> variations;
  for (const std::string& text : flags.variations) variations.push_back(parse_variation(text));
  for (const Variation& variation : variations)
    for (const Json& value : variation.values)
      if (variation.name == "phase" && value.is_number())
        warn_of_turns(fmt::format("{}", value.get<double>()));
  if (flags.together) require_equal_counts(variations);
  const std::vector<StudyPoint> points = study_points(variations, flags.together, "--over");
  filter_layouts(flags.files, program, FilterOutput::lines,
                 [&](const StreamMember& member, const LayoutDocument&, const auto& emit) {
                   const Json layout = parse_json(member.text, member.source);
                   for (const StudyPoint& point : points)
                     emit(with_values(layout, point, member.source, "--over"));
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
  command
      ->add_option("--over", flags->variations,
                   "A quantity (a flag of beadswim-layout swimmer without --, or a JSON pointer into the "
                   "layout) and its values. Repeat the flag for all combinations.")
      ->type_name("NAME=FROM:TO:COUNT[:log]|NAME=V1,V2,...")
      ->required()
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
