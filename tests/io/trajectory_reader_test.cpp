#include "beadswim/io/h5md.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

#include "beadswim/core/error.hpp"

// Tests that TrajectoryReader reads what TrajectoryWriter writes, and refuses all other files with a message
// that states place and remedy.

namespace beadswim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A folder for one test. The destructor removes it.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trajectory_reader_test." + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return path / name; }
};

TrajectoryHeader two_swimmers() {
  return {.box = Box{{10, 20, 40}, {Boundary::periodic, Boundary::periodic, Boundary::free_slip}},
          .swimmer = {4, 4, 4, 7, 7, 7},
          .bead = {1, 2, 3, 1, 2, 3},
          .radius = {1, 1.5, 1, 0.5, 0.5, 0.25},
          .creator_version = "1.2.3",
          .layout = "{ \"λ\": 1 }\n"};
}

/// Returns frame number n. Its positions leave the box on both sides; all numbers are exact in single
/// precision.
TrajectoryFrame frame_number(int n) {
  TrajectoryFrame frame{
      .step = 50L * n, .time = 12.5 * n, .positions = {}, .velocities = {}, .mean_flow = Vec3(n, 0.1, 0)};
  frame.momentum = Vec3(0, -n, 1e-9);
  for (int b = 0; b < 6; ++b) {
    frame.positions.push_back(Vec3(-11 + b + 8 * n, 19.5 + b, 3.25 - n));
    frame.velocities.push_back(Vec3(0.5, b, -n));
  }
  return frame;
}

void write(const std::string& path, int frames, const TrajectoryHeader& header = two_swimmers(),
           const std::function<void(TrajectoryFrame&)>& edit = {}) {
  const Communicator communicator(MPI_COMM_SELF);
  TrajectoryWriter writer(path, header, communicator);
  for (int n = 0; n < frames; ++n) {
    TrajectoryFrame frame = frame_number(n);
    if (edit) edit(frame);
    writer.append(frame);
  }
  writer.finish();
}

