#include "command_line/request.hpp"

#include <filesystem>
#include <system_error>

#include "beadswim/core/error.hpp"
#include "beadswim/tools/program.hpp"
#include "checkpoints.hpp"

namespace beadswim {
namespace {

/// Returns the layout as JSON text, by which two layouts can be compared.
std::string scene_text(const LayoutDocument& document) {
  return dump_json(layout_to_json({.layout = document.layout}));
}

/// Returns the absolute path, which different names of a file share.
std::filesystem::path absolute_path(const std::string& path) {
  std::error_code fault;
  const auto absolute = std::filesystem::weakly_canonical(std::filesystem::absolute(path, fault), fault);
  return fault ? std::filesystem::path(path) : absolute;
}

}  // namespace

bool Request::continues_same_trajectory() const {
  return checkpoint && absolute_path(trajectory_of(checkpoint->path())) == absolute_path(options.output);
}

std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator) {
  Request request;
  auto parsed = parse_run_options(argc, argv);
  if (const int* status = std::get_if<int>(&parsed)) return *status;
  request.options = std::get<RunOptions>(parsed);
  if (request.options.restart.empty()) return request;
  request.checkpoint = open_checkpoint(request.options.restart, communicator);
  const FlagValues flags = flags_of(*request.checkpoint);
  request.options = std::get<RunOptions>(parse_run_options(argc, argv, flags));
  require_same_result_flags(request.options, flags);
  if (request.options.output.empty()) request.options.output = trajectory_of(request.checkpoint->path());
  request.steps_done = steps_done_in(*request.checkpoint);
  return request;
}

LayoutDocument read_layout(const Request& request, const std::optional<std::string>& given) {
  const auto parse = [](const std::string& text, const std::string& name) {
    return layout_from_json(parse_json(text, name), name);
  };
  if (given) require_other_file(request.options.layouts.front(), request.options.output);
  if (!request.checkpoint) return parse(given.value(), request.source());
  const LayoutDocument kept = parse(layout_of(*request.checkpoint), request.checkpoint->path());
  if (given && scene_text(parse(*given, request.source())) != scene_text(kept)) {
    throw InputError(request.source(),
                     "this layout is not the layout of the checkpoint's run; leave the layout out, or begin "
                     "without --restart");
  }
  return kept;
}

}  // namespace beadswim
