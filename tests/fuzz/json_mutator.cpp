#include <cmath>
#include <random>

#include "accepted.hpp"
#include "beadswim/io/json.hpp"

// Changes that libFuzzer makes to an input. An input that is valid JSON usually stays valid JSON: one or a
// few values, members or elements change. All other inputs get the usual changes of libFuzzer.

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace beadswim {
namespace {

using Random = std::minstd_rand;

std::size_t below(std::size_t count, Random& random) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

Json odd_value(Random& random) {
  static const std::vector<Json> values{nullptr,
                                        true,
                                        false,
                                        "",
                                        "lattice",
                                        "a",
                                        0,
                                        -0.0,
                                        1,
                                        -1,
                                        2,
                                        64,
                                        0.5,
                                        1e-12,
                                        1e-300,
                                        5e-324,
                                        1e16,
                                        1e300,
                                        -1e300,
                                        1e308,
                                        1.0,
                                        1000000000,
                                        2147483648,
                                        -2147483649,
                                        4294967296,
                                        INT64_MAX,
                                        INT64_MIN,
                                        UINT64_MAX,
                                        1e18,
                                        9007199254740993,
                                        3.141592654,
                                        Json::object(),
                                        Json::array()};
  return values[below(values.size(), random)];
}

void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  if (!value.is_structured()) return;
  for (Json& member : value) collect(member, all);
}

Json changed_number(double number, Random& random) {
  switch (below(4, random)) {
    case 0:
      return -number;
    case 1:
      return std::nextafter(number, HUGE_VAL);
    case 2:
      return number * std::pow(10.0, static_cast<double>(below(13, random)) - 6);
    default:
      return std::normal_distribution<double>(number, 1)(random);
  }
}

/// Removes or duplicates an element of an array.
void change_elements(Json& array, Random& random) {
  constexpr std::size_t most = 200;
  const auto place = array.begin() + static_cast<std::ptrdiff_t>(below(array.size(), random));
  if (below(2, random) == 0 || array.size() >= most) {
    array.erase(place);
  } else {
    const Json element = *place;
    array.insert(place, element);
  }
}

/// Removes or renames a member of an object.
void change_members(Json& object, const std::string& name, Random& random) {
  auto member = object.begin();
  std::advance(member, static_cast<std::ptrdiff_t>(below(object.size(), random)));
  const Json value = member.value();
  object.erase(member);
  if (below(2, random) == 0) object[name] = value;
}

void change(Json& document, Random& random) {
  std::vector<Json*> all;
  collect(document, all);
  Json& value = *all[below(all.size(), random)];
  const Json other = *all[below(all.size(), random)];
  const std::size_t how = below(6, random);
  if (how == 0) {
    value = odd_value(random);
  } else if (how == 1) {
    value = other;
  } else if (value.is_number()) {
    value = changed_number(value.get<double>(), random);
  } else if (value.is_array() && !value.empty()) {
    change_elements(value, random);
  } else if (value.is_object() && !value.empty()) {
    change_members(value, other.is_string() ? other.get<std::string>() : "other", random);
  }
}

/// Returns the input with some changes; an empty text if the input is not valid JSON.
std::string changed(const std::uint8_t* data, std::size_t size, Random& random) {
  Json document = Json::parse(data, data + size, nullptr, false);
  if (document.is_discarded()) return "";
  for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) change(document, random);
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace
}  // namespace beadswim

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  beadswim::Random random(seed);
  const bool keeps_grammar = beadswim::below(8, random) != 0;
  const std::string text = keeps_grammar ? beadswim::changed(data, size, random) : "";
  if (text.empty() || text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
