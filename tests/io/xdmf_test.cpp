
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/io/h5md.hpp"
#include "beadswim/io/json.hpp"

// Tests that the XDMF index refers to the numbers of each frame in the trajectory.
// tests/readers/pvbatch_beads.py tests that ParaView can read the index.

namespace beadswim {
namespace {

using testing::HasSubstr;

void write_trajectory(const std::string& path, int frames) {
  const Communicator communicator(MPI_COMM_SELF);
  const TrajectoryHeader header{
      .swimmer = {0, 0, 0}, .bead = {1, 2, 3}, .radius = {1, 1, 1}, .creator_version = "1"};
  TrajectoryWriter writer(path, header, communicator);
  for (int n = 0; n < frames; ++n) {
    writer.append(TrajectoryFrame{.step = n,
                                  .time = 0.1 * n,
                                  .positions = std::vector<Vec3>(3, Vec3::Zero()),
                                  .velocities = std::vector<Vec3>(3, Vec3::Zero())});
  }
  writer.finish();
}

class Xdmf : public testing::Test {
 protected:
  Xdmf() { std::filesystem::create_directories(folder_); }
  ~Xdmf() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("xdmf_test." + std::to_string(getpid()));
};

TEST_F(Xdmf, NamesTimesAndPlacesOfEveryFrame) {
  write_trajectory(file("run.h5md"), 4);
  write_xdmf(file("run.h5md"));
  const std::string text = read_text(file("run.h5md.xdmf2"));
  EXPECT_THAT(text, HasSubstr("<DataItem Dimensions=\"4\" NumberType=\"Float\" Precision=\"8\" "
                              "Format=\"HDF\">run.h5md:/particles/beads/position/time<"));
  EXPECT_THAT(text, HasSubstr("<DataItem Dimensions=\"4 3 3\" NumberType=\"Float\" Precision=\"4\" "
                              "Format=\"HDF\">run.h5md:/particles/beads/velocity/value<"));
  EXPECT_THAT(text, HasSubstr("<!ENTITY one \" 0 0 1 1 1 1 3 3\">"));
  EXPECT_THAT(text, HasSubstr(">3&one;</DataItem>&velocity;</DataItem></Attribute>"));
  EXPECT_THAT(text,
              HasSubstr("<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">"
                        "run.h5md:/particles/beads/radius<"));
  EXPECT_EQ(text.find(">4&one;"), std::string::npos);
}

// With all in each frame, 1600 bytes: seven times the bytes of the frame in the trajectory.
TEST_F(Xdmf, TakesFewBytesForEachFrame) {
  write_trajectory(file("run.h5md"), 1);
  write_xdmf(file("run.h5md"));
  const auto one = std::filesystem::file_size(file("run.h5md.xdmf2"));
  write_trajectory(file("run.h5md"), 1001);
  write_xdmf(file("run.h5md"));
  EXPECT_LT(std::filesystem::file_size(file("run.h5md.xdmf2")) - one, 450 * 1000);
}

TEST_F(Xdmf, KnowsTheNamesThatParaviewOpens) {
  for (const char* name : {"run.h5md", "d:/a'b\"c&d<e>.h5md", "a b.h5md"})
    EXPECT_TRUE(paraview_can_open(name)) << name;
  for (const char* name : {"λ.h5md", "a:b.h5md", "a\\b.h5md", " a.h5md", "~a.h5md"})
    EXPECT_FALSE(paraview_can_open(name)) << name;
}

TEST_F(Xdmf, EscapesTheNameOfTheTrajectory) {
  write_trajectory(file("a&b<c.h5md"), 1);
  write_xdmf(file("a&b<c.h5md"));
  EXPECT_THAT(read_text(file("a&b<c.h5md.xdmf2")), HasSubstr(">a&amp;b&lt;c.h5md:/particles"));
}

TEST_F(Xdmf, SaysWhatCannotBeWritten) {
  write_trajectory(file("run.h5md"), 1);
  std::filesystem::create_directories(file("run.h5md.xdmf2/in the way"));
  try {
    write_xdmf(file("run.h5md"));
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("run.h5md.xdmf2: this path is a folder"));
  }
}

}  // namespace
}  // namespace beadswim
