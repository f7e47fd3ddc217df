#pragma once

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <variant>

#include "beadswim/theory/methods.hpp"
#include "swimmers.hpp"

// Helper functions for tests: swimmers in boxes, and numbers of a prediction.

namespace beadswim {

/// Returns a question for one swimmer in a box. Its middle bead is at `middle`; its
/// axis is the first axis of the box.
inline Question ask_in_box(const CollinearSwimmer& swimmer, const Box& box,
                           const std::array<double, 3>& middle, double fluid_density = 1) {
  Question question = ask(swimmer, fluid_density);
  question.surroundings.box = BoxPlace{.box = box, .middle_bead = middle};
  return question;
}

/// Returns a question for one swimmer whose middle bead is in the middle of the box.
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

/// Returns a number from the settings of a prediction. Throws if no setting has this name.
inline double setting(const Prediction& prediction, const std::string& name) {
  for (const auto& [key, value] : prediction.settings) {
    if (key == name) return std::get<double>(value);
  }
  throw std::out_of_range(name);
}

/// Returns the name of a method without hyphens, as the name of a test.
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
