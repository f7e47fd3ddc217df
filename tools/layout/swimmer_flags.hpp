#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "beadswim/layout/layout.hpp"

namespace beadswim {

/// The flags that describe a swimmer, its fluid and its box, as text; empty where not given.
class SwimmerFlags {
 public:
  explicit SwimmerFlags(CLI::App& command);

  /// The preset's scene with the flags' values in place, or a scene of the flags alone. Throws InputError
  /// that names the flags that are missing.
  Layout layout() const;

 private:
  void add_swimmer(CLI::App& command);
  void add_driving(CLI::App& command);
  void add_scene(CLI::App& command);

  void require_complete() const;
  void apply_beads(SwimmerType& type, double default_density) const;
  void apply_springs(SwimmerType& type) const;
  void apply_driving(Driving& driving) const;
  void apply_fluid(Fluid& fluid) const;
  void apply_domain(std::optional<Domain>& domain) const;
  Units units() const;

  std::string preset_;
  std::string radius_, arm_, stiffness_, damping_, angular_stiffness_, bead_density_;
  std::string amplitude_, phase_, period_, frame_;
  std::string viscosity_, density_, units_;
  std::string box_, boundary_;
  bool unbounded_ = false;
  std::string position_, axis_;
};

}  // namespace beadswim
