#include "beadswim/run/run_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/io/fields_json.hpp"

namespace beadswim {
namespace {

/// Changes a value of any type.
void change(std::string& value) {
  value += "1";
}
void change(bool& value) {
  value = !value;
}
void change(double& value) {
  value = value / 3 + 0.1;
}
void change(int& value) {
  ++value;
}
template <NamedEnum Enum>
void change(Enum& value) {
  value = all_values<Enum>[value == all_values<Enum>[0] ? 1 : 0];
}
template <class T>
void change(std::optional<T>& value) {
  value = static_cast<T>(value.value_or(0) + 3);
}

/// Catches a setting that a checkpoint would not store, and values that lose digits.
TEST(RunSettings, AreTheSameAfterJson) {
  RunSettings settings;
  visit_fields([](const char*, auto& value, const SettingRow&) { change(value); }, settings);
  const auto read = Json::parse(Json(settings).dump()).get<RunSettings>();
  const auto any = [](const SettingRow&) { return true; };
  EXPECT_FALSE(find_difference(settings, read, any));
  visit_fields(
      [&](const char* name, const auto&, const SettingRow& row) {
        const auto one = [&](const SettingRow& other) { return other.setting == row.setting; };
        EXPECT_TRUE(find_difference(settings, {}, one)) << name;
      },
      settings);
}

/// Catches a setting that a table of settings forgot: all of them have a flag's name of their own.
TEST(RunSettings, HaveNamesOfTheirOwn) {
  std::set<Setting> names;
  int count = 0;
  const RunSettings any;
  visit_fields(
      [&](const char*, const auto&, const SettingRow& row) {
        names.insert(row.setting);
        ++count;
      },
      any);
  EXPECT_EQ(count, std::ssize(names));
}

/// Catches values that a caller of the library may choose, but with which no run makes sense.
TEST(RunSettings, HaveRanges) {
  const auto fault_of = [](auto set) {
    RunSettings settings;
    set(settings);
    try {
      require_ranges(settings);
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(fault_of([](RunSettings&) {}), "");
  EXPECT_EQ(fault_of([](RunSettings& s) { s.lattice.friction = 0; }), "");
  EXPECT_EQ(fault_of([](RunSettings& s) { s.lattice.refinement.reset(); }), "");
  EXPECT_THAT(fault_of([](RunSettings& s) { s.cycles = 0; }), testing::HasSubstr("greater than 0"));
  EXPECT_THAT(fault_of([](RunSettings& s) { s.cycles = std::numeric_limits<double>::quiet_NaN(); }),
              testing::HasSubstr("cycles: nan"));
  EXPECT_THAT(fault_of([](RunSettings& s) { s.lattice.friction = -1; }), testing::HasSubstr("at least 0"));
  EXPECT_THAT(fault_of([](RunSettings& s) { s.lattice.relaxation_time = 0.5; }),
              testing::HasSubstr("0.5 is not above 0.5, so that the viscosity"));
  EXPECT_THAT(fault_of([](RunSettings& s) { s.frames_per_cycle = 3; }), testing::HasSubstr("between 4 and"));
  EXPECT_THAT(fault_of([](RunSettings& s) { s.lattice.refinement = 9; }),
              testing::HasSubstr("between 1 and"));
}

/// Catches settings that are accepted and then have no effect.
TEST(RunSettings, ApplyToSomeModels) {
  EXPECT_NO_THROW(require_settings_apply({Setting::cycles, Setting::precision}, RunModel::lbm));
  EXPECT_NO_THROW(require_settings_apply({Setting::multipole_order}, RunModel::unsteady));
  EXPECT_THROW(require_settings_apply({Setting::precision}, RunModel::rpy), InputError);
  EXPECT_THROW(require_settings_apply({Setting::sum_tolerance}, RunModel::lbm), InputError);
  EXPECT_THROW(require_settings_apply({Setting::multipole_order}, RunModel::rpy_near), InputError);
  EXPECT_THROW(require_settings_apply({Setting::reynolds_stress}, RunModel::multipole), InputError);
}

TEST(RunSettings, AreNamedByWhatTellsARunFromOthers) {
  RunSettings settings;
  settings.lattice.cells_per_radius = 3;
  settings.lattice.relaxation_time = 0.8;
  settings.lattice.refinement.reset();
  EXPECT_EQ(settings_text(settings, {}), "model lbm cells per radius 3 relaxation time 0.8");
  settings.lattice.precision = Precision::fp32;
  EXPECT_EQ(settings_text(settings, {Setting::lubrication, Setting::cycles}),
            "model lbm cells per radius 3 relaxation time 0.8 precision single lubrication on");
  settings.model = RunModel::multipole;
  EXPECT_EQ(settings_text(settings, {}), "model multipole multipole order 1");
}

}  // namespace
}  // namespace beadswim
