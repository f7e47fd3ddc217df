#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

std::string (*name_in_messages)(Setting) = to_text<Setting>;

}  // namespace

std::string name_of(Setting setting) {
  return name_in_messages(setting);
}

void set_setting_names(std::string (*name)(Setting)) {
  name_in_messages = name;
}

}  // namespace beadswim