/// Reads the complete file and returns the message of the InputError that is thrown; an empty text if none is
/// thrown.
std::string fault_of(const std::string& path) {
  try {
    const TrajectoryReader reader(path);
    for (std::size_t n = 0; n < reader.frames(); ++n) static_cast<void>(reader.frame(n));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Changes the finished file.
void edit(const std::string& path, const std::function<void(const H5File&)>& change) {
  change(H5File(path, H5File::Mode::update, ""));
}

void expect_equal(const TrajectoryFrame& read, const TrajectoryFrame& written) {
  EXPECT_EQ(read.step, written.step);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.positions, written.positions);
  EXPECT_EQ(read.velocities, written.velocities);
  EXPECT_EQ(read.mean_flow, written.mean_flow);
  EXPECT_EQ(read.momentum, written.momentum);
}

TEST(TrajectoryReader, ReadsOpenSpaceWhichHasNoBox) {
  const Folder folder;
  TrajectoryHeader open_space = two_swimmers();
  open_space.box.reset();
  write(folder.file("open.h5md"), 2, open_space);
  const TrajectoryReader reader(folder.file("open.h5md"));
  EXPECT_FALSE(reader.header().box.has_value());
  EXPECT_EQ(reader.frame(1).positions, frame_number(1).positions);
}

struct Cycle {
  int index = 0;
  Vec3 velocity = Vec3::Zero();
  std::array<double, 2> arms{};
  double energy = 0;
  std::optional<Vec3> spin{};

  static void visit_fields(auto&& visit, auto& cycle) {
    visit("index", cycle.index, not_a_column);
    visit("velocity", cycle.velocity);
    visit("arms", cycle.arms);
    visit("energy", cycle.energy);
    visit("spin", cycle.spin);
  }
};

/// NaN is what a swimmer has that has ended no cycle of its own. Catches a column that is not written, or is
/// read as another, and numbers of one swimmer taken for another's.
TEST(TrajectoryReader, ReadsWhatEachSwimmerDidInEachCycle) {
  const Folder folder;
  const std::string path = folder.file("cycles.h5md");
  TrajectoryHeader header = two_swimmers();
  header.cycle_columns = columns_of<Cycle>({});
  {
    const Communicator communicator(MPI_COMM_SELF);
    TrajectoryWriter writer(path, header, communicator);
    writer.append(frame_number(0));
    const Cycle ended{
        .index = 9, .velocity = {1, 2, 3}, .arms = {7, 8}, .energy = 0.5, .spin = Vec3(4, 5, 6)};
    writer.append(TrajectoryCycle{
        .step = 40, .time = 10, .columns = columns_of<Cycle>({record_of_nan<Cycle>(), ended})});
    writer.finish();
  }
  const std::vector<TrajectoryCycle> cycles = TrajectoryReader(path).cycles(header.cycle_columns);
  ASSERT_EQ(cycles.size(), 1);
  EXPECT_EQ(cycles[0].step, 40);
  EXPECT_EQ(cycles[0].time, 10);
  ASSERT_EQ(cycles[0].columns.size(), 4);
  EXPECT_EQ(cycles[0].columns[1].name, "arms");
  EXPECT_EQ(cycles[0].columns[1].numbers.size(), 4);
  const std::vector<Cycle> swimmers = records_of<Cycle>(cycles[0].columns, 2);
  EXPECT_TRUE(std::isnan(swimmers[0].velocity[2]) && std::isnan(swimmers[0].energy));
  EXPECT_EQ(swimmers[1].velocity, Vec3(1, 2, 3));
  EXPECT_EQ(swimmers[1].arms[1], 8);
  EXPECT_EQ(swimmers[1].energy, 0.5);
  EXPECT_EQ(swimmers[1].index, 0);
  EXPECT_FALSE(swimmers[0].spin);
  EXPECT_EQ(swimmers[1].spin, Vec3(4, 5, 6));
}

TEST(TrajectoryReader, GivesBackWhatWasWritten) {
  const Folder folder;
  write(folder.file("run.h5md"), 5);
  const TrajectoryReader reader(folder.file("run.h5md"));
  const TrajectoryHeader written = two_swimmers();
  EXPECT_EQ(reader.header().box, written.box);
  EXPECT_EQ(reader.header().swimmer, written.swimmer);
  EXPECT_EQ(reader.header().bead, written.bead);
  EXPECT_EQ(reader.header().radius, written.radius);
  EXPECT_EQ(reader.header().creator_version, written.creator_version);
  EXPECT_EQ(reader.header().layout, written.layout);
  ASSERT_EQ(reader.frames(), 5U);
  for (const int n : {4, 0, 2}) expect_equal(reader.frame(n), frame_number(n));
}

// Such frames are chunks of their own, and compressed.
TEST(TrajectoryReader, ReadsLargeSwarms) {
  const Folder folder;
  const int beads = 6000;
  TrajectoryHeader header = two_swimmers();
  header.swimmer.clear();
  header.bead.clear();
  header.radius.assign(beads, 1.0);
  for (int b = 0; b < beads; ++b) {
    header.swimmer.push_back(b / 3);
    header.bead.push_back(b % 3 + 1);
  }
  const auto place = [](TrajectoryFrame& frame) {
    frame.positions.clear();
    for (int b = 0; b < beads; ++b)
      frame.positions.push_back(Vec3(b, -b, 0.5 + static_cast<double>(frame.step)));
    frame.velocities.assign(beads, Vec3::Zero());
  };
  write(folder.file("run.h5md"), 3, header, place);
  const TrajectoryReader reader(folder.file("run.h5md"));
  EXPECT_EQ(reader.frame(2).positions[5999], Vec3(5999, -5999, 100.5));
}

// A run that goes on holds the file, or was killed and left it so.
TEST(TrajectoryReader, ReadsTheWholeFramesOfAFileThatIsBeingWritten) {
  const Folder folder;
  const Communicator communicator(MPI_COMM_SELF);
  TrajectoryWriter writer(folder.file("run.h5md"), two_swimmers(), communicator);
  for (int n = 0; n < 3; ++n) writer.append(frame_number(n));
  std::filesystem::copy(folder.file("run.h5md.part"), folder.file("killed.h5md.part"));
  const TrajectoryReader reader(folder.file("killed.h5md.part"));
  ASSERT_EQ(reader.frames(), 3U);
  expect_equal(reader.frame(2), frame_number(2));
  EXPECT_EQ(TrajectoryReader(folder.file("run.h5md.part")).frames(), 3U);
  writer.finish();
}

// On a full disk, HDF5 extends datasets whose new rows it then cannot write; they read as zeros.
TEST(TrajectoryReader, LeavesOutAFrameThatIsNotWritten) {
  const Folder folder;
  const auto extended = [&](const std::vector<std::string>& names) {
    const std::string path = folder.file("full.h5md.part");
    write(path, 3);
    const H5File file(path, H5File::Mode::update, "");
    for (const std::string& name : names) {
      const H5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), name);
      std::array<hsize_t, 3> extent{};
      H5Sget_simple_extent_dims(H5Handle(H5Dget_space(dataset), name), extent.data(), nullptr);
      ++extent[0];
      H5Dset_extent(dataset, extent.data());
    }
    return path;
  };
  const std::vector<std::string> values{"particles/beads/box/edges/value", "particles/beads/position/value",
                                        "particles/beads/image/value",     "particles/beads/velocity/value",
                                        "observables/mean_flow/value",     "observables/momentum/value"};
  std::vector<std::string> all = values;
  all.insert(all.end(), {"particles/beads/position/step", "particles/beads/position/time"});
  for (const auto& names : {values, all, std::vector<std::string>{all.back()}}) {
    const TrajectoryReader reader(extended(names));
    ASSERT_EQ(reader.frames(), 3U);
    EXPECT_TRUE(reader.has_incomplete_frame());
    expect_equal(reader.frame(2), frame_number(2));
  }
  EXPECT_FALSE(TrajectoryReader(extended({})).has_incomplete_frame());
}

