#include "beadswim/core/setting.hpp"

#include <gtest/gtest.h>

namespace beadswim {
namespace {

std::string message() {
  return InputError(Setting::relaxation_time, fmt::format("0.5; take more {}", Setting::cells_per_radius))
      .what();
}

// A library that named flags would send its other users looking for flags that they do not have.
TEST(Setting, MessagesNameItInWordsAndInAProgramByItsFlag) {
  EXPECT_EQ(message(), "relaxation time: 0.5; take more cells per radius");
  set_setting_names([](Setting setting) {
    return std::string(setting == Setting::relaxation_time ? "--relaxation-time" : "--other");
  });
  EXPECT_EQ(message(), "--relaxation-time: 0.5; take more --other");
  set_setting_names(words_of);
}

}  // namespace
}  // namespace beadswim
