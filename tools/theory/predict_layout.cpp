#include "predict_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/methods.hpp"

namespace beadswim {
namespace {

constexpr const char* all_methods = "all";
constexpr const char* stroke_method = "oseen-stroke-closed";

/// The swimmer as theory sees it; messages name layout and swimmer.
CollinearSwimmer collinear(const Layout& layout, const Swimmer& swimmer, const std::string& source) {
  try {
    return collinear_swimmer(layout.resolved_type(swimmer), swimmer.axis, layout.fluid.dynamic_viscosity());
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: swimmer {}", source, swimmer.id), error.what());
  }
}

const Swimmer& swimmer_of_id(const Layout& layout, int id, const std::string& source) {
  const auto& swimmers = layout.swimmers;
  const auto found =
      std::find_if(swimmers.begin(), swimmers.end(), [&](const Swimmer& s) { return s.id == id; });
  if (found != swimmers.end()) return *found;
  throw InputError("--swimmer", fmt::format("{} has no swimmer {}; it has {}, the first being {}", source, id,
                                            swimmers.size(), swimmers.front().id));
}

/// The first swimmer, if all others are the same to theory.
const Swimmer& swimmer_like_all(const Layout& layout, const std::string& source) {
  const Swimmer& first = layout.swimmers.front();
  const CollinearSwimmer shape = collinear(layout, first, source);
  for (const Swimmer& other : layout.swimmers) {
    if (collinear(layout, other, source) == shape) continue;
    throw InputError(source,
                     fmt::format("swimmers {} and {} differ, and a prediction is for one; name it with "
                                 "--swimmer ID, or take a smaller cell with beadswim-layout reduce",
                                 first.id, other.id));
  }
  return first;
}

bool same_length_unit(const Units& a, const Units& b) {
  if (a.lattice || b.lattice) return a.lattice == b.lattice;
  return a.length.si_factor == b.length.si_factor;
}

Stroke stroke_in_units_of(const Layout& layout, const MeasuredStroke& measured) {
  if (same_length_unit(layout.units, measured.units)) return measured.stroke;
  throw InputError("--stroke-from " + measured.source,
                   "its unit of length is not the layout's; give a run of the same layout");
}

std::vector<Prediction> predictions_by_all(const Question& question) {
  std::vector<Prediction> predictions;
  for (const Method& method : methods()) {
    if (!method.obstacle(question)) predictions.push_back(predict(method, question));
  }
  return predictions;
}

std::vector<Prediction> predictions_by(const std::vector<std::string>& names, const Question& question) {
  if (names == std::vector<std::string>{all_methods}) return predictions_by_all(question);
  std::vector<Prediction> predictions;
  for (const std::string& name : names) {
    if (name == all_methods)
      throw InputError("--method", "all stands alone; leave it out, or the other names");
    predictions.push_back(predict(find_method(name), question));
  }
  return predictions;
}

/// A stroke was given to be used: its method must be among those asked for.
void check_stroke_is_used(const std::vector<Prediction>& predictions, const Question& question) {
  if (!question.measured_stroke) return;
  const auto uses_it = [](const Prediction& prediction) { return prediction.method == stroke_method; };
  if (std::any_of(predictions.begin(), predictions.end(), uses_it)) return;
  const auto obstacle = find_method(stroke_method).obstacle(question);
  throw InputError("--stroke-from",
                   obstacle ? fmt::format("{} cannot treat this swimmer: {}", stroke_method, *obstacle)
                            : fmt::format("only {} uses a stroke; add it to --method", stroke_method));
}

}  // namespace

PredictionDocument predict_layout(const LayoutDocument& document, const std::string& source,
                                  const TheoryRequest& request,
                                  const std::optional<MeasuredStroke>& measured) {
  const Layout& layout = document.layout;
  const Swimmer& swimmer =
      request.swimmer ? swimmer_of_id(layout, *request.swimmer, source) : swimmer_like_all(layout, source);
  Question question{.swimmer = collinear(layout, swimmer, source),
                    .fluid_density = layout.fluid.density,
                    .measured_stroke = {}};
  if (measured) question.measured_stroke = stroke_in_units_of(layout, *measured);

  PredictionDocument predicted;
  predicted.units = layout.units;
  predicted.swimmer = swimmer.id;
  predicted.predictions = predictions_by(request.methods, question);
  check_stroke_is_used(predicted.predictions, question);
  predicted.provenance = document.provenance;
  return predicted;
}

}  // namespace beadswim
