#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/io/vti.hpp"
#include "beadswim/run/flow_request.hpp"
#include "beadswim/run/model.hpp"

namespace beadswim {

/// What a run remembers of its flow.
struct FlowState {
  std::vector<long> steps{};  ///< whose flow fields are listed
  long first = -1;            ///< of a mean: step at which it begins
  std::vector<char> places{};  ///< hash of swimmer and points that determine axes and sums
  /// Columns of the orientation of the swimmer of the frame, at the last flow; of the box: the unit vectors.
  std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  std::vector<PointFlow> sums{};  ///< of a mean, on rank 0: sum of flow times weight

  BEADSWIM_FIELDS(steps, first, places, axes, sums)
};

/// Throws InputError if the mean of a run that continues from a checkpoint began before it, and the run of
/// the checkpoint did not sum it up. `state`: of the flow in the checkpoint.
void require_sums(const FlowRequest& request, const ModelPlan& plan, const std::vector<char>& state);

/// Writes the flow of a run, in units of the layout. Fields on cells go to files TRAJECTORY.flow/STEP.vti,
/// which TRAJECTORY.flow.pvd lists for ParaView; the flow at points goes to TRAJECTORY.flow.csv. TRAJECTORY
/// is the path of the trajectory file. With several levels of cells of a lattice, each has its own file
/// STEP-N.vti, where N counts from the coarsest level, 0; cells under a finer level are hidden.
class FlowOutput {
 public:
  /// Creates the folder of the files. `path`: trajectory; `done`: last step of the earlier run whose files
  /// this run continues, or 0: flow of later steps is removed. Throws InputError if the folder cannot be
  /// created. Collective.
  FlowOutput(FlowRequest request, const ModelPlan& plan, const Layout& layout, const std::string& path,
             long done, const Communicator& communicator);

  /// Returns true if the flow at this step is needed.
  bool is_due(long step) const;
  /// Writes the flow at a step that is due, or adds it to the mean and writes that at the last step.
  /// Collective.
  void take(Model& model);

  /// Return the state for a checkpoint, on rank 0, and continue from that of one, which may be empty.
  std::vector<char> state() const;
  void restore(const std::vector<char>& bytes);

 private:
  Eigen::Matrix3d orientation() const;
  void move_frame(const Model& model);
  long sample_at(long step) const;
  long step_of_sample(long number) const;
  /// Returns the weight of sample `number` of the mean, by the trapezoidal rule over the period.
  double weight_of_sample(long number) const;
  /// Returns the files of a step.
  std::vector<PvdEntry> entries_of(long step) const;
  void write_index() const;  ///< lists the files, on rank 0
  void write_flow(long step, const std::vector<PointFlow>& flow);
  void remove_after(long done) const;  ///< removes flow fields of later steps, which this run rewrites
  void keep_rows_until(long done);     ///< likewise of the file of points

  FlowRequest request_;
  const ModelPlan& plan_;
  const Communicator& communicator_;
  std::string stem_;
  long done_;
  Domain domain_;
  long interval_ = 0;                ///< steps between flow fields
  long samples_ = 0;                 ///< number of samples of a mean
  Vec3 frame_place_ = Vec3::Zero();  ///< mean bead position of the swimmer of the frame
  int frame_swimmer_ = 0;            ///< index of the swimmer of the frame
  SwimmerType frame_type_;
  FlowState state_;
  std::string rows_;  ///< text of the file of points, on rank 0
};

}  // namespace beadswim
