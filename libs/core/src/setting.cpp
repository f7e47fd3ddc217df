#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

std::string (*name_in_messages)(Setting) = to_text<Setting>;

}  // namespace

std::string name_of(Setting setting) {
  return name_in_messages(setting);
}

void name_settings_by(std::string (*name)(Setting)) {
  name_in_messages = name;
}

}  // namespace beadswim
