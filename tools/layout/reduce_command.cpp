#include "reduce_command.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/reduce.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
ReduceCommand::ReduceCommand(CLI::App& program)
    : command_(
          program.add_subcommand("reduce",
                                 "Writes the smallest periodic box whose periodic copies give the scene of "
                                 "the layout. A swarm of equal blocks becomes one block or one swimmer.")) {
  command_->add_option("layout", file_, "Layout file (JSON); - is standard input.")->type_name("FILE");
  command_
      ->add_option("--tolerance", tolerance_,
                   "Largest accepted distance of a swimmer from its position in the repeated box, 0 to 0.5 "
                   "[smallest bead radius]")
      ->type_name("E")
      ->check(number_between(0, 0.5))
      ->capture_default_str();
  set_footer(*command_,
             {"beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce >cell.json",
              "beadswim-layout reduce swarm.json --tolerance 0.1 >cell.json"},
             "swarms.md");
}

void ReduceCommand::run(const CLI::App& program) const {
  LayoutDocument document = read_layout(file_);
  ReducedCell reduced = reduce(document.layout, tolerance_ * smallest_radius(document.layout));
  const std::size_t before = document.layout.swimmers.size(), after = reduced.layout.swimmers.size();
  const Vec3& box = reduced.layout.domain->lengths;
  print_to_stderr(fmt::format(
      "beadswim-layout: the scene consists of {} x {} x {} copies of one cell; the new layout is "
      "this cell, with {} swimmers reduced to {}, in a box of {:g} x {:g} x {:g}; the copies differ "
      "in positions along one axis by at most {:.2g} (unit of length of the layout)\n",
      reduced.cells[0], reduced.cells[1], reduced.cells[2], before, after, box[0], box[1], box[2],
      reduced.largest_shift));
  document.layout = std::move(reduced.layout);
  document.provenance.push_back(provenance_record(program));
  write_text("-", dump_json(layout_to_json(document)));
}

}  // namespace beadswim
