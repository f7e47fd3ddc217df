#pragma once

#include <optional>

#include "beadswim/study/stream.hpp"
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

  /// Returns the runs of a stream; a trajectory is a member without text. Throws InputError if a document of
  /// the stream is invalid.
  StoredStream runs();

  /// Returns a run of a stream with its references. Throws InputError with the reason if it has none.
  ComparisonInputs inputs_of(const StreamMember& run);

 private:
  struct File {
    std::string path;
    std::optional<DocumentStream> stream;  ///< nullopt: a trajectory
    bool is_single = true;
    std::optional<SwimmingDocument> only{};  ///< the document of a single one, once it has been read
  };

  static File open(const std::string& path);
  static const SwimmingDocument& only_document(File& file);
  static SourceDocument reference_for(File& file, const Json& study);

  std::vector<File> runs_, references_;
};

}  // namespace beadswim
