#include "flag_names.hpp"

#include <algorithm>
#include <array>

namespace beadswim {
namespace {

constexpr auto flags = std::to_array<NamedValue<Setting>>({
    {Setting::amplitude, "--amplitude"},
    {Setting::arm, "--arm"},
    {Setting::bead_boundary, "--bead-boundary"},
    {Setting::boundary, "--boundary"},
    {Setting::box, "--box"},
    {Setting::cells_per_radius, "--cells-per-radius"},
    {Setting::checkpoint_every, "--checkpoint-every"},
    {Setting::count, "--count"},
    {Setting::cycle, "--cycle"},
    {Setting::cycles, "--cycles"},
    {Setting::damping, "--damping"},
    {Setting::delay_correction, "--delay-correction"},
    {Setting::flow_every, "--flow-every"},
    {Setting::fraction, "--fraction"},
    {Setting::frame, "--frame"},
    {Setting::frames_per_cycle, "--frames-per-cycle"},
    {Setting::friction, "--friction"},
    {Setting::lubrication, "--lubrication"},
    {Setting::method, "--method"},
    {Setting::model, "--model"},
    {Setting::multipole_order, "--multipole-order"},
    {Setting::output, "-o"},
    {Setting::period, "--period"},
    {Setting::plan, "beadswim-run --plan"},
    {Setting::precision, "--precision"},
    {Setting::radius_correction, "--radius-correction"},
    {Setting::ranks, "mpirun -n"},
    {Setting::refinement, "--refine"},
    {Setting::relaxation_time, "--relaxation-time"},
    {Setting::repair, "--repair"},
    {Setting::restart, "--restart"},
    {Setting::reynolds_stress, "--reynolds-stress"},
    {Setting::seed, "--seed"},
    {Setting::sigma, "--sigma"},
    {Setting::steps_per_cycle, "--steps-per-cycle"},
    {Setting::stiffness, "--stiffness"},
    {Setting::stroke_record, "--stroke-from RUN.json"},
    {Setting::sum_tolerance, "--sum-tolerance"},
    {Setting::tolerance, "--tolerance"},
    {Setting::unbounded, "beadswim-layout swimmer --unbounded"},
    {Setting::viscosity, "--viscosity"},
});
static_assert(flags.size() == all_values<Setting>.size());

}  // namespace

std::string flag_of(Setting setting) {
  return std::string(std::ranges::find(flags, setting, &NamedValue<Setting>::value)->name);
}

}  // namespace beadswim
