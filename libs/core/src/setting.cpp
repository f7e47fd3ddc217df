#include "beadswim/core/setting.hpp"

#include <algorithm>
#include <array>
#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>

namespace beadswim {
namespace {

#define BEADSWIM_IDENTIFIER(r, data, setting) BOOST_PP_STRINGIZE(setting),
constexpr std::array identifiers{
    BOOST_PP_SEQ_FOR_EACH(BEADSWIM_IDENTIFIER, , BOOST_PP_VARIADIC_TO_SEQ(BEADSWIM_SETTINGS))};

std::string (*name_in_messages)(Setting) = words_of;

}  // namespace

const char* identifier_of(Setting setting) {
  return identifiers[static_cast<std::size_t>(setting)];
}

std::string words_of(Setting setting) {
  std::string words = identifier_of(setting);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string name_of(Setting setting) {
  return name_in_messages(setting);
}

void set_setting_names(std::string (*name)(Setting)) {
  name_in_messages = name;
}

}  // namespace beadswim