// The trajectory replaces the target of a link, not the link.
TEST(TrajectoryReader, WritesThroughASymbolicLink) {
  const Folder folder;
  std::filesystem::create_directories(folder.file("disk"));
  std::filesystem::create_symlink("disk/target.h5md", folder.file("link.h5md"));
  for (const int frames : {2, 3}) {  // a target that is not there yet, and one to be replaced
    write(folder.file("link.h5md"), frames);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.h5md")));
    EXPECT_EQ(TrajectoryReader(folder.file("disk/target.h5md")).frames(), std::size_t(frames));
  }
}

// Readers such as OVITO expect wrapped positions below the box length.
TEST(TrajectoryReader, WrapsPositionsBelowTheBoxLengthInSinglePrecisionToo) {
  const Folder folder;
  const double length = 0.1;  // its nearest number in single precision is greater
  TrajectoryHeader header = two_swimmers();
  header.box->lengths = Vec3::Constant(length);
  const std::vector<double> x{-1e-25, length * (1 - 1e-10), -1e-9 * length, length, 3 * length - 1e-12, 0};
  write(folder.file("run.h5md"), 1, header, [&](TrajectoryFrame& frame) {
    for (int b = 0; b < 6; ++b) frame.positions[b] = Vec3(x[b], 0, 0);
  });
  const std::string name = "particles/beads/position/value";
  const std::vector<float> wrapped =
      H5File(folder.file("run.h5md"), H5File::Mode::read, "").open(name, {1, 6, 3}).read_rows<float>(0, 1);
  const TrajectoryFrame frame = TrajectoryReader(folder.file("run.h5md")).frame(0);
  for (int b = 0; b < 6; ++b) {
    EXPECT_GE(wrapped[3 * b], 0) << x[b];
    EXPECT_LT(static_cast<double>(wrapped[3 * b]), length) << x[b];
    EXPECT_NEAR(frame.positions[b][0], x[b], 1e-7 * length);
  }
}

TEST(TrajectoryReader, SaysThatThereIsNoFrameYet) {
  const Folder folder;
  write(folder.file("run.h5md"), 0);
  EXPECT_THAT(fault_of(folder.file("run.h5md")),
              HasSubstr("run.h5md: the trajectory contains no frame yet; wait for"));
}

