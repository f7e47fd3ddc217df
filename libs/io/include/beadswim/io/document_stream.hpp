#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/temporary_file.hpp"

// Streams of JSON documents: files with one document each, or with one document per line (JSON Lines), one
// after the other.

namespace beadswim {

/// A document of a stream as text.
struct StreamMember {
  std::string text;
  std::string source;  ///< name for messages: the file, with the number of the line in a file of JSON Lines
  int number = 1;      ///< position in the stream, from 1
};

/// Throws InputError if standard input, "-", is named more than once.
void require_one_standard_input(const std::vector<std::string>& paths);

/// Reads the documents of files one by one, with one file open at a time, so that neither memory nor open
/// files grow with their number. A file contains JSON Lines if its first line is a complete document, or if
/// its second line is a complete object. Empty lines are skipped.
class DocumentStream {
 public:
  /// `paths`: files; - is standard input. What can be read only once (standard input, a pipe) is copied to a
  /// temporary file. Throws InputError if one cannot be read.
  explicit DocumentStream(const std::vector<std::string>& paths);

  /// Returns the next document; nullopt at the end. An empty file is one document without text.
  std::optional<StreamMember> next();
  /// Goes back to the first document.
  void rewind();

  /// Returns true if the stream consists of one file with one document.
  bool is_single() const { return files_.size() == 1 && !files_.front().has_several; }
  /// Returns true if all documents are lines; a single document may be one, too.
  bool is_lines() const { return is_lines_; }

 private:
  struct File {
    std::string source;
    OpenFile copy{};  ///< of a file that can be read only once; nullptr for others
    bool is_lines = false, has_several = false;
  };

  /// Goes to the start of the present file, and returns it.
  std::FILE* open_at_start();
  std::FILE* stream() const { return open_ ? open_.get() : files_[file_].copy.get(); }

  std::vector<File> files_;
  OpenFile open_{};  ///< the present file, if it has no copy
  bool is_lines_ = true;
  std::size_t file_ = 0;  ///< index of the file with the next document
  int line_ = 0;          ///< number of lines of this file that have been read
  int number_ = 0;        ///< number of documents that have been read
};

}  // namespace beadswim
