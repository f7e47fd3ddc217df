#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/combine.hpp"
#include "beadswim/scene/defects.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"

namespace beadswim {
namespace {

constexpr const char* needed = "none; required without --fraction";

/// Gives the chosen swimmers the type of the first swimmer in the layout file `path`, and removes driving
/// that was set for these swimmers individually. Removes types that no swimmer uses any more. Throws
/// InputError if the two layouts have different units.
void mix_in(Layout& layout, const std::vector<std::size_t>& chosen_swimmers, const std::string& path) {
  if (path == "-")
    throw InputError("--with", "the layout to mix in cannot be read from standard input; name a file");
  const Layout other = read_layout(path).layout;
  require_same_units(layout, other, path);
  const std::string name = free_type_name(layout);
  layout.types[name] = other.types.at(other.swimmers.front().type);
  for (const std::size_t s : chosen_swimmers) {
    layout.swimmers[s].type = name;
    layout.swimmers[s].driving.reset();
    layout.swimmers[s].start.reset();
  }
  std::erase_if(layout.types, [&](const auto& type) {
    return std::ranges::none_of(layout.swimmers, [&](const Swimmer& s) { return s.type == type.first; });
  });
}

/// Kinds of defects with their flags.
class Defects {
 public:
  explicit Defects(CLI::App& command);

  /// Applies the defect of the command line to the layouts.
  void run(const CLI::App& program) const;

 private:
  using Change = std::function<void(Layout&)>;

  void add_numbers();
  void add_places();
  void add_drivings();
  void add_spacing();
  void add_mixture();

  /// Adds the command for one kind of defect, with the flags that all kinds have in common. `examples`: flags
  /// of each example in the help of the command.
  CLI::App& add_kind(const std::string& name, const std::vector<std::string>& examples,
                     const std::string& help, Change change) {
    CLI::App* const kind = command_.add_subcommand(name, help);
    begin_group(*kind, "Options");
    add_layout_files(*kind, files_);
    add_value(*kind, "--seed", seed_, {"N", whole_number(0, std::numeric_limits<std::int64_t>::max())},
              "Seed of the random numbers, a whole number from 0; equal seeds give equal changes");
    kind->add_flag("--repair", repair_,
                   "Move swimmers that overlap apart, to gaps of 1/20 of the smallest bead radius. Without "
                   "this flag, an overlap is an error.");
    std::vector<std::string> commands;
    for (const std::string& flags : examples)
      commands.push_back(fmt::format("beadswim-layout defect {0} swarm.json {1} >{0}.json", name, flags));
    set_footer(*kind, commands, "method/defects.md");
    kinds_.emplace_back(kind, std::move(change));
    return *kind;
  }

  /// Adds the flags --fraction and --count. `things`: what the flags count, and `otherwise`: the default,
  /// both for the help.
  void add_amount_flags(CLI::App& kind, const std::string& things, const std::string& otherwise) {
    auto* const fraction = add_value(
        kind, "--fraction", fraction_, {"F", number_between(0, 1)},
        fmt::format("Number of {}, as a fraction of the total number in the layout, from 0 to 1", things));
    add_value(kind, "--count", count_, {"N", whole_number(0, 10000000), otherwise}, "Number of " + things)
        ->excludes(fraction);
  }

  void add_sigma(CLI::App& kind, const std::string& help,
                 const CLI::Validator& values = number_between(0, 1e6)) {
    add_angle(kind, "--sigma", sigma_, {"S", values}, help);
  }

  void add_random(CLI::App& kind, const std::string& help) {
    kind.add_flag("--random", random_, help)->excludes(kind.get_option("--sigma"));
  }

