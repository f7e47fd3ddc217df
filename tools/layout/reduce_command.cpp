#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/reduce.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

struct ReduceFlags {
  std::vector<std::string> files{"-"};
  std::string box;
  double tolerance = 1e-6;
};

void reduce_to_cell(Layout& layout, double tolerance) {
  ReducedCell reduced = reduce(layout, tolerance * smallest_radius(layout));
  const std::size_t before = layout.swimmers.size(), after = reduced.layout.swimmers.size();
  const Vec3& box = reduced.layout.domain.box->lengths;
  print_to_stderr(fmt::format(
      "beadswim-layout: the scene consists of {} x {} x {} copies of one cell; the new layout is "
      "this cell, with {} swimmers reduced to {}, in a box of {:g} x {:g} x {:g}; the copies differ "
      "in positions along one axis by at most {:.2g} (unit of length of the layout)\n",
      reduced.cells[0], reduced.cells[1], reduced.cells[2], before, after, box[0], box[1], box[2],
      reduced.largest_shift));
  layout = std::move(reduced.layout);
}

void put_in_box(Layout& layout, const std::string& lengths) {
  if (layout.swimmers.size() != 1)
    throw InputError(
        "--box",
        "the layout has {} swimmers, but only a single swimmer can be put in another box; leave the flag out",
        layout.swimmers.size());
  if (has_background_flow(layout))
    throw InputError(
        "--box",
        "a background flow, walls or a body force move the fluid of this layout, but the other box is "
        "periodic and has no walls; leave the flag out");
  if (layout.domain.half_space)
    throw InputError(
        "--box",
        "the fluid of this layout ends at the wall of a half-space, but the other box is periodic "
        "and has no walls; leave the flag out");
  Swimmer& swimmer = layout.swimmers.front();
  layout.domain.box = Box{.lengths = parse_vector(lengths)};
  swimmer.move_to(centred_position(layout.resolved_type(swimmer), swimmer.orientation(), layout.domain.box));
  require_sound(layout, "the flags");
}

void reduce_layouts(const ReduceFlags& flags, const CLI::App& program) {
  filter_layouts(flags.files, program, FilterOutput::like_input,
                 [&](const StreamMember&, LayoutDocument document, const auto& emit) {
                   flags.box.empty() ? reduce_to_cell(document.layout, flags.tolerance)
                                     : put_in_box(document.layout, flags.box);
                   emit(document);
                 });
}

}  // namespace

Command add_reduce_command(CLI::App& program) {
  const auto flags = std::make_shared<ReduceFlags>();
  CLI::App* const command = program.add_subcommand(
      "reduce",
      "Writes the smallest periodic box whose copies give the scene of the layout, such as one block of a "
      "swarm, or puts a single swimmer in another box.");
  add_layout_files(*command, flags->files);
  CLI::Option* tolerance =
      add_value(*command, "--tolerance", flags->tolerance, {"E", number_between(0, 0.5)},
                "Largest accepted distance of a swimmer from its position in the repeated box, 0 to 0.5 "
                "[smallest bead radius]");
  add_value(*command, "--box", flags->box, {"X,Y,Z", number_list({3}, finite_positive()), "none"},
            "Edge lengths of a periodic box that replaces the box of a single swimmer, which is moved to its "
            "centre [length]")
      ->excludes(tolerance);
  set_footer(*command,
             {"beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce >cell.json",
              "beadswim-layout reduce swarm.json --tolerance 0.1 >cell.json"},
             "swarms.md");
  return {command, [flags, &program] { reduce_layouts(*flags, program); }};
}

}  // namespace beadswim
