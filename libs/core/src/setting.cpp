#include "beadswim/core/setting.hpp"

#include <fmt/format.h>

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

// The formatter of settings in messages calls this function, which <fmt/core.h> declares only.
template auto fmt::formatter<fmt::string_view>::format(const fmt::string_view& text, fmt::format_context& context)
    const -> decltype(context.out());
