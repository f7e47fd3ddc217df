#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/document_stream.hpp"

namespace beadswim {

/// Form in which a filter writes layouts: one per line, or like its input.
enum class FilterOutput { lines, like_input };

/// Adds the positional argument of a command that reads layouts.
CLI::Option* add_layout_files(CLI::App& command, std::vector<std::string>& files);

/// Reads layouts, calls change(member, layout, emit) for each, and writes the layouts that are passed to
/// emit(), with this program in their provenance. Writes nothing before all layouts have been changed, so
/// that an InputError leaves no partial output.
void filter_layouts(const std::vector<std::string>& files, const CLI::App& program, FilterOutput output,
                    const std::function<void(const StreamMember& member, LayoutDocument layout,
                                             const std::function<void(LayoutDocument)>& emit)>& change);

/// Prints warning_of_fixed_forces(), each text once.
void warn_of_fixed_forces(const Layout& layout);

}  // namespace beadswim
