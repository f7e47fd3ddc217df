#include "beadswim/io/checkpoint_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../shared_folder.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

namespace fs = std::filesystem;

class CheckpointFile : public testing::Test {
 protected:
  Communicator communicator{MPI_COMM_WORLD};
  SharedFolder folder{communicator};
  const Index3 cells{3, 4, 6};
  const std::string words = "what rank 0 has to say";

  /// Returns the planes of the lattice that this rank contributes.
  LatticePart own_part() const {
    const int ranks = communicator.size(), rank = communicator.rank();
    const int low = cells[2] * rank / ranks, high = cells[2] * (rank + 1) / ranks;
    return {.cells = cells, .offset = {0, 0, low}, .size = {cells[0], cells[1], high - low}};
  }
  LatticePart whole() const { return {.cells = cells, .offset = {0, 0, 0}, .size = cells}; }

  /// Returns a number that is different for each component and cell.
  double number(int component, int x, int y, int z) const {
    return 1 / 3.0 + component + 10 * x + 100 * y + 1000 * z;
  }
  template <class Real>
  void write(const std::string& path, bool finishes = true) {
    CheckpointWriter file(path, communicator);
    file.add("words", communicator.is_root() ? std::span<const char>(words) : std::span<const char>());
    file.add("nothing", {});
    const LatticePart part = own_part();
    file.add_lattice<Real>(part, 2, [&](int c, std::span<Real> numbers) {
      auto next = numbers.begin();
      for (int z = 0; z < part.size[2]; ++z)
        for (int y = 0; y < part.size[1]; ++y)
          for (int x = 0; x < part.size[0]; ++x)
            *next++ = static_cast<Real>(number(c, x, y, z + part.offset[2]));
    });
    if (finishes) file.finish();
  }
  template <class Real>
  void expect_contents(const std::string& path) {
    const CheckpointReader file(path, communicator);
    EXPECT_EQ(file.text("words"), words);
    EXPECT_EQ(file.size("nothing"), 0);
    file.read_lattice<Real>(whole(), 2, [&](int c, std::span<const Real> numbers) {
      auto next = numbers.begin();
      for (int z = 0; z < cells[2]; ++z)
        for (int y = 0; y < cells[1]; ++y)
          for (int x = 0; x < cells[0]; ++x) EXPECT_EQ(*next++, static_cast<Real>(number(c, x, y, z)));
    });
  }
  std::string contents(const std::string& path) const {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(CheckpointFile, GivesBackWhatWasPutIn) {
  write<double>(folder.file("a"));
  expect_contents<double>(folder.file("a"));
  write<float>(folder.file("b"));
  expect_contents<float>(folder.file("b"));
  EXPECT_FALSE(fs::exists(folder.file("a.part")));
}

TEST_F(CheckpointFile, HasOneHashOnAnyNumberOfRanks) {
  write<double>(folder.file("a"));
  // Of these contents, whoever has which part.
  const std::string hash = "3a6aaa5dfdfb049ceb3262fcb601e24864f2666bd9468bfc9650bd2b88974c2d";
  EXPECT_NE(contents(folder.file("a")).find(hash), std::string::npos);
}

TEST_F(CheckpointFile, ThatIsDamagedIsRefusedByAllRanks) {
  write<double>(folder.file("whole"));
  const std::string whole_file = contents(folder.file("whole"));
  const std::size_t first = whole_file.find(words), lattice = first + words.size();
  for (const std::size_t place : {first, lattice, lattice + 700, whole_file.size() - 1}) {
    if (communicator.is_root()) {
      std::string damaged = whole_file;
      damaged[place] ^= 1;
      std::ofstream(folder.file("damaged"), std::ios::binary) << damaged;
    }
    MPI_Barrier(communicator.get());
    EXPECT_THROW(CheckpointReader(folder.file("damaged"), communicator), InputError) << place;
    MPI_Barrier(communicator.get());
  }
}

TEST_F(CheckpointFile, ThatIsCutOrOfAnotherKindIsRefusedByAllRanks) {
  write<double>(folder.file("whole"));
  const std::string whole_file = contents(folder.file("whole"));
  for (const std::string& text :
       {std::string(), std::string("no HDF5"), whole_file.substr(0, whole_file.size() / 2)}) {
    if (communicator.is_root()) std::ofstream(folder.file("other"), std::ios::binary) << text;
    MPI_Barrier(communicator.get());
    EXPECT_THROW(CheckpointReader(folder.file("other"), communicator), InputError) << text.size();
    MPI_Barrier(communicator.get());
  }
  EXPECT_THROW(CheckpointReader(folder.file("none"), communicator), InputError);
}

TEST_F(CheckpointFile, ThatIsNotFinishedLeavesTheOlderOne) {
  write<double>(folder.file("a"));
  const std::string older = contents(folder.file("a"));
  write<float>(folder.file("a"), false);
  MPI_Barrier(communicator.get());
  EXPECT_EQ(contents(folder.file("a")), older);
  EXPECT_FALSE(fs::exists(folder.file("a.part")));
}

/// Catches a fault in a checkpoint that is reported without the remedy.
TEST_F(CheckpointFile, NamesTheRemedyForUnexpectedContents) {
  write<double>(folder.file("a"));
  const CheckpointReader file(folder.file("a"), communicator);
  try {
    with_checkpoint_remedy([&] { static_cast<void>(file.bytes("words", 0, words.size() + 1)); });
    FAIL() << "nothing was thrown";
  } catch (const SolverError& error) {
    EXPECT_EQ(error.what(), folder.file("a") +
                                ":/words: the dataset ends too early; take the run's other checkpoint "
                                "(.ckpt.0 or .ckpt.1), or begin without restart");
  }
}

TEST_F(CheckpointFile, CopiesASectionToAFile) {
  write<double>(folder.file("a"));
  if (communicator.is_root())
    std::ofstream(folder.file("copy")) << "an older and longer text that is to go, all of it";
  MPI_Barrier(communicator.get());
  {
    const CheckpointReader file(folder.file("a"), communicator);
    std::FILE* copy = communicator.is_root() ? std::fopen(folder.file("copy").c_str(), "r+") : nullptr;
    file.copy_to("words", copy);
    if (copy != nullptr) std::fclose(copy);
  }
  MPI_Barrier(communicator.get());
  EXPECT_EQ(contents(folder.file("copy")), words);
}

TEST(LatticeHash, TellsNumbersThatAreSwappedAndAddsUpInAnyOrder) {
  LatticeHash ab, ba, swapped;
  ab.add(0, 7);
  ab.add(1, 9);
  ba.add(1, 9);
  ba.add(0, 7);
  swapped.add(0, 9);
  swapped.add(1, 7);
  EXPECT_EQ(ab.value, ba.value);
  EXPECT_NE(ab.value, swapped.value);
}

}  // namespace
}  // namespace beadswim
