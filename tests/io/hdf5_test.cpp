#include "beadswim/io/hdf5.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <numeric>

#include "beadswim/core/error.hpp"

// Tests that hyperslabs of datasets are written and read at their places, and that contents which are not as
// expected are refused with their place.

namespace beadswim {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

class Hdf5 : public testing::Test {
 protected:
  ~Hdf5() override { std::filesystem::remove(path_); }

  /// Returns the end of the message of the DataError that read() throws; an empty text if none is thrown.
  static std::string fault_of(const std::function<void()>& read) {
    try {
      read();
    } catch (const DataError& fault) {
      return fault.what();
    }
    return "";
  }

  std::string path_ =
      std::filesystem::temp_directory_path() / ("hdf5_test." + std::to_string(getpid()) + ".h5");
  H5File file_{path_, H5File::Mode::create, "docs/PAGE.md"};
};

/// Catches start and count that are exchanged, or dimensions in the reverse order.
TEST_F(Hdf5, ReadsTheHyperslabThatWasWritten) {
  const H5Dataset dataset = file_.create("a", number_type<int>(), {2, 3, 4});
  std::vector<int> numbers(24);
  std::iota(numbers.begin(), numbers.end(), 0);
  dataset.write({{0, 0, 0}, {2, 3, 4}}, numbers.data());
  dataset.write({{1, 0, 2}, {1, 2, 1}}, std::array{-1, -2}.data());
  std::vector<int> read(4);
  dataset.read({{1, 0, 1}, {1, 2, 2}}, read.data());
  EXPECT_THAT(read, ElementsAre(13, -1, 17, -2));
  EXPECT_THAT(file_.open("a", {2, any_extent, 4}).read_rows<double>(1, 1)[6], -2);
}

TEST_F(Hdf5, AppendsRows) {
  H5Dataset series = file_.create_series("a", number_type<double>(), {2});
  for (const double x : {1, 2, 3}) series.append_row(std::array{x, x / 4}.data());
  EXPECT_THAT(file_.open("a", {3, 2}).read_rows<double>(1, 2), ElementsAre(2, 0.5, 3, 0.75));
}

TEST_F(Hdf5, RefusesOtherRowsTypesAndShapes) {
  file_.write("a", std::array{0.5, 1.5}.data(), {2});
  const H5Dataset dataset = file_.open("a", {2});
  EXPECT_THAT(fault_of([&] { dataset.read_rows<double>(1, 2); }),
              EndsWith(".h5:/a: the dataset ends too early"));
  EXPECT_THAT(fault_of([&] { dataset.read_rows<int>(0, 1); }),
              EndsWith(".h5:/a: the dataset does not contain numbers of a suitable type"));
  EXPECT_THAT(fault_of([&] { file_.open("a", {3}); }),
              EndsWith(".h5:/a: the dataset does not have the shape given in docs/PAGE.md"));
  EXPECT_THAT(fault_of([&] { file_.open("b", {2}); }),
              EndsWith(".h5:/b: this part of the HDF5 file is missing or cannot be read"));
}

/// Catches memory that is allocated for numbers which the file cannot contain.
TEST_F(Hdf5, RefusesADatasetThatIsNotStored) {
  static_cast<void>(file_.create("a", number_type<double>(), {hsize_t{1} << 40}));
  EXPECT_THAT(fault_of([&] { file_.open("a", {any_extent}); }),
              EndsWith(".h5:/a: the dataset declares more data than the file contains"));
}

}  // namespace
}  // namespace beadswim
