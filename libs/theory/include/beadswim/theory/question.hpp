#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"

namespace beadswim {

/// Position of a swimmer in a box, from the corner of the box [length].
struct BoxPlace {
  Box box;  ///< of three beads on a line: with the first axis parallel to the swimmer
  std::array<double, 3>
      middle_bead{};  ///< position of bead 2 at rest; of another shape, of the mean of its beads
};

/// Box around a swimmer. `box` is set if the swimmer is alone in a box that theory can treat. `obstacle` is
/// set in any other box. It is the reason why methods for boxes cannot treat the swimmer. In open space,
/// `box` is nullopt and `obstacle` is empty.
struct Surroundings {
  std::optional<BoxPlace> box{};
  std::string obstacle{};
};

/// Return the box of one swimmer of the layout, or the reason why theory cannot treat the box: of three beads
/// on a line, and of a swimmer of another shape, whose beads have their mean at `place`.
Surroundings surroundings_of(const Layout& layout, const Swimmer& swimmer);
Surroundings surroundings_of_shape(const Layout& layout, const Vec3& place, NetForce net_force);

/// Motion of the swimmer in exact Stokes flow of its three beads in open space: the reference for the errors
/// of all methods.
struct ExactStokes {
  CollinearMobility mobility;   ///< mobility of the beads at rest
  PeriodicMotion motion;        ///< motion to second order in the driving amplitude
  double amplitude_change = 0;  ///< estimated relative change of the swimmer's velocity at finite amplitude
};

/// Exact motion with inertia in unbounded fluid, and the flow from which it follows.
struct ExactInertia {
  UnsteadyMultipoles flow;
  ExactMotion motion;
  double numerical_error = 0;  ///< change of the velocity from a coarser resolution [length/time]
};

/// Velocity of a swimmer of another shape to second order in amplitude, in open space or over a wall: the
/// reference for the errors of methods for shapes.
struct ShapeReference {
  Vec3 velocity = Vec3::Zero();  ///< with force moments up to order 2; zero if only roundoff [length/time]
  double error = 0;              ///< its difference from that with moments up to order 1 [length/time]
};

/// The result of a calculation, or the error that ended it.
template <class T>
class ResultOrError {
 public:
  explicit ResultOrError(const auto& compute) {
    try {
      value_ = compute();
    } catch (const std::runtime_error&) {  // InputError or SolverError
      error_ = std::current_exception();
    }
  }

  explicit operator bool() const { return value_.has_value(); }
  /// Return the result, or throw the error.
  const T& operator*() const {
    if (error_) std::rethrow_exception(error_);
    return *value_;
  }
  const T* operator->() const { return &**this; }

 private:
  std::optional<T> value_{};
  std::exception_ptr error_{};
};

/// A swimmer as theory treats it: three beads that stay on a line, or any other shape.
using TheorySwimmer = std::variant<CollinearSwimmer, ShapedSwimmer>;

/// Input of all methods: a swimmer, its fluid, its surroundings, and its stroke if it was measured.
class Question {
 public:
  /// `fluid_density`: rho [mass/length^3]. `units`: of the question, in the units of the layout, for texts.
  Question(TheorySwimmer swimmer, double fluid_density, const UnitScales& units = {});

  bool is_line() const { return std::holds_alternative<CollinearSwimmer>(swimmer_); }
  const CollinearSwimmer& line() const { return std::get<CollinearSwimmer>(swimmer_); }
  const ShapedSwimmer& shape() const { return std::get<ShapedSwimmer>(swimmer_); }
  double fluid_density() const { return fluid_density_; }
  const UnitScales& units() const { return units_; }

  // Motions of three beads on a line in open space: in exact Stokes flow to second order in amplitude, exact
  // with inertia, and in exact Stokes flow at finite amplitude; and the reference for another shape. They do
  // not depend on the members below. Each is computed when it is first asked for; copies of the question
  // share it.
  const ResultOrError<ExactStokes>& exact() const;
  const ResultOrError<ExactInertia>& inertia() const;
  const ResultOrError<PeriodicMotion>& finite() const;
  const ResultOrError<ShapeReference>& reference() const;

  Surroundings surroundings{};
  std::optional<Stroke> measured_stroke{};

 private:
  struct Motions {
    std::optional<ResultOrError<ExactStokes>> exact;
    std::optional<ResultOrError<ExactInertia>> inertia;
    std::optional<ResultOrError<PeriodicMotion>> finite;
    std::optional<ResultOrError<ShapeReference>> reference;
  };

  TheorySwimmer swimmer_;
  double fluid_density_;
  UnitScales units_;
  std::shared_ptr<Motions> motions_;
};

/// Returns the mobility of the beads at `positions` [length] in exact Stokes flow in open space [time/mass].
/// `tolerance`: relative error of the mobility at which the multipole series is truncated.
CollinearMobility exact_mobility(const CollinearSwimmer& swimmer, const LinePositions& positions,
                                 double tolerance = 1e-12);

/// Returns warnings that concern all methods for three beads on a line. They report beads that touch during
/// the stroke, and driving so strong that the relative error of second-order methods exceeds `tolerance`.
std::vector<std::string> warnings(const Question& question, double tolerance);

}  // namespace beadswim
