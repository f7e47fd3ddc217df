#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/tools/program.hpp"
#include "checkpoints.hpp"
#include "memory.hpp"
#include "record.hpp"
#include "run_loop.hpp"
#include "scene_facts.hpp"
#include "stop_signal.hpp"
#include "velocity_roundoff.hpp"
#include "warnings.hpp"

namespace {

using namespace beadswim;

constexpr const char* program_name = "beadswim-run";

/// The solver failed, results intact: known to every rank.
class RunFailed : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Standard input belongs to rank 0: it reads the text, all ranks get it.
std::string read_text_once(const std::string& path, const Communicator& communicator) {
  std::string text, failure;
  if (communicator.is_root()) {
    try {
      text = read_text(path);
    } catch (const InputError& error) {
      failure = error.what();
    }
  }
  for (std::string* shared : {&text, &failure}) {
    std::int64_t size = std::ssize(*shared);
    MPI_Bcast(&size, 1, MPI_INT64_T, 0, communicator.get());
    shared->resize(size);
    MPI_Bcast(shared->data(), static_cast<int>(size), MPI_CHAR, 0, communicator.get());
  }
  if (!failure.empty()) throw InputError(failure);
  return text;
}

TrajectoryHeader header_of(const LayoutDocument& document, const SceneOnLattice& on_lattice) {
  TrajectoryHeader header;
  const Box box = box_of(document.layout);
  header.box_lengths = box.lengths;
  header.periodic = box.periodic;
  for (const CoupledScene::Swimmer& swimmer : on_lattice.scene.swimmers) {
    for (int b = 0; b < 3; ++b) {
      header.swimmer.push_back(swimmer.id);
      header.bead.push_back(b + 1);
      header.radius.push_back(on_lattice.scene.types[swimmer.type].beads[b].radius *
                              on_lattice.lattice.scales.cell);
    }
  }
  header.creator_version = version() + " (" + revision() + ")";
  header.parameters["layout"] = dump_json(layout_to_json(document));
  return header;
}

void announce(const SceneOnLattice& on_lattice, const Communicator& communicator) {
  const Index3& cells = on_lattice.scene.cells;
  const LatticeChoice& lattice = on_lattice.lattice;
  tell(fmt::format(
      "beadswim-run: {} x {} x {} cells of {:.6g}, step {:.6g}, tau {:.6g}, {} steps a cycle, {} "
      "swimmers, {} precision, {:.2g} GB on {} ranks\n",
      cells[0], cells[1], cells[2], lattice.scales.cell, lattice.scales.step, lattice.relaxation_time,
      lattice.steps_per_period, on_lattice.scene.swimmers.size(), name_of(on_lattice.scene.precision),
      1e-9 * lattice_bytes(on_lattice.scene), communicator.size()));
}

/// For a failure that may be known to this rank alone: it speaks, and takes the others with it.
[[noreturn]] void stop_all_ranks(const Communicator& communicator) {
  report_current_exception(program_name);
  MPI_Abort(communicator.get(), static_cast<int>(ExitStatus::failed));
  std::abort();
}

void tell_how_to_go_on(const Checkpoints& checkpoints) {
  if (checkpoints.last().empty()) return;
  tell(fmt::format("{}: the state is kept: --restart {}\n", program_name, checkpoints.last()));
}

void require_steps_left(const SceneOnLattice& on_lattice, const RunOptions& options, long done) {
  if (done == 0 || done < total_steps(on_lattice, options)) return;
  throw InputError(
      "--cycles",
      fmt::format("{} are behind this checkpoint, of cycle {:.6g}; ask for more", options.cycles,
                  static_cast<double>(done) / static_cast<double>(on_lattice.lattice.steps_per_period)));
}

void print_record(const RunRecord& record, const RunOptions& options) {
  const auto provenance = options.with_provenance ? RecordProvenance::written : RecordProvenance::left_out;
  write_text("-", dump_json(run_record_to_json(record, provenance)));
}

/// The command line, and what it goes on from.
struct Request {
  RunOptions options;
  std::unique_ptr<CheckpointReader> checkpoint;  ///< none: it begins anew
};

/// An exit status if --help or --version was all that was asked for. Throws InputError.
std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator) {
  Request request;
  auto parsed = parse_run_options(argc, argv);
  if (const int* status = std::get_if<int>(&parsed)) return *status;
  request.options = std::get<RunOptions>(parsed);
  if (request.options.restart.empty()) return request;
  request.checkpoint = open_checkpoint(request.options.restart, communicator);
  const FlagValues flags = flags_of(*request.checkpoint);
  request.options = std::get<RunOptions>(parse_run_options(argc, argv, flags));
  require_same_course(request.options, flags);
  if (request.options.output.empty()) request.options.output = trajectory_of(request.checkpoint->path());
  return request;
}

/// Whether the run goes on under the name that its checkpoint's had.
bool goes_on_there(const Request& request, const RunOptions& options) {
  return request.checkpoint && trajectory_of(request.checkpoint->path()) == options.output;
}

/// A layout as a run sees it, whatever made it.
std::string scene_text(LayoutDocument document) {
  document.provenance = Json::array();
  return dump_json(layout_to_json(document));
}

