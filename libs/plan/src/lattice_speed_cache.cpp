#include "beadswim/plan/lattice_speed_cache.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/core/processor.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/io/fields_json.hpp"

namespace beadswim {
namespace {

/// Returns the entries that a cache file must contain to be valid for this program and this machine.
Json cache_key(int ranks) {
  return {{"schema", "beadswim/lattice-speed/1"},
          {"version", version() + " (" + revision() + ")"},
          {"processor", processor_name()},
          {"ranks", ranks}};
}

/// Writes the cache file. Errors are ignored: without the file, the next plan measures the speed again.
void write_cache(const Json& document, int ranks) {
  const std::string path = speed_cache_path(ranks);
  if (path.empty()) return;
  try {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    write_text(path, dump_json(document));
  } catch (const std::exception&) {
  }
}

/// Returns the measured time of lattice steps from the cache file; nullopt if there is no valid cache file.
std::optional<LatticeSpeed> cached_speed(int ranks) {
  const std::string path = speed_cache_path(ranks);
  std::error_code unknown;
  if (path.empty() || !std::filesystem::exists(path, unknown)) return std::nullopt;
  try {
    const Json document = parse_json(read_text(path), path);
    const Json wanted = cache_key(ranks);
    for (const auto& [name, value] : wanted.items())
      if (document.at(name) != value) return std::nullopt;
    return lattice_speed_from_json(document);
  } catch (const std::exception&) {  // a damaged file counts as absent: the speed is measured again
    return std::nullopt;
  }
}

}  // namespace

std::string speed_cache_path(int ranks) {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  std::string folder = variable("XDG_CACHE_HOME");
  if (folder.empty() && !variable("HOME").empty()) folder = variable("HOME") + "/.cache";
  return folder.empty() ? "" : fmt::format("{}/beadswim/lattice-speed-{}.json", folder, ranks);
}

LatticeSpeed speed_of_this_machine(const std::function<void(const std::string&)>& message,
                                   const Communicator& communicator) {
  std::string text;
  if (communicator.is_root()) {
    if (const auto known = cached_speed(communicator.size())) text = lattice_speed_to_json(*known).dump();
  }
  broadcast(text, communicator);
  if (text.empty()) {
    if (communicator.is_root())
      message(
          "measuring how fast this machine updates lattice cells; this measurement is made once and takes "
          "some "
          "seconds");
    const LatticeSpeed speed = LatticeSpeed::measured(communicator);
    if (communicator.is_root()) write_cache(lattice_speed_to_json(speed), communicator.size());
    return speed;
  }
  return lattice_speed_from_json(Json::parse(text)).at_present(communicator);
}

Json lattice_speed_to_json(const LatticeSpeed& speed) {
  Json json = cache_key(speed.ranks());
  json["precisions"] = speed.precisions();
  return json;
}

LatticeSpeed lattice_speed_from_json(const Json& json) {
  return {json.at("ranks").get<int>(), json.at("precisions").get<std::vector<PrecisionCost>>()};
}

}  // namespace beadswim
