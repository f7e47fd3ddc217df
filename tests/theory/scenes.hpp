#pragma once

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <variant>

#include "beadswim/theory/methods.hpp"
#include "swimmers.hpp"

// Swimmers in boxes, and what to read off a prediction.

namespace beadswim {

/// Alone in a box of fluid of density 1, its middle bead at `middle`; the first axis is the swimmer's.
inline Question ask_in_box(const CollinearSwimmer& swimmer, const Box& box,
                           const std::array<double, 3>& middle) {
  Question question = ask(swimmer);
  question.box = BoxPlace{.box = box, .middle_bead = middle};
  return question;
}

/// The same with its middle bead in the middle of the box.
inline Question ask_in_box(const CollinearSwimmer& swimmer, const Box& box) {
  return ask_in_box(swimmer, box, {box.lengths[0] / 2, box.lengths[1] / 2, box.lengths[2] / 2});
}

inline Box periodic_box(double x, double y, double z) {
  return {.lengths = {x, y, z}, .boundary = {}};
}

inline Box walled_box(double x, double y, double z) {
  return {.lengths = {x, y, z}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}};
}

inline Prediction predicted(const std::string& method, const Question& question) {
  return predict(find_method(method), question);
}

/// A number among a prediction's settings. Throws if there is none of that name.
inline double setting(const Prediction& prediction, const std::string& name) {
  for (const auto& [key, value] : prediction.settings) {
    if (key == name) return std::get<double>(value);
  }
  throw std::out_of_range(name);
}

/// A method's name as a test's: without hyphens.
inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

inline CollinearSwimmer with_density(CollinearSwimmer swimmer, double density) {
  swimmer.density = {density, density, density};
  return swimmer;
}

inline CollinearSwimmer with_amplitude(CollinearSwimmer swimmer, double amplitude) {
  for (double& force : swimmer.amplitude) force *= amplitude;
  return swimmer;
}

}  // namespace beadswim
