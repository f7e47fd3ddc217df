#pragma once

#include <functional>

#include "beadswim/io/document_stream.hpp"
#include "comparison_inputs.hpp"

namespace beadswim {

/// The files of a comparison. Files of several documents (JSON Lines) make it a stream: each run of the
/// stream is compared with the documents of the same study in each reference file, or with the only document
/// of a file.
class ComparisonFiles {
 public:
  /// Throws InputError if a file cannot be read, or if there is no reference.
  explicit ComparisonFiles(const ComparisonRequest& request);

  bool is_stream() const;

  /// Returns the documents of all files, if they are no stream. Throws InputError if one is invalid.
  ComparisonInputs all();

  /// Throws InputError if a document of a stream is invalid. Returns the number of runs.
  int check();

  /// A run of a stream with its references, or the reason why it has none.
  struct Member {
    int number = 1;
    ComparisonInputs inputs;
    std::string reason;  ///< empty if `inputs` are complete
    Json study;
  };

  /// Returns the next run of a stream; nullopt at the end.
  std::optional<Member> next();

 private:
  struct File {
    std::string path;
    std::optional<DocumentStream> stream;  ///< nullopt: a trajectory
    bool is_single = true;
    std::optional<SwimmingDocument> only{};  ///< the document of a single one, once it has been read
  };

  static File open(const std::string& path);
  static const SwimmingDocument& only_document(File& file);
  static std::string add_run(const StreamMember& member, Member& next);
  std::string add_reference(File& file, const Json& study, ComparisonInputs& inputs);

  std::vector<File> runs_, references_;
  std::size_t run_file_ = 0;
  int number_ = 0;
};

}  // namespace beadswim
