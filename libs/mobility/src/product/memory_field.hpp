#pragma once

#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/fluid_memory.hpp"
#include "mesh_transform.hpp"
#include "source_classes.hpp"

namespace beadswim {

/// Memory of the fluid in a periodic box (fluid_memory.hpp): its Fourier modes up to a cutoff wavenumber, on
/// the mesh of the forces. Each rank has the modes of its part of the Fourier transform.
///
/// The sources of each class (SourceClasses) are a field on the mesh.
class MemoryField {
 public:
  struct Law {
    FluidMemory fluid;
    double viscosity = 0;              ///< dynamic [mass/(length time)]
    Vec3 lengths;                      ///< edges of the periodic box [length]
    std::array<int, 3> points{};       ///< numbers of mesh points along the axes
    std::array<double, 3> exponent{};  ///< the Fourier transform of a window is exp(-sum exponent_a k_a^2)
    std::vector<SourceClass> classes;
  };
  using Values = std::span<const std::array<FftwArray, 3>>;  ///< Fourier transforms of all classes

  MemoryField(const Law& law, const MeshTransform& transform);

  /// Returns the cutoff: two thirds of the largest wavenumber of the mesh, so that products of two fields
  /// have no aliases below it.
  double cutoff() const { return cutoff_; }

  /// Reads the forces from the mesh, before a product replaces them by their flow.
  void read_forces(Values values);
  /// Adds to the flow on the mesh the change that the delay of the fluid in a time step causes, and the flow
  /// that earlier forces have left, if `with_memory`.
  void add_flow(Values values, bool with_memory) const;
  /// Sets the fluid at rest. The forces that were read begin to act.
  void start();
  /// Ends a time step. The forces that were read act at its end. `mean_flow`: velocity of the mode k = 0
  /// [length/time].
  void end_step(const Vec3& mean_flow);

  /// State of the modes of this rank, in the order of the modes of all ranks.
  std::vector<double> state() const;
  void restore(std::span<const double> state);

 private:
  using Velocity = Eigen::Vector3cd;
  struct Mode {
    std::ptrdiff_t place;  ///< index in the array of the Fourier transform
    Vec3 k;                ///< wavevector [1/length]
    double window;         ///< inverse of the Fourier transform of a window
    double unit;           ///< steady flow per force on the mesh
    double decay, delay;   ///< E, phi
    double ramp;           ///< (1 - phi)/(nu k^2 h)
  };
  void add_reynolds_stress(std::span<const Velocity> flow, const Vec3& mean_flow);

  Law law_;
  const MeshTransform& transform_;
  double cutoff_ = 0;
  bool has_mean_ = false;  ///< true if this rank has the mode k = 0
  std::vector<Mode> modes_;
  std::vector<double> form_factors_;       ///< form factors of all classes, for each mode
  std::vector<Velocity> steady_;           ///< steady flow of the forces
  std::vector<Velocity> remaining_flow_;   ///< g, flow that earlier forces leave at the end of the next step
  std::vector<Velocity> previous_stress_;  ///< Reynolds stress at the end of the step before [force/volume]
  std::array<FftwArray, 6> velocity_and_curl_;  ///< velocity and vorticity on the mesh
};

}  // namespace beadswim
