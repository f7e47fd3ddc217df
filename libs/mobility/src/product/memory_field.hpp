#pragma once

#include <array>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/fluid_memory.hpp"
#include "imaged_spheres.hpp"
#include "mesh_transform.hpp"

namespace beadswim {

/// Sources of one degree of spheres of one radius, which have one form factor.
struct SourceClass {
  int degree = 0;
  double radius = 0;
};

/// Memory of the fluid in a periodic box (fluid_memory.hpp): its Fourier modes up to a cutoff wavenumber, on
/// the mesh of the forces. The Reynolds stress needs a finer mesh. Each rank has the modes of its part of the
/// Fourier transform.
///
/// The sources of each class are a field on the mesh. If the spheres have up to four radii, these are the
/// radii of the classes. The sources of more radii are divided among four radii by interpolation in the
/// square of the radius, which determines form factors at low wavenumbers.
class MemoryField {
 public:
  using Values = std::span<const std::array<FftwArray, 3>>;  ///< Fourier transforms of all classes

  /// `points`: numbers of mesh points along the axes. inverse_windows: 1 over the Fourier transform
  /// of the windows along each axis, by the magnitude of the index. `transform` must live as long as the
  /// object.
  MemoryField(const FluidMemory& fluid, const ImagedSpheres& spheres, const std::array<int, 3>& points,
              const std::array<std::vector<double>, 3>& inverse_windows, const MeshTransform& transform);

  const std::vector<SourceClass>& classes() const { return classes_; }
  /// Returns the share of a class in the source of a sphere of this degree. The shares of all classes of a
  /// degree sum to 1, their shares times their squared radii to the squared radius of the sphere.
  double share(std::size_t of_class, int sphere, int degree) const {
    if (classes_[of_class].degree != degree) return 0;
    return shares_[sphere * radii_ + of_class % radii_];
  }

  /// Returns the largest wavenumber of the modes (memory_cutoff()).
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
  /// Sets the flow at the end of the last step that its forces would not cause in a steady fluid, w, with the
  /// mean flow; zero before the first step.
  void set_remainder(std::array<FftwArray, 3>& values) const;

  /// State of the modes of this rank, in the order of the modes of all ranks.
  std::vector<double> state() const;
  void restore(std::span<const double> state);

 private:
  using Velocity = Eigen::Vector3cd;
  struct Mode {
    std::ptrdiff_t place, on_stress_mesh;  ///< indices in the arrays of the Fourier transforms
    Vec3 k;                ///< wavevector [1/length]
    double window;         ///< inverse of the Fourier transform of a window
    double unit;           ///< steady flow per force on the mesh
    double decay, delay;   ///< E, phi
    double ramp;           ///< (1 - phi)/(nu k^2 h)
  };
  void set_classes(const ImagedSpheres& spheres);
  void add_reynolds_stress();

  FluidMemory fluid_;
  const MeshTransform& transform_;
  MeshTransform stress_transform_;    ///< of the mesh on which the Reynolds stress is evaluated
  double scale_;                      ///< 1/number of mesh points
  std::size_t radii_ = 0;             ///< number of radii of classes
  std::vector<SourceClass> classes_;  ///< for each degree, all radii
  std::vector<double> shares_;        ///< of each sphere, for each radius
  double cutoff_ = 0;
  bool has_mean_ = false;  ///< true if this rank has the mode k = 0
  std::vector<Mode> modes_;
  std::vector<double> form_factors_;       ///< form factors of all classes, for each mode
  std::vector<Velocity> steady_;           ///< steady flow of the forces
  std::vector<Velocity> flow_;             ///< flow at the end of the last step
  Vec3 mean_flow_ = Vec3::Zero();          ///< at the end of the last step
  std::vector<Velocity> remaining_flow_;   ///< g, flow that earlier forces leave at the end of the next step
  std::vector<Velocity> previous_stress_;  ///< Reynolds stress at the end of the step before [force/volume]
  std::array<FftwArray, 6> velocity_and_curl_;  ///< velocity and vorticity on the mesh
};

}  // namespace beadswim
