#include "cvode_swarm.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <Eigen/Dense>
#include <memory>
#include <string>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;

/// Returns the forces of springs without drives.
Vector9 spring_forces_of(const SwimmerType& type, const Vector9& x) {
  const BeadVectors beads = x.reshaped(3, 3);
  const BeadVectors forces =
      bond_forces(type, 0, beads, BeadVectors::Zero(3, 3)) + angle_forces(type, 0, beads);
  return forces.reshaped();
}

/// Returns the stiffness matrix -dF/dx of a swimmer by central differences.
Matrix9 stiffness_of(const SwimmerType& type, const Vector9& x) {
  const double step = 1e-5 * type.bonds[0].rest_length;
  Matrix9 stiffness;
  for (int c = 0; c < 9; ++c) {
    const Vector9 displacement = step * Vector9::Unit(c);
    stiffness.col(c) =
        (spring_forces_of(type, x - displacement) - spring_forces_of(type, x + displacement)) / (2 * step);
  }
  return stiffness;
}

/// Returns the mobility of a swimmer alone in open space, for any model of the scene. It is used as
/// preconditioner.
Matrix9 mobility_of(const SwimmerType& type, const Vector9& x, double viscosity) {
  Matrix9 mobility;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 d = x.segment<3>(3 * i) - x.segment<3>(3 * j);
      const double distance = d.norm();
      const PairTensor tensor =
          rotne_prager_tensor(type.beads[i].radius, type.beads[j].radius, distance, viscosity);
      for (int a = 0; a < 3; ++a)
        mobility.block<3, 1>(3 * i, 3 * j + a) = tensor.apply(d, distance, Vec3::Unit(a));
    }
  }
  return mobility;
}

/// The right-hand side dy/dt of the displacements y since the start, and the products that CVODE needs.
class SwarmRates {
 public:
  explicit SwarmRates(const OverdampedScene& scene)
      : scene_(scene),
        world_(MPI_COMM_WORLD),
        start_(start_positions(scene)),
        product_({scene.model, scene.viscosity, scene.domain, bead_radii(scene), scene.tolerance}, start_,
                 world_),
        preconditioner_(scene.swimmers.size()) {}

  std::size_t unknowns() const { return 3 * start_.size(); }
  long products() const { return products_; }

  Beads positions(const double* y) const {
    Beads places = start_;
    for (std::size_t b = 0; b < places.size(); ++b) places[b] += Eigen::Map<const Vec3>(y + 3 * b);
    return places;
  }

  void velocities(double time, const double* y, double* result) {
    const Beads places = positions(y);
    Beads forces(places.size());
    for (std::size_t s = 0; s < scene_.swimmers.size(); ++s) {
      const SwimmerType& type = scene_.type_of(scene_.swimmers[s]);
      const Vector9 x = own(places, s);
      const BeadVectors driving =
          driving_forces(type, time, x.reshaped(3, 3), scene_.swimmers[s].orientation);
      Eigen::Map<Vector9>(forces[3 * s].data()) = spring_forces_of(type, x) + driving.reshaped();
    }
    multiply(places, forces, result);
  }

  /// Computes the product -mu K z: mobility mu, stiffness K, vector z.
  void relax(const double* y, const double* z, double* result) {
    const Beads places = positions(y);
    Beads forces(places.size());
    for (std::size_t s = 0; s < scene_.swimmers.size(); ++s)
      Eigen::Map<Vector9>(forces[3 * s].data()) =
          -stiffness_of(scene_.type_of(scene_.swimmers[s]), own(places, s)) *
          Eigen::Map<const Vector9>(z + 9 * s);
    multiply(places, forces, result);
  }

  void prepare_preconditioner(const double* y, double gamma) {
    const Beads places = positions(y);
    for (std::size_t s = 0; s < scene_.swimmers.size(); ++s) {
      const SwimmerType& type = scene_.type_of(scene_.swimmers[s]);
      const Vector9 x = own(places, s);
      preconditioner_[s].compute(Matrix9::Identity() +
                                 gamma * mobility_of(type, x, scene_.viscosity) * stiffness_of(type, x));
    }
  }

  void precondition(const double* r, double* z) const {
    for (std::size_t s = 0; s < preconditioner_.size(); ++s)
      Eigen::Map<Vector9>(z + 9 * s) = preconditioner_[s].solve(Eigen::Map<const Vector9>(r + 9 * s));
  }

