#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beadswim/core/temporary_file.hpp"
#include "beadswim/io/document_stream.hpp"
#include "evaluation.hpp"
#include "problem.hpp"
#include "search.hpp"

namespace beadswim {

constexpr const char* optimise_name = "beadswim-optimise";

/// A theory method or a model with its name.
struct NamedEvaluator {
  std::string name;
  std::unique_ptr<Evaluator> evaluator;
};

/// The search for the best values of one layout. It reports on standard error.
class Optimisation {
 public:
  /// Throws InputError if a free quantity does not exist, or if no layout was found in the bounds that is
  /// valid. `trace`: takes a line of JSON per evaluation. The arguments must exist as long as the object.
  Optimisation(StreamMember member, const Problem& problem, const std::vector<FreeValue>& free,
               const NamedEvaluator& by, const OpenFile& trace);

  /// Evaluates the layout as it is, or if that fails others in the bounds. Throws InputError if none can be
  /// evaluated, or if none gives the outcomes of the problem.
  void begin();

  /// Searches, and finds the ranges in which the objective is at most 1 % worse. Throws SolverError if no
  /// layout satisfies the limits.
  void find(const SearchSettings& settings);

  /// Throws InputError if another method cannot treat the layout as it is or does not give the outcomes, or
  /// if a model cannot run the first layout that was evaluated.
  void require_treated_by(const NamedEvaluator& other) const;

  /// Evaluates the layout that was found by another method or model. Returns false if this fails.
  bool verify(const NamedEvaluator& other);

  /// Returns the layout that was found. Its study has the values found with the ends of their ranges,
  /// NAME_from and NAME_to (of the first name of a free value), and the objective, also as
  /// OBJECTIVE_by_METHOD by the method that verified it.
  const LayoutDocument& best() const { return best_; }

 private:
  void require_numbers() const;
  void require_valid_layout() const;
  Trial evaluate(const Position& position, const std::string& stage);
  void record(const std::string& stage, const Json& study, const Outcomes& outcomes,
              const std::string& reason = "");
  void require_found(const SearchResult& found) const;
  void find_ranges(SearchResult& found);
  void report(const SearchResult& found) const;
  void report_constraints(const Outcomes& outcomes, const std::string& by) const;

  StreamMember member_;
  Json layout_;
  const Problem& problem_;
  const std::vector<FreeValue>& free_;
  const NamedEvaluator& by_;
  const OpenFile& trace_;
  std::optional<Outcomes> given_;    ///< outcomes of the layout as it is; nullopt: it cannot be evaluated
  std::optional<Outcomes> typical_;  ///< outcomes of the first layout that was evaluated
  LayoutDocument treated_;           ///< that layout
  std::vector<std::pair<double, double>> ranges_;  ///< ends of the range of each free value
  LayoutDocument best_;
  Outcomes outcomes_;   ///< outcomes of `best_`
  std::string reason_;  ///< why a layout could last not be evaluated
  int recorded_ = 0;    ///< number of lines in the trace
};

}  // namespace beadswim
