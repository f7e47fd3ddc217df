#include "swimmer_command.hpp"

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/layout/check.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {

SwimmerCommand::SwimmerCommand(CLI::App& program)
    : command_(program.add_subcommand(
          "swimmer", "A layout of one swimmer: a preset, changed by any of the flags, or the flags alone.")),
      flags_(*command_) {
  command_->add_flag(
      "--jsonl", json_lines_,
      "Write the layout on one line, for streams of one layout a line (beadswim-theory --jsonl).");
}

void SwimmerCommand::run(const CLI::App& program) const {
  LayoutDocument document{.layout = flags_.layout(), .provenance = {provenance_record(program)}};
  const auto faults = check_layout(document.layout);
  if (!faults.empty()) {
    throw InputError("the flags make no sound layout", faults.front().place + ": " + faults.front().message);
  }
  const Json json = layout_to_json(document);
  write_text("-", json_lines_ ? dump_json_line(json) : dump_json(json));
}

}  // namespace beadswim
