#include "beadswim/plan/run_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "beadswim/core/joined.hpp"
#include "beadswim/io/fields_json.hpp"

namespace beadswim {
namespace {

constexpr const char* error_definition =
    "expected relative error of velocity (v) and arm amplitudes (arms) in the last cycle, once the stroke is "
    "periodic, compared with the same scene with inertia at infinitely fine resolution; estimated from the "
    "prediction inertia-corrected and from measured errors of lattice runs; error: limit, which 95 of 100 "
    "runs keep; typical error: root mean square over similar scenes";

std::string command(const RunPlan& plan, const PlannedRun& run) {
  return settings_text(run.settings, plan.request.chosen);
}

std::string percent(double share) {
  if (share == 0) return "-";
  return share < 10 ? fmt::format("{:.2g}", 100 * share) : "> 1000";
}

/// Returns the errors of the velocity and of the arm amplitudes [%]: two columns of the plan's table.
std::string error_columns(const ErrorEstimate& error) {
  return fmt::format("{:>7} {:>7}", percent(error.velocity), percent(error.largest_of_arms()));
}

/// Returns true if no other possible run is cheaper and has an expected error of at most 1.05 times the error
/// of `run`.
bool is_on_front(const RunPlan& plan, const PlannedRun& run) {
  constexpr double error_margin = 1.05;
  return std::ranges::none_of(plan.runs, [&](const PlannedRun& other) {
    return other.refused.empty() && other.core_seconds < run.core_seconds &&
           other.errors.limits.total.largest() <= error_margin * run.errors.limits.total.largest();
  });
}

/// Returns the error as JSON, without that of the velocity if no swimmer swims.
Json json_of(const ErrorEstimate& error) {
  Json json = error;
  if (error.velocity == 0) json.erase("velocity");
  return json;
}

Json json_of(const RunPlan& plan, const PlannedRun& run) {
  const LatticeSettings& lattice = run.settings.lattice;
  Json json{{"model", run.settings.model}, {"flags", command(plan, run)}};
  if (run.settings.model == RunModel::lbm) {
    json["resolution"] = {{"cells_per_radius", *lattice.cells_per_radius},
                          {"relaxation_time", *lattice.relaxation_time},
                          {"bead_boundary", lattice.bead_boundary},
                          {"precision", lattice.precision}};
    if (!run.cells.empty()) json["resolution"]["cells"] = run.cells;
  }
  if (!run.refused.empty()) json["refused"] = run.refused;
  if (run.core_seconds > 0) {
    json["cost"] = {{"core_seconds", run.core_seconds},
                    {"wall_seconds", run.core_seconds / plan.ranks},
                    {"memory_bytes", run.memory_bytes},
                    {"output_bytes", run.output_bytes}};
  }
  if (const double largest = run.errors.limits.total.largest(); largest > 0 && std::isfinite(largest)) {
    json["error"] = json_of(run.errors.limits.total);
    json["typical_error"] = json_of(run.errors.typical);
  }
  return json;
}

/// Returns a line for each combination of resolution and number of levels, with the cells of each level.
std::string cells_by_level(const std::vector<const PlannedRun*>& runs) {
  std::string text;
  std::set<std::string> listed;
  for (const PlannedRun* run : runs) {
    if (run->cells.size() < 2) continue;
    const std::string line =
        fmt::format("cells: {} {:g} {} {}: {}, coarsest level first\n", Setting::cells_per_radius,
                    *run->settings.lattice.cells_per_radius, Setting::refinement, run->cells.size() - 1,
                    joined(run->cells, " + "));
    if (listed.insert(line).second) text += line;
  }
  return text;
}

/// Returns the text as one word of a shell command.
std::string shell_word(const std::string& text) {
  if (std::regex_match(text, std::regex("[A-Za-z0-9_./+,:=@%-]+"))) return text;
  return "'" + std::regex_replace(text, std::regex("'"), R"('\'')") + "'";
}

/// Returns the command that writes the layout which a plan proposes instead of the present one.
std::string command_of(const Proposal& proposal, const std::string& layout) {
  const std::string command = "beadswim-layout reduce " + shell_word(layout);
  if (!proposal.box) return command;
  const Vec3& box = *proposal.box;
  return fmt::format("{} {} {},{},{}", command, Setting::box, box[0], box[1], box[2]);
}

}  // namespace

std::vector<std::string> refusals(const RunPlan& plan) {
  std::vector<const PlannedRun*> firsts;  // the first run of each reason
  std::map<std::string, int> runs;        // by reason, with # in place of numbers
  const std::regex number("[0-9][0-9.e+-]*");
  const auto kind = [&](const PlannedRun& run) { return std::regex_replace(run.refused, number, "#"); };
  for (const PlannedRun& run : plan.runs)
    if (!run.refused.empty() && ++runs[kind(run)] == 1) firsts.push_back(&run);
  std::vector<std::string> texts;
  for (const PlannedRun* run : firsts) {
    const int others = runs[kind(*run)] - 1;
    texts.push_back(
        fmt::format("{}{}: {}", command(plan, *run),
                    others > 0 ? fmt::format(", and {} similar run{}", others, others > 1 ? "s" : "") : "",
                    run->refused));
  }
  return texts;
}

std::string size_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", 1e-6 * bytes) : fmt::format("{:.3g} GB", 1e-9 * bytes);
}

