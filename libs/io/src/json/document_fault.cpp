#include "beadswim/io/document_fault.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr std::size_t max_faults_shown = 20;

std::string place(const std::string& source, const DocumentFault& fault) {
  return fault.pointer.empty() ? source : source + ":" + fault.pointer;
}

}  // namespace

void throw_if_faulty(const std::string& source, const std::vector<DocumentFault>& faults) {
  if (faults.empty()) return;
  std::string text = faults.front().message;
  for (std::size_t i = 1; i < faults.size() && i < max_faults_shown; ++i) {
    text += fmt::format("\n{}: {}", place(source, faults[i]), faults[i].message);
  }
  if (faults.size() > max_faults_shown) {
    text +=
        fmt::format("\n{}: at least {} more faults are not listed", source, faults.size() - max_faults_shown);
  }
  throw InputError(place(source, faults.front()), text);
}

}  // namespace beadswim
