#pragma once

#include <algorithm>

#include "beadswim/core/dense_systems.hpp"

namespace beadswim {

/// Anderson's acceleration of a fixed-point iteration x <- g(x). The next x is a combination of the last
/// values of g that makes the change g - x smallest. Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715.
class AndersonMixing {
 public:
  /// Returns the next x. mapped: g(x).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& mapped) {
    const Eigen::VectorXd change = mapped - x;
    if (steps_ > 0) {
      const Eigen::Index column = (steps_ - 1) % depth;
      if (changes_.cols() <= column) {
        changes_.conservativeResize(x.size(), column + 1);
        images_.conservativeResize(x.size(), column + 1);
      }
      changes_.col(column) = change - last_change_;
      images_.col(column) = mapped - last_mapped_;
    }
    last_change_ = change;
    last_mapped_ = mapped;
    if (steps_++ == 0) return mapped;
    return mapped - images_ * least_squares(changes_, change);
  }

 private:
  static constexpr Eigen::Index depth = 5;
  Eigen::Index steps_ = 0;
  Eigen::MatrixXd changes_, images_;  // differences of successive changes and values of g
  Eigen::VectorXd last_change_, last_mapped_;
};

}  // namespace beadswim
