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

/// Writes a layout, with this program in its provenance, in the form that `dump` gives it.
void write_layout(LayoutDocument document, const CLI::App& program, std::string (*dump)(const Json&));

/// Writes a layout that flags describe. Throws the error of require_sound().
void write_made_layout(const Layout& layout, const CLI::App& program,
                       std::string (*dump)(const Json&) = dump_json);

/// Throws InputError with the first error that check_layout() finds in the layout. `source`: origin of the
/// layout for the message, a plural such as "the flags". `remedy`: text at the end of the message.
void require_sound(const Layout& layout, const std::string& source, const std::string& remedy = "");

/// Prints warning_of_fixed_forces(), each text once.
void warn_of_fixed_forces(const Layout& layout);

}  // namespace beadswim
