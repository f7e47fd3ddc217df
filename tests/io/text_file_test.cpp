#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

namespace fs = std::filesystem;

/// Test with an empty folder, which is removed at the end.
class TextFile : public testing::Test {
 protected:
  TextFile() : folder_(fs::temp_directory_path() / ("beadswim-text-file-" + std::to_string(::getpid()))) {
    fs::create_directory(folder_);
  }
  ~TextFile() override { fs::remove_all(folder_); }

  std::string in_folder(const std::string& name) const { return folder_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(TextFile, ReadsBackWhatWasWrittenAndLeavesNothingElse) {
  write_text(in_folder("a.json"), "first");
  write_text(in_folder("a.json"), std::string("second\0\n", 8));
  EXPECT_EQ(read_text(in_folder("a.json")), std::string("second\0\n", 8));
  EXPECT_EQ(files(), 1u);
}

TEST_F(TextFile, RefusesAFolderThatIsNotThereAsAnErrorOfTheUser) {
  EXPECT_THROW(write_text(in_folder("no/such/file"), "x"), InputError);
  EXPECT_THROW(write_text(folder_, "x"), InputError);
  EXPECT_THROW(read_text(in_folder("missing")), InputError);
  EXPECT_THROW(read_text(folder_), InputError);
}

// A file with a limit on its size stands for a full disk: what was there must survive, without litter.
TEST_F(TextFile, KeepsTheOldFileWhenWritingFails) {
  write_text(in_folder("a.json"), "old");
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &small);
    try {
      write_text(in_folder("a.json"), std::string(100'000, 'x'));
      ::_exit(0);
    } catch (const SolverError&) {
      ::_exit(3);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_EQ(read_text(in_folder("a.json")), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(TextFile, WritesThroughASymbolicLink) {
  write_text(in_folder("target"), "old");
  fs::create_symlink("target", in_folder("link"));
  write_text(in_folder("link"), "new");
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(read_text(in_folder("target")), "new");
}

TEST_F(TextFile, WritesThroughLinksToAFileThatIsNotThereYet) {
  fs::create_directory(in_folder("other"));
  fs::create_symlink("other/target", in_folder("second"));
  fs::create_symlink("second", in_folder("first"));
  write_text(in_folder("first"), "new");
  EXPECT_TRUE(fs::is_symlink(in_folder("first")) && fs::is_symlink(in_folder("second")));
  EXPECT_EQ(read_text(in_folder("other/target")), "new");
}

// A rename would put a file in the pipe's place, and the reader would wait for ever.
TEST_F(TextFile, WritesIntoAPipe) {
  ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = read_text(in_folder("pipe")); });
  write_text(in_folder("pipe"), "through the pipe");
  reader.join();
  EXPECT_EQ(received, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(in_folder("pipe")));
}

}  // namespace
}  // namespace beadswim
