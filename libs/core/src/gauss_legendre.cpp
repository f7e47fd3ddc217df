#include "beadswim/core/gauss_legendre.hpp"

#include <boost/math/special_functions/legendre.hpp>

namespace beadswim {

std::vector<QuadratureNode> gauss_legendre(int count, double from, double to) {
  using namespace boost::math::policies;
  constexpr policy<promote_double<false>> in_double;
  std::vector<QuadratureNode> nodes;
  const auto add = [&](double zero) {
    const double slope = boost::math::legendre_p_prime(count, zero, in_double);
    nodes.push_back({.place = from + (to - from) * (1 + zero) / 2,
                     .weight = (to - from) / ((1 - zero * zero) * slope * slope)});
  };
  const std::vector<double> zeros =
      boost::math::legendre_p_zeros<double>(count, in_double);  // those >= 0, ascending
  for (auto zero = zeros.rbegin(); zero != zeros.rend(); ++zero) {
    if (*zero > 0) add(-*zero);
  }
  for (const double zero : zeros) add(zero);
  return nodes;
}

}  // namespace beadswim