std::string plan_head(const std::string& indent) {
  return fmt::format(
      "{0}  {1:<74} {2:>15} {3:>17} {4:>9} {5:>9} {6:>8} {7:>8}\n"
      "{0}  {8:<74} {9:>7} {10:>7} {9:>9} {10:>7} {11:>9} {12:>9}\n",
      indent, "", "error [%]", "typical error [%]", "cost", "time", "memory", "output", "run", "v", "arms",
      "core s", "s");
}

std::string plan_row(const RunPlan& plan, const PlannedRun& run, const std::string& remark) {
  return fmt::format("  {:<74} {}  {} {:>9.3g} {:>9.3g} {:>8} {:>8}  {}\n", command(plan, run),
                     error_columns(run.errors.limits.total), error_columns(run.errors.typical),
                     run.core_seconds, run.core_seconds / plan.ranks, size_text(run.memory_bytes),
                     size_text(run.output_bytes), remark);
}

std::string plan_table(const RunPlan& plan, const std::string& layout) {
  std::string text = plan_head();
  std::vector<const PlannedRun*> front;
  for (const PlannedRun& run : plan.runs) {
    if (run.refused.empty() && (run.settings.model != RunModel::lbm || is_on_front(plan, run)))
      front.push_back(&run);
  }
  std::ranges::sort(front, {}, &PlannedRun::core_seconds);
  const PlannedRun* choice = plan.choice ? &plan.runs[*plan.choice] : nullptr;
  for (const PlannedRun* run : front) text += plan_row(plan, *run, run == choice ? "<- cheapest" : "");
  if (const auto others = std::ranges::count(plan.runs, "", &PlannedRun::refused) - std::ssize(front))
    text += fmt::format(
        "not listed: {} lattice runs that cost more than a run with a similar or smaller error\n", others);
  if (plan.best && !choice)
    text += fmt::format("no run has an error limit within {}{}\n", in_percent(plan.tolerance),
                        plan.request.tolerance ? "" : fmt::format(", the default of {}", Setting::tolerance));
  text += cells_by_level(front) + fmt::format("error: {}\n", error_definition);
  for (const std::string& refusal : refusals(plan)) text += fmt::format("refused: {}\n", refusal);
  for (const std::string& hard : plan.hard) text += fmt::format("hard: {}\n", hard);
  for (const Proposal& proposal : plan.proposals)
    text += fmt::format("propose: {}: {}\n", command_of(proposal, layout), proposal.what);
  return text;
}

Json plan_to_json(const RunPlan& plan, const std::string& layout) {
  Json json{{"schema", "beadswim/plan/1"},
            {"tolerance", plan.tolerance},
            {"error_definition", error_definition},
            {"cycles", plan.request.settings.cycles},
            {"ranks", plan.ranks},
            {"choice", plan.choice ? Json(command(plan, plan.runs[*plan.choice])) : Json()},
            {"best", plan.best ? Json(command(plan, plan.runs[*plan.best])) : Json()},
            {"runs", Json::array()},
            {"hard", plan.hard},
            {"proposals", Json::array()}};
  for (const PlannedRun& run : plan.runs) json["runs"].push_back(json_of(plan, run));
  for (const Proposal& proposal : plan.proposals)
    json["proposals"].push_back({{"command", command_of(proposal, layout)}, {"what", proposal.what}});
  return json;
}

}  // namespace beadswim
