#pragma once

#include <span>
#include <vector>

namespace beadswim {

/// Sources of one degree of spheres of one radius, on a mesh of their own: they have one form factor.
struct SourceClass {
  int degree = 0;
  double radius = 0;
};

/// Division of the sources of spheres among classes. If the spheres have up to four radii, these are the
/// radii of the classes. The sources of more radii are divided among four radii by interpolation in the
/// square of the radius, which determines form factors at low wavenumbers.
class SourceClasses {
 public:
  /// `radii`: of each sphere [length]; `highest_degree`: of the sources.
  SourceClasses(std::span<const double> radii, int highest_degree);

  std::size_t size() const { return classes_.size(); }
  const std::vector<SourceClass>& classes() const { return classes_; }

  /// Returns the share of a class in the source of a sphere of this degree. The shares of all classes of a
  /// degree sum to 1, their shares times their squared radii to the squared radius of the sphere.
  double share(std::size_t of_class, int sphere, int degree) const {
    if (classes_[of_class].degree != degree) return 0;
    return shares_[sphere * radii_ + of_class % radii_];
  }

 private:
  std::size_t radii_ = 0;             ///< number of radii
  std::vector<SourceClass> classes_;  ///< for each degree, all radii
  std::vector<double> shares_;        ///< of each sphere, for each radius
};

}  // namespace beadswim
