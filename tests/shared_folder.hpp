#pragma once

#include <mpi.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// A new folder, which all ranks share, for the files of a test. The destructor removes it.
class SharedFolder {
 public:
  explicit SharedFolder(const Communicator& communicator) : communicator_(communicator) {
    std::string path = (std::filesystem::temp_directory_path() / "beadswim-test-XXXXXX").string();
    if (communicator_.is_root() && mkdtemp(path.data()) == nullptr) path.clear();
    MPI_Bcast(path.data(), static_cast<int>(path.size()), MPI_CHAR, 0, communicator_.get());
    path_ = path;
  }
  ~SharedFolder() {
    MPI_Barrier(communicator_.get());
    std::error_code ignored;
    if (communicator_.is_root()) std::filesystem::remove_all(path_, ignored);
  }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;

  std::string file(const std::string& name) const { return path_ / name; }

 private:
  const Communicator& communicator_;
  std::filesystem::path path_;
};

}  // namespace beadswim
