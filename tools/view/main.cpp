#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "page.hpp"
#include "page_data.hpp"

// beadswim-view writes a trajectory as a web page that consists of one file.

namespace {

using namespace beadswim;

constexpr double max_bytes = 300e6;  // largest page that browsers open without difficulty [byte]

struct ViewRequest {
  std::string file;
  std::string output;
  std::optional<std::string> flow{};
  PageOptions options;
};

void add_flags(CLI::App& program, ViewRequest& request) {
  add_value(program, "FILE", request.file, {.name = "RUN.h5md"},
            "Trajectory file of beadswim-run (.h5md), or the file of an unfinished run (.h5md.part).")
      ->required();
  add_value(program, "-o,--output", request.output, {.name = "PAGE.html|-"},
            "Web page to write; - is standard output")
      ->required();
  add_value(program, "--every", request.options.every, {"N", whole_positive()},
            "Interval between the frames that the page contains: every Nth frame and the last. A larger N "
            "makes the page smaller");
  add_list(program, "--block-swimmers", request.options.block_swimmers,
           {"NX,NY,NZ|N", number_list({1, 3}, whole_positive()), "1,3,3"},
           "Number of swimmers in a block: along x, y, z (by layers of the layout), or in total (by "
           "consecutive ids). The page can colour swimmers by block");
  add_value(program, "--flow", request.flow, {.name = "FILE.vti"},
            "Flow file of the run (--flow-every, --flow-mean) in the frame of the box. The page shows it as "
            "at most 4000 arrows");
  set_footer(program,
             {"beadswim-view run.h5md -o run.html", "beadswim-view run.h5md --every 10 -o small.html"},
             "viewing.md");
}

void require_output(const ViewRequest& request) {
  const std::string& path = request.output;
  if (path != "-" && !path.ends_with(".html") && !path.ends_with(".htm")) {
    throw InputError("--output",
                     "the file name \"{}\" does not end in .html; give a name that ends in .html, or - for "
                     "standard output",
                     path);
  }
  require_other_file(request.file, path);
  if (request.flow) require_other_file(*request.flow, path);
}

/// Throws InputError if the page would be larger than max_bytes. The message states the value of --every that
/// makes it small enough.
void require_page_size(const TrajectoryFile& file, const PageOptions& options) {
  const double bytes = expected_bytes(file, options);
  if (bytes <= max_bytes) return;
  const double every = std::ceil(static_cast<double>(options.every) * bytes / max_bytes);
  throw InputError("--every",
                   "the page of {} frames would have {:.0f} MB, but browsers can open at most {:.0f} MB; "
                   "give --every {:.0f} or more",
                   select_frames(file.reader.frames(), options.every).size(), bytes / 1e6, max_bytes / 1e6,
                   every);
}

int run(int argc, const char* const* argv) {
  const auto program = make_program(
      "beadswim-view",
      "Writes a trajectory as a web page in one file, which works without a network. The page shows all "
      "beads in three dimensions over time, and the stroke, path and rotation of selected swimmers.");
  ViewRequest request;
  add_flags(*program, request);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  if (page.before_data == nullptr) throw InputError("page", page.build_error);  // built without it
  require_output(request);
  const TrajectoryFile file = open_trajectory(request.file);
  if (request.flow) request.options.flow = read_flow_arrows(*request.flow, file);
  require_page_size(file, request.options);
  write_text(request.output, page.before_data + page_data(file, request.options) + page.after_data);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-view", [&] { return run(argc, argv); });
}
