#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aims.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/io/document_stream.hpp"
#include "evaluation.hpp"
#include "search.hpp"

namespace beadswim {

constexpr const char* optimise_name = "beadswim-optimise";

/// Prints a line of the report on standard error.
void say(const std::string& text);

/// A theory method or a model with its name.
struct NamedEvaluator {
  std::string name;
  std::unique_ptr<Evaluator> evaluator;
};

/// The search for the best values of one layout. It reports on standard error.
class Optimisation {
 public:
  /// `trace`: takes a line of JSON per evaluation. The arguments must exist as long as the object.
  Optimisation(const StreamMember& member, const Aims& aims, const std::vector<FreeValue>& free,
               const NamedEvaluator& by, const OpenFile& trace);

  /// Evaluates the layout as it is. Throws InputError if the method cannot treat it or does not give the
  /// outcomes of the aims, if a free quantity does not exist, or if no layout in the bounds is valid.
  void begin();

  /// Searches, and finds the ranges in which the objective is at most 1 % worse. Throws SolverError if no
  /// layout satisfies the limits.
  void find(const SearchSettings& settings);

  /// Evaluates the layout that was found by another method or model.
  void verify(const NamedEvaluator& other);

  /// Returns the layout that was found. Its study has the values found with the ends of their ranges,
  /// NAME_from and NAME_to (of the first name of a free value), and the objective, also as
  /// OBJECTIVE_by_METHOD by the method that verified it.
  const LayoutDocument& best() const { return best_; }

 private:
  void require_valid_layouts() const;
  Trial evaluate(const Position& position, const std::string& stage);
  void record(const std::string& stage, const Json& study, const Outcomes& outcomes,
              const std::string& reason = "", std::optional<bool> is_feasible = {});
  void require_found(const SearchResult& found) const;
  void report_best(const SearchResult& found) const;
  void find_range(const SearchResult& found, int index);

  const StreamMember& member_;
  Json layout_;
  const Aims& aims_;
  const std::vector<FreeValue>& free_;
  const NamedEvaluator& by_;
  const OpenFile& trace_;
  std::optional<Outcomes> given_;  ///< outcomes of the layout as it is; nullopt: a run failed
  LayoutDocument best_;
  Outcomes outcomes_;   ///< of `best_`
  std::string reason_;  ///< why a layout could last not be evaluated
  int recorded_ = 0;    ///< number of lines in the trace
};

}  // namespace beadswim
