#include "periodic_line.hpp"

#include "beadswim/core/error.hpp"

namespace beadswim {

namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

void check(const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = box.lengths[axis];
    if (std::isfinite(length) && length > 0) continue;
    throw InputError("box", "the box length along {} is {:f}; the length must be finite and positive",
                     axis_names[axis], length);
  }
}

PeriodicLine::Axis transverse_axis(const Box& box, int axis, double place) {
  const double length = box.lengths[axis];
  if (!box.has_mirrors(axis)) return {.period = length, .mirror = 0};
  if (!(place > 0 && place < length)) {
    throw InputError("box",
                     "the line of spheres at {0} = {1:f} is not between the walls at {0} = 0 and {0} = "
                     "{2:f}; move the line or the walls",
                     axis_names[axis], place, length);
  }
  return {.period = 2 * length, .mirror = 2 * place};
}

/// Returns k^2 and a weight for each wavenumber k >= 0 of an axis below `longest` [1/length]. The weight is
/// the sum of cos(k d) over both signs of k, and over the line (d = 0) and its mirror copy at the distance d
/// along this axis.
std::vector<PeriodicLine::Wave> axis_waves(const PeriodicLine::Axis& axis, double longest) {
  std::vector<PeriodicLine::Wave> waves;
  const double spacing = 2 * std::numbers::pi / axis.period;
  for (int n = 0; n * spacing < longest; ++n) {
    const double k = n * spacing;
    const double copies = axis.mirror > 0 ? 1 + std::cos(k * axis.mirror) : 1;
    waves.push_back({.square = k * k, .weight = (n == 0 ? 1 : 2) * copies});
  }
  return waves;
}

/// Returns the squared distances along one axis from the line to its images within `cutoff` [length],
/// including the line itself [length^2].
std::vector<double> axis_images(const PeriodicLine::Axis& axis, double cutoff) {
  std::vector<double> squares;
  const auto add_lattice_of = [&](double offset) {
    const double last = std::floor((cutoff - offset) / axis.period);
    for (double n = std::ceil((-cutoff - offset) / axis.period); n <= last; ++n) {
      const double distance = offset + n * axis.period;
      squares.push_back(distance * distance);
    }
  };
  add_lattice_of(0);
  if (axis.mirror > 0) add_lattice_of(axis.mirror);
  return squares;
}

}  // namespace

PeriodicLine periodic_line(const Box& box, double y, double z) {
  check(box);
  // The splitting parameter is xi = 6/V^(1/3) for a box of volume V. About four images are then within the
  // distance 6/xi = V^(1/3), for any shape of the box.
  constexpr double splitting_of_unit_volume = 6;
  const double volume = box.lengths[0] * box.lengths[1] * box.lengths[2];
  return {.period = (box.has_mirrors(0) ? 2 : 1) * box.lengths[0],
          .y = transverse_axis(box, 1, y),
          .z = transverse_axis(box, 2, z),
          .splitting = splitting_of_unit_volume / std::cbrt(volume)};
}

std::vector<PeriodicLine::Wave> transverse_waves(const PeriodicLine& line) {
  const double longest = line.max_wavenumber();
  std::vector<PeriodicLine::Wave> waves;
  const auto z_waves = axis_waves(line.z, longest);
  for (const auto& y : axis_waves(line.y, longest)) {
    for (const auto& z : z_waves) {
      const double square = y.square + z.square;
      if (square < longest * longest) waves.push_back({square, y.weight * z.weight});
    }
  }
  return waves;
}

std::vector<double> image_lines(const PeriodicLine& line, double cutoff) {
  std::vector<double> squares;
  const auto z_squares = axis_images(line.z, cutoff);
  for (const double y2 : axis_images(line.y, cutoff)) {
    for (const double z2 : z_squares) {
      if (y2 + z2 <= cutoff * cutoff) squares.push_back(y2 + z2);
    }
  }
  return squares;
}

}  // namespace beadswim