/// The layout, or the checkpoint's, which a layout that is given must be.
LayoutDocument read_layout(const Request& request, const std::string& source,
                           const Communicator& communicator) {
  const RunOptions& options = request.options;
  const auto parse = [](const std::string& text, const std::string& name) {
    return layout_from_json(parse_json(text, name), name);
  };
  if (!request.checkpoint) return parse(read_text_once(options.layout, communicator), source);
  const LayoutDocument kept = parse(layout_of(*request.checkpoint), request.checkpoint->path());
  if (options.given.contains("LAYOUT") &&
      scene_text(parse(read_text_once(options.layout, communicator), source)) != scene_text(kept)) {
    throw InputError(
        source, "is not the layout of the checkpoint's run; leave it out, or begin anew without --restart");
  }
  return kept;
}

/// Throws InputError alike on all ranks while nothing has begun.
int run(int argc, char** argv, const Communicator& communicator) {
  const double start = MPI_Wtime();
  auto read = read_request(argc, argv, communicator);
  if (const int* status = std::get_if<int>(&read)) return *status;
  Request& request = std::get<Request>(read);
  RunOptions options = request.options;
  if (!request.checkpoint || options.given.contains("LAYOUT"))
    require_other_file(options.layout, options.output);
  const std::string source = options.layout == "-" ? "standard input" : options.layout;
  const LayoutDocument document = read_layout(request, source, communicator);
  const SceneOnLattice on_lattice = put_on_lattice(document.layout, options, source);
  options.cells_per_radius = on_lattice.cells_per_radius;
  options.relaxation_time = on_lattice.asked_relaxation_time;
  require_memory(on_lattice.scene, communicator);
  const long done = request.checkpoint ? steps_in(*request.checkpoint) : 0;
  require_steps_left(on_lattice, options, done);
  Progress progress(options.progress, done, total_steps(on_lattice, options),
                    static_cast<double>(on_lattice.lattice.steps_per_period),
                    on_lattice.scene.cells.cast<double>().prod());
  const double roundoff =
      velocity_roundoff(on_lattice.scene, on_lattice.lattice.steps_per_period,
                        total_steps(on_lattice, options));  // may fail: on all ranks alike
  if (communicator.is_root()) {
    if (options.progress != ProgressStyle::none) announce(on_lattice, communicator);
    if (request.checkpoint && options.progress != ProgressStyle::none)
      tell(fmt::format("{}: going on from {}, step {}\n", program_name, request.checkpoint->path(), done));
    warn(on_lattice, roundoff);
  }

  CoupledSystem system(on_lattice.scene, communicator);
  std::unique_ptr<FlowOutput> flow;
  if (options.flow_every) {
    flow = std::make_unique<FlowOutput>(options.output, on_lattice.lattice.scales,
                                        steps_between(on_lattice, *options.flow_every),
                                        goes_on_there(request, options) ? done : 0, communicator);
  }
  TrajectoryWriter trajectory(options.output, header_of(document, on_lattice), communicator,
                              request.checkpoint.get());
  Recorder recorder(on_lattice, document.layout, options.frames_per_cycle, trajectory, communicator);
  Checkpoints checkpoints(options, dump_json(layout_to_json(document)),
                          request.checkpoint ? request.checkpoint->path() : "", communicator);
  const RunParts parts{start, communicator, system, trajectory, recorder, checkpoints, flow.get(), progress};
  catch_stop_signals();
  RunOutcome outcome;
  try {
    std::optional<RunPast> past;
    if (request.checkpoint) past = restore(system, recorder, *request.checkpoint, communicator);
    request.checkpoint.reset();  // its room on the disk is free when another takes its place
    outcome = run_to_end(parts, on_lattice, options, past);
    const RunRecord record = make_record(parts, on_lattice, document, outcome, options);
    trajectory.finish();
    if (communicator.is_root()) print_record(record, options);
  } catch (...) {  // before the trajectory is closed, which all ranks would have to do together
    tell_how_to_go_on(checkpoints);
    stop_all_ranks(communicator);
  }
  const double mach = system.largest_bead_speed() * std::sqrt(3.0);
  if (communicator.is_root()) {
    warn_if_fast(mach);
    if (outcome.status == RunStatus::stopped_time || outcome.status == RunStatus::stopped_signal)
      tell_how_to_go_on(checkpoints);
  }
  if (outcome.status == RunStatus::failed) throw RunFailed(outcome.reason);
  if (outcome.status != RunStatus::finished) throw StoppedEarly(outcome.reason);
  return static_cast<int>(ExitStatus::fine);
}

/// Wrong input, faults of a run and early stops are known to every rank: rank 0 speaks, all leave.
int report_failure(const Communicator& communicator) {
  try {
    throw;
  } catch (const InputError&) {
    return communicator.is_root() ? report_current_exception(program_name)
                                  : static_cast<int>(ExitStatus::bad_input);
  } catch (const RunFailed&) {
    return communicator.is_root() ? report_current_exception(program_name)
                                  : static_cast<int>(ExitStatus::failed);
  } catch (const StoppedEarly&) {
    return communicator.is_root() ? report_current_exception(program_name)
                                  : static_cast<int>(ExitStatus::stopped_early);
  } catch (...) {
    stop_all_ranks(communicator);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(&argc, &argv);
  const Communicator communicator(MPI_COMM_WORLD);
  if (!communicator.is_root() && std::freopen("/dev/null", "w", stdout) == nullptr) return 3;
  try {
    return run(argc, argv, communicator);
  } catch (...) {
    return report_failure(communicator);
  }
}