 private:
  static Vector9 own(const Beads& places, std::size_t swimmer) {
    return Eigen::Map<const Vector9>(places[3 * swimmer].data());
  }

  void multiply(const Beads& places, const Beads& forces, double* result) {
    Beads velocities(places.size());
    product_.set_positions(places);
    product_.apply(forces, velocities);
    ++products_;
    for (std::size_t b = 0; b < places.size(); ++b) Eigen::Map<Vec3>(result + 3 * b) = velocities[b];
  }

  const OverdampedScene& scene_;
  Communicator world_;
  Beads start_;
  Mobility product_;
  std::vector<Eigen::PartialPivLU<Matrix9>> preconditioner_;
  long products_ = 0;
};

double* data_of(N_Vector vector) {
  return N_VGetArrayPointer(vector);
}

int right_hand_side(realtype time, N_Vector y, N_Vector result, void* swarm) {
  static_cast<SwarmRates*>(swarm)->velocities(time, data_of(y), data_of(result));
  return 0;
}

int jacobian_times(N_Vector z, N_Vector result, realtype, N_Vector y, N_Vector, void* swarm, N_Vector) {
  static_cast<SwarmRates*>(swarm)->relax(data_of(y), data_of(z), data_of(result));
  return 0;
}

int set_up_preconditioner(realtype, N_Vector y, N_Vector, booleantype, booleantype* is_new, realtype gamma,
                          void* swarm) {
  static_cast<SwarmRates*>(swarm)->prepare_preconditioner(data_of(y), gamma);
  *is_new = SUNTRUE;
  return 0;
}

int solve_preconditioner(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype, realtype, int,
                         void* swarm) {
  static_cast<const SwarmRates*>(swarm)->precondition(data_of(r), data_of(z));
  return 0;
}

void require(int flag, const char* what) {
  if (flag < 0) throw SolverError(std::string(what) + " returned " + std::to_string(flag));
}

/// Owner of the memory that CVODE allocates.
class Solver {
 public:
  Solver(SwarmRates& swarm, const CvodeSettings& settings) {
    require(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
    displacements_ = N_VNew_Serial(static_cast<sunindextype>(swarm.unknowns()), context_);
    N_VConst(0, displacements_);
    constexpr int krylov_vectors = 30;
    linear_ = SUNLinSol_SPGMR(displacements_, SUN_PREC_LEFT, krylov_vectors, context_);
    memory_ = CVodeCreate(CV_BDF, context_);
    require(CVodeInit(memory_, right_hand_side, 0, displacements_), "CVodeInit");
    require(CVodeSetUserData(memory_, &swarm), "CVodeSetUserData");
    require(CVodeSStolerances(memory_, settings.relative, settings.absolute), "CVodeSStolerances");
    require(CVodeSetMaxNumSteps(memory_, 1'000'000), "CVodeSetMaxNumSteps");
    require(CVodeSetLinearSolver(memory_, linear_, nullptr), "CVodeSetLinearSolver");
    require(CVodeSetPreconditioner(memory_, set_up_preconditioner, solve_preconditioner),
            "CVodeSetPreconditioner");
    if (settings.jacobian == CvodeJacobian::springs)
      require(CVodeSetJacTimes(memory_, nullptr, jacobian_times), "CVodeSetJacTimes");
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    CVodeFree(&memory_);
    SUNLinSolFree(linear_);
    N_VDestroy(displacements_);
    SUNContext_Free(&context_);
  }

  /// Advances to the time `end` and returns the displacements there.
  const double* advance(double end) {
    require(CVodeSetStopTime(memory_, end), "CVodeSetStopTime");
    double time = 0;
    require(CVode(memory_, end, displacements_, &time, CV_NORMAL), "CVode");
    return data_of(displacements_);
  }

  long steps() const {
    long steps = 0;
    CVodeGetNumSteps(memory_, &steps);
    return steps;
  }

 private:
  SUNContext context_ = nullptr;
  N_Vector displacements_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  void* memory_ = nullptr;
};

}  // namespace

CvodeResult by_cvode(const OverdampedScene& scene, double end, const CvodeSettings& settings) {
  SwarmRates swarm(scene);
  Solver solver(swarm, settings);
  const double* displacements = solver.advance(end);
  return {.positions = swarm.positions(displacements), .products = swarm.products(), .steps = solver.steps()};
}

}  // namespace beadswim