  /// Returns the value of --fraction or --count. Throws InputError if neither is given.
  ShareOrCount share_or_count() const {
    if (count_) return *count_;
    if (!fraction_)
      throw InputError("command line", "the flag --fraction or --count is missing; give one of them");
    return *fraction_;
  }
  /// Returns the value of --fraction or --count. Returns the fraction 1 if neither is given.
  ShareOrCount amount_or_all() const { return fraction_ || count_ ? share_or_count() : ShareOrCount{1.0}; }
  /// Draws the swimmers to change at random and returns their indices.
  std::vector<std::size_t> chosen_swimmers(const Layout& layout) const {
    return draw_swimmer_indices(layout, amount_or_all(), seed_);
  }

  CLI::App& command_;
  std::vector<std::pair<CLI::App*, Change>> kinds_;
  std::vector<std::string> files_{"-"};
  std::string other_, axis_;
  std::optional<double> fraction_, sigma_;
  std::optional<std::int64_t> count_;
  double whole_ = 0;
  std::int64_t seed_ = 1;
  bool random_ = false, repair_ = false;
};

Defects::Defects(CLI::App& command) : command_(command) {
  command.require_subcommand(1);
  add_numbers();
  add_places();
  add_drivings();
  add_spacing();
  add_mixture();
  set_footer(command,
             {"beadswim-layout defect jitter swarm.json --sigma 0.5 --seed 1 >jittered.json",
              "beadswim-layout defect vacancy swarm.json --fraction 0.25 | \\\n"
              "beadswim-layout defect phase --random --seed 2 >disturbed.json"},
             "method/defects.md");
}

void Defects::add_numbers() {
  auto& vacancy = add_kind("vacancy", {"--fraction 0.25", "--count 1 --seed 3"},
                           "Removes random swimmers; the remaining swimmers keep their ids.",
                           [this](Layout& layout) { add_vacancies(layout, share_or_count(), seed_); });
  add_amount_flags(vacancy, "swimmers to remove", needed);

  auto& interstitial =
      add_kind("interstitial", {"--count 2", "--fraction 0.25 --seed 3"},
               "Adds copies of the first swimmer at random positions where they fit, with new ids.",
               [this](Layout& layout) { add_interstitials(layout, share_or_count(), seed_); });
  add_amount_flags(interstitial, "swimmers to add", needed);
}

void Defects::add_places() {
  auto& displaced = add_kind(
      "jitter", {"--sigma 0.5", "--sigma 2 --fraction 0.5 --seed 3"}, "Displaces swimmers by random vectors.",
      [this](Layout& layout) { jitter(layout, chosen_swimmers(layout), *sigma_, seed_); });
  add_sigma(displaced, "Standard deviation of the random displacement along each axis [length]");
  add_amount_flags(displaced, "swimmers to move", "all");

  auto& turned = add_kind("rotation", {"--sigma 0.1", "--random --count 1 --repair"},
                          "Turns swimmers about their middle bead by random angles.",
                          [this](Layout& layout) { rotate(layout, chosen_swimmers(layout), sigma_, seed_); });
  add_sigma(turned,
            "Standard deviation of the angle by which a swimmer turns, about a random line perpendicular to "
            "its axis, as 0.1 or 5deg [rad]",
            angle(0));
  add_random(turned, "Draw the new axes uniformly from all directions, instead of angles with --sigma.");
  add_amount_flags(turned, "swimmers to turn", "all");

  auto& regions = add_kind("domains", {"--count 1", "--count 2 --repair"},
                           "Divides the box into domains around random points. The swimmers nearest to one "
                           "point get the same random direction.",
                           [this](Layout& layout) { add_domains(layout, *count_, seed_); });
  add_value(regions, "--count", count_, {"N", whole_number(1, 10000)},
            "Number of domains, each with its own direction")
      ->required();
}

void Defects::add_drivings() {
  auto& phases =
      add_kind("phase", {"--sigma 0.3", "--random --seed 3"},
               "Adds a random shift to the driving phase of swimmers (key phase_offset).",
               [this](Layout& layout) { disorder_phases(layout, chosen_swimmers(layout), sigma_, seed_); });
  add_sigma(phases, "Standard deviation of the phase shift, as 0.1 or 5deg [rad]", angle(0));
  add_random(phases, "Draw the phase shifts uniformly from -pi to pi, instead of a normal distribution.");
  add_amount_flags(phases, "swimmers to change", "all");

  auto& amplitudes = add_kind(
      "amplitude", {"--sigma 0.1", "--sigma 0.2 --count 2 --seed 3"},
      "Multiplies the driving amplitudes A and B of a swimmer by 1 + sigma x, with a normal random number x.",
      [this](Layout& layout) { disorder_amplitudes(layout, chosen_swimmers(layout), *sigma_, seed_); });
  add_sigma(amplitudes, "Standard deviation of the relative change [1]");
  add_amount_flags(amplitudes, "swimmers to change", "all");

  auto& frequencies = add_kind(
      "frequency", {"--sigma 0.05", "--sigma 0.1 --count 2 --seed 3"},
      "Multiplies the driving frequency 1/T of a swimmer by 1 + sigma x, with a normal random number x.",
      [this](Layout& layout) { disorder_frequencies(layout, chosen_swimmers(layout), *sigma_, seed_); });
  add_sigma(frequencies, "Standard deviation of the relative change [1]");
  add_amount_flags(frequencies, "swimmers to change", "all");
}

void Defects::add_spacing() {
  auto& layers =
      add_kind("spacing", {"--axis y --sigma 1", "--axis x --sigma 4 --whole 1 --seed 3"},
               "Changes the gaps between layers of swimmers at random, and the length of the box by the sum "
               "of the changes.",
               [this](Layout& layout) {
                 const LayerSpacing spacing{.axis = axis_[0] - 'x', .sigma = *sigma_, .whole = whole_};
                 space_layers(layout, spacing, amount_or_all(), seed_);
               });
  add_value(layers, "--axis", axis_, {"x|y|z", one_of({"x", "y", "z"})}, "Axis perpendicular to the layers")
      ->required();
  add_sigma(layers, "Standard deviation of the random change of a gap [length]");
  add_value(layers, "--whole", whole_, {"L", finite_positive(), "none"},
            "Length to whose multiples the changes of gaps are rounded, for example the edge of a lattice "
            "cell [length]");
  add_amount_flags(layers, "gaps to change", "all");
}

void Defects::add_mixture() {
  auto& mixture = add_kind(
      "mixture", {"--with layout.json --count 2", "--with layout.json --fraction 0.5 --seed 3"},
      "Replaces the type (beads, springs, driving) of random swimmers; they keep their position and axis.",
      [this](Layout& layout) {
        mix_in(layout, draw_swimmer_indices(layout, share_or_count(), seed_), other_);
      });
  add_value(mixture, "--with", other_, {"FILE"}, "Layout file whose first swimmer has the new type")
      ->required();
  add_amount_flags(mixture, "swimmers to change", needed);
}

void Defects::run(const CLI::App& program) const {
  const auto& [kind, change] = *std::ranges::find_if(kinds_, [](const auto& k) { return k.first->parsed(); });
  if (kind->get_option_no_throw("--sigma") && !random_ && !sigma_)
    throw InputError("command line", kind->get_option_no_throw("--random")
                                         ? "the flag --sigma or --random is missing; give one of them"
                                         : "the flag --sigma is missing; give a value");
  filter_layouts(files_, program, FilterOutput::like_input,
                 [&](const StreamMember&, LayoutDocument document, const auto& emit) {
                   change(document.layout);
                   if (repair_) repair_overlaps(document.layout);
                   require_sound(document.layout, "the defects",
                                 repair_ ? "" : "; --repair moves swimmers apart");
                   warn_of_fixed_forces(document.layout);
                   emit(document);
                 });
}

}  // namespace

Command add_defect_command(CLI::App& program) {
  CLI::App* const command =
      program.add_subcommand("defect",
                             "Applies random changes (defects) to a layout. Equal seeds give equal "
                             "defects; give each defect of a pipe its own seed.");
  const auto defects = std::make_shared<Defects>(*command);
  return {command, [defects, &program] { defects->run(program); }};
}

}  // namespace beadswim
