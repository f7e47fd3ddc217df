#include "vary_command.hpp"

#include "beadswim/tools/program.hpp"
#include "layout_filter.hpp"
#include "study.hpp"

namespace beadswim {

VaryCommand::VaryCommand(CLI::App& program)
    : command_(program.add_subcommand(
          "vary",
          "Writes layouts that differ in the values of a few quantities (a study), one layout per line. "
          "beadswim-run, beadswim-theory and the commands of beadswim-layout take such a stream.")) {
  add_layout_files(*command_, files_);
  command_
      ->add_option("--over", variations_,
                   "A quantity (a flag of beadswim-layout swimmer without --, or a JSON pointer into the "
                   "layout) and its values. Repeat the flag for all combinations.")
      ->type_name("NAME=FROM:TO:COUNT[:log]|NAME=V1,V2,...")
      ->required()
      ->allow_extra_args(false);
  command_->add_flag("--together", together_,
                     "Change all quantities in step, instead of writing all combinations.");
  set_footer(*command_,
             {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-layout vary --over period=2000:32000:5:log --over phase=45deg,90deg >study.jsonl",
              "beadswim-theory study.jsonl --method rpy-perturbation >theory.jsonl"},
             "studies.md");
}

void VaryCommand::run(const CLI::App& program) const {
  std::vector<Variation> variations;
  for (const std::string& text : variations_) variations.push_back(parse_variation(text));
  const std::vector<StudyPoint> points = study_points(variations, together_);
  filter_layouts(files_, program, FilterOutput::lines,
                 [&](const StreamMember& member, const LayoutDocument&, const auto& emit) {
                   const Json layout = parse_json(member.text, member.source);
                   for (const StudyPoint& point : points)
                     emit(with_values(layout, point, member.source, "--over"));
                 });
}

}  // namespace beadswim
