#include "beadswim/io/vti.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

namespace fs = std::filesystem;

/// Test with an empty folder, which is removed at the end, and a file of 2 × 3 × 2 cells.
class Vti : public testing::Test {
 protected:
  Vti() : folder_(fs::temp_directory_path() / ("beadswim-vti-" + std::to_string(::getpid()))) {
    fs::create_directory(folder_);
    const auto velocity = [](int z) {
      std::vector<float> plane;
      for (int n = 0; n < 18; ++n) plane.push_back(static_cast<float>(100 * z + n) * 0.1F);
      return plane;
    };
    const auto hidden = [](int z) { return std::vector<float>{0, 8, 0, 255, 0, static_cast<float>(z)}; };
    write_vti(path(), {.cells = {2, 3, 2}, .spacing = 0.1, .origin = {-1e-7, 0, 1.0 / 3}, .mean_cycles = 3},
              {{.name = "velocity", .components = 3, .plane = velocity},
               {.name = vti_hiding_field, .is_small_integer = true, .plane = hidden}});
  }
  ~Vti() override { fs::remove_all(folder_); }

  std::string path(const std::string& name = "a.vti") const { return folder_ / name; }

  /// Writes the file with one change. Returns the message with which the reader refuses it; empty: accepted.
  std::string refusal(const std::string& part, const std::string& other) const {
    std::string text = read_text(path());
    text.replace(text.find(part), part.size(), other);
    return refusal_of(text);
  }

  std::string refusal_of(const std::string& text) const {
    const std::string file = path("b.vti");
    std::ofstream(file) << text;
    try {
      const VtiReader reader(file);
      for (int z = 0; z < reader.cells().cells[2]; ++z) reader.plane("velocity", 3, z);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(Vti, IsReadAsItWasWritten) {
  const VtiReader reader(path());
  EXPECT_TRUE((reader.cells().cells == Index3(2, 3, 2)).all());
  EXPECT_EQ(reader.cells().spacing, 0.1);
  EXPECT_EQ(reader.cells().origin, Vec3(-1e-7, 0, 1.0 / 3));
  EXPECT_EQ(reader.cells().mean_cycles, 3);
  EXPECT_EQ(reader.cells().frame_swimmer, std::nullopt);
  EXPECT_TRUE(reader.has("velocity") && !reader.has("pressure"));
  for (const int z : {1, 0}) {
    const std::vector<float> velocity = reader.plane("velocity", 3, z);
    ASSERT_EQ(velocity.size(), 18U);
    for (int n = 0; n < 18; ++n) EXPECT_EQ(velocity[n], static_cast<float>(100 * z + n) * 0.1F);
    EXPECT_THAT(reader.plane(vti_hiding_field, 1, z), testing::ElementsAre(0, 8, 0, 255, 0, z));
  }
}

TEST_F(Vti, RefusesDamagedFilesWithTheirNameAndARemedy) {
  ASSERT_EQ(refusal("2 0 3", "2 0 3"), "");
  const std::vector<std::array<std::string, 3>> faults{
      {"ImageData", "PolyData", "not VTK image data"},
      {"LittleEndian", "BigEndian", "not VTK image data"},
      {"0 2 0 3", "0 2 0", "WholeExtent"},
      {"0 2 0 3", "0 2000000 0 3", "shorter than its cells"},
      {"0 2 0 3", "0 2147483647 0 2147483647", "shorter than its cells"},
      {"0 2 0 3", "0 2 0 2", "another size"},
      {"0 2 0 3", "0 2 0 9", "is incomplete"},
      {"0 2 0 3", "0 -2 0 3", "box of cubes"},
      {"0 2 0 3", "0 x 0 3", "WholeExtent"},
      {"0.1 0.1", "0.1 0.2", "box of cubes"},
      {"0.1 0.1 0.1", "0 0 0", "no usable size"},
      {"Origin=\"-1e-07", "Origin=\"nan", "no usable size"},
      {"Origin=\"-1e-07", "Origin=\"1e17", "no usable size"},
      {"<CellData>", "<PointData>", "does not begin"},
      {"Float32", "Float64", "does not consist of"},
      {"format=\"binary\"", "format=\"ascii\"", "does not consist of"},
      {"=\"3\"", "=\"-3\"", "does not consist of"},
      {"=\"3\"", "=\"1\"", "another size"},
      {"Name=\"velocity\"", "Name=\"v\"", "no field \"velocity\""},
      {"</CellData>", "", "not a field"},
      {">3<", "><", "mean_cycles is not a number"},
      {">3<", ">inf<", "mean_cycles is not a number"},
      {"\"binary\">\n", "\"binary\">\n*", "Base64"},
  };
  for (const auto& [part, other, fault] : faults) {
    const std::string message = refusal(part, other);
    EXPECT_THAT(message, testing::StartsWith(path("b.vti") + ": ")) << part << " -> " << other;
    EXPECT_THAT(message, testing::HasSubstr(fault)) << part << " -> " << other;
    EXPECT_THAT(message, testing::HasSubstr("; give a flow file (.vti)")) << part << " -> " << other;
  }
}

// No reader may rely on what a file lacks after its end.
TEST_F(Vti, RefusesEachBeginningOfAFile) {
  const std::string text = read_text(path());
  for (std::size_t size = 0; size < text.find("</CellData>"); ++size) {
    EXPECT_NE(refusal_of(text.substr(0, size)), "") << size;
  }
}

TEST_F(Vti, RefusesNumbersThatAreNotFinite) {
  write_vti(path("b.vti"), {.cells = {1, 1, 1}}, {{.name = "velocity", .components = 3, .plane = [](int) {
                                                     return std::vector<float>{0, NAN, 0};
                                                   }}});
  EXPECT_THAT(refusal_of(read_text(path("b.vti"))), testing::HasSubstr("not finite"));
}

TEST_F(Vti, IndexIsReadAsItWasWritten) {
  write_pvd(path("a.pvd"),
            {{.time = 0.1, .file = "a&<b\"c.flow/1-0.vti"}, {.time = 0.1, .file = "x", .part = 1}});
  const std::vector<PvdEntry> entries = read_pvd(path("a.pvd"));
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].time, 0.1);
  EXPECT_EQ(entries[0].file, "a&<b\"c.flow/1-0.vti");
  EXPECT_EQ(entries[1].part, 1);
  write_text(path("b.pvd"), "<DataSet timestep=\"\" part=\"0\" file=\"x\"/>");
  EXPECT_THROW(read_pvd(path("b.pvd")), InputError);
}

}  // namespace
}  // namespace beadswim
