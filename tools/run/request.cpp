#include "request.hpp"

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/tools/program.hpp"
#include "one_run.hpp"

namespace beadswim {
namespace {

/// Returns the layout as JSON text, by which two layouts can be compared.
std::string scene_text(const LayoutDocument& document) {
  return dump_json(layout_to_json({.layout = document.layout}));
}

}  // namespace

std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator) {
  Request request;
  auto parsed = parse_run_options(argc, argv);
  if (const int* status = std::get_if<int>(&parsed)) return *status;
  request.options = std::get<RunOptions>(parsed);
  if (request.options.restart.empty()) return request;
  request.checkpoint = open_checkpoint(request.options.restart, print_message, communicator);
  const RunSettings settings = settings_of(*request.checkpoint);
  request.options = std::get<RunOptions>(parse_run_options(argc, argv, settings));
  require_same_results(request.options.settings, settings);
  if (request.options.output.empty()) request.options.output = trajectory_of(request.checkpoint->path());
  return request;
}

GivenLayouts read_layouts(const Request& request, const Communicator& communicator) {
  const RunOptions& options = request.options;
  GivenLayouts given;
  run_on_root(
      [&] {
        if (request.checkpoint && !options.names_layouts) return;
        DocumentStream documents(options.layouts);
        given.is_stream = !documents.is_single() || options.output.find(number_mark) != std::string::npos;
        given.layouts = StoredStream(documents, [&](const StreamMember& member) {
          if (given.is_stream) layout_of(member);
        });
      },
      communicator);
  given.layouts.share(communicator);
  MPI_Bcast(&given.is_stream, 1, MPI_C_BOOL, 0, communicator.get());
  return given;
}

LayoutDocument read_layout(const Request& request, const StoredStream& layouts) {
  const auto parse = [](const std::string& text, const std::string& name) {
    return layout_from_json(parse_json(text, name), name);
  };
  const bool is_given = layouts.size() > 0;
  if (is_given) require_other_file(request.options.layouts.front(), request.options.output);
  if (!request.checkpoint) return parse(layouts.member(1).text, request.source());
  const LayoutDocument kept = parse(layout_of(*request.checkpoint), request.checkpoint->path());
  if (is_given && scene_text(parse(layouts.member(1).text, request.source())) != scene_text(kept)) {
    throw InputError(request.source(),
                     "this layout is not the layout of the checkpoint's run; leave the layout out, or begin "
                     "without --restart");
  }
  return kept;
}

}  // namespace beadswim