TEST(TrajectoryReader, RefusesWhatIsNoTrajectory) {
  const Folder folder;
  const auto path = folder.file("x.h5md");
  EXPECT_THAT(fault_of(path),
              AllOf(HasSubstr("x.h5md: the file cannot be read: No such file"), HasSubstr("; give a ")));
  EXPECT_THAT(fault_of(folder.path), HasSubstr("is not a regular file"));
  EXPECT_THAT(fault_of("-"), HasSubstr("name the file"));
  std::ofstream(path) << "{ \"schema\": \"beadswim/run/1\" }\n";
  EXPECT_THAT(fault_of(path),
              AllOf(HasSubstr("x.h5md: the file is not an HDF5 file"), HasSubstr("give a trajectory")));
  { const H5File empty(path, H5File::Mode::create, ""); }
  EXPECT_THAT(
      fault_of(path),
      HasSubstr(
          "x.h5md: the file is an HDF5 file but not a trajectory of Beadswim: the group /h5md is missing"));
}

TEST(TrajectoryReader, NamesThePlaceOfWhatIsBroken) {
  const Folder folder;
  const auto path = folder.file("run.h5md");
  const auto fault_after = [&](const std::function<void(const H5File&)>& change) {
    write(path, 3);
    edit(path, change);
    return fault_of(path);
  };
  const auto without = [&](const char* name) {
    return fault_after([&](hid_t file) { H5Ldelete(file, name, H5P_DEFAULT); });
  };
  for (const char* name : {"particles/beads/position/value", "particles/beads/image/value",
                           "observables/momentum/value", "particles/beads/radius", "parameters/layout"}) {
    EXPECT_THAT(without(name),
                HasSubstr(std::string("run.h5md:/") + name +
                          ": this part of the HDF5 file is missing or cannot be read; the file is damaged"));
  }
  EXPECT_THAT(fault_after([](hid_t file) { H5Adelete_by_name(file, "particles/beads/box", "boundary", 0); }),
              HasSubstr("/particles/beads/box: this HDF5 object has no attribute \"boundary\""));
  EXPECT_THAT(fault_after([](const H5File& file) {
                H5Ldelete(file, "parameters/layout", H5P_DEFAULT);
                file.write("parameters/layout", std::array{1, 2}.data(), {2});
              }),
              HasSubstr("/parameters/layout: the HDF5 dataset is not a string; the file is damaged"));
  EXPECT_THAT(fault_after([](const H5File& file) {
                H5Ldelete(file, "particles/beads/radius", H5P_DEFAULT);
                file.write("particles/beads/radius", std::array{1.0, 2.0}.data(), {2});
              }),
              HasSubstr("/particles/beads/radius: the dataset does not have 6 entries, one per bead"));
  EXPECT_THAT(fault_after([](const H5File& file) {
                H5Ldelete(file, "particles/beads/position/value", H5P_DEFAULT);
                file.write("particles/beads/position/value", std::array{1.0, 2.0}.data(), {2});
              }),
              HasSubstr("/particles/beads/position/value: the dataset does not have the shape"));
}

TEST(TrajectoryReader, RefusesSwimmersThatAreNotWholeAndNumbersThatAreNone) {
  const Folder folder;
  const auto path = folder.file("run.h5md");
  TrajectoryHeader header = two_swimmers();
  header.swimmer[4] = 4;
  write(path, 1, header);
  EXPECT_THAT(fault_of(path), HasSubstr("species: the numbers of the beads must be 1, 2, 3, ... for the "
                                        "consecutive beads of each swimmer"));
  write(path, 2, two_swimmers(),
        [](TrajectoryFrame& frame) { frame.velocities[3].x() = std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_THAT(fault_of(path), HasSubstr("velocity/value: the dataset contains a non-finite number"));
}

// Cut short anywhere, a file is refused or read as far as it goes, and never a crash.
TEST(TrajectoryReader, SurvivesFilesThatAreCutShort) {
  const Folder folder;
  const auto path = folder.file("run.h5md");
  write(path, 40);
  const auto size = std::filesystem::file_size(path);
  for (int part = 0; part < 20; ++part) {
    const auto cut = folder.file("cut.h5md");
    std::filesystem::copy_file(path, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, size * part / 20);
    EXPECT_THAT(fault_of(cut), HasSubstr("cut.h5md")) << part << " twentieths";
  }
}

}  // namespace
}  // namespace beadswim
