#include "beadswim/figure/drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/figure/figure.hpp"
#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/figure/swimmer_sketch.hpp"
#include "notes_on_page.hpp"

namespace beadswim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string repeated(const std::string& word, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += word + " ";
  return text;
}

TEST(Note, ShortNotesKeepTheirTexts) {
  EXPECT_THAT(shorten_notes({{.text = "T = 4800", .summary = "T"}, {}, {.text = "marks"}}),
              ElementsAre("T = 4800", "marks"));
  EXPECT_THAT(shorten_notes({}), IsEmpty());
}

TEST(Note, TheLastSummariesReplaceTextsFirst) {
  const std::string thirty = repeated("a", 30), long_text = repeated("b", 31);
  EXPECT_THAT(shorten_notes({{.text = thirty, .summary = "first"}, {.text = long_text, .summary = "last"}}),
              ElementsAre(thirty, "last"));
  EXPECT_THAT(shorten_notes({{.text = long_text, .summary = "first"}, {.text = thirty}}),
              ElementsAre("first", thirty));
}

TEST(Note, NotesThatDoNotFitAreOmittedAsAWhole) {
  const std::string forty = repeated("a", 40);
  EXPECT_THAT(shorten_notes({{.text = forty}, {.text = forty}}), ElementsAre(forty));
}

std::vector<Note> sixty_words() {
  return {{.text = repeated("parameter", 45)}, {.text = repeated("λ", 15)}};
}

/// Checks that all words of the notes are in the figure, below the drawing and inside the page.
void expect_notes_on_page(const std::string& svg, double bottom_of_drawing) {
  const std::vector<NoteLine> lines = notes_on_page(svg);
  std::size_t words = 0;
  for (const NoteLine& line : lines) {
    words += line.words;
    EXPECT_GT(line.baseline - note_height, bottom_of_drawing);
    EXPECT_LT(line.right, page_width(svg));
    EXPECT_LT(line.baseline, page_height(svg));
  }
  EXPECT_EQ(words, 60U);
}

TEST(Note, NotesOfAFigureAreBelowThePanelAndInsideThePage) {
  Panel panel{.x_label = {"T"}, .y_label = {"v"}};
  for (int i = 0; i < 30; ++i) panel.series.push_back({.label = "lbm", .x = {1, 2}, .y = {1, 2}});
  const std::string svg = draw(Figure{.title = "Speed", .panels = {panel}, .notes = sixty_words()}).svg;
  expect_notes_on_page(svg, 52 + 30 * 18);  // top of the panel, and its legend
}

TEST(Note, LinesDoNotBreakInsideEquations) {
  const Panel panel{.x_label = {"T"}, .y_label = {"v"}, .series = {{.label = "", .x = {1, 2}, .y = {1, 2}}}};
  for (std::size_t before = 1; before < 15; ++before) {
    const std::string svg =
        draw(Figure{.title = "Speed",
                    .panels = {panel},
                    .notes = {{.text = repeated("beads", before) + "T = 4800, box 1 × 2 × 3"}}})
            .svg;
    EXPECT_THAT(svg, testing::HasSubstr("T = 4800,"));
    EXPECT_THAT(svg, testing::HasSubstr("1 × 2 × 3<"));
  }
}

TEST(Note, NotesOfASwarmAreInsideThePage) {
  SwarmPicture picture{.title = "Swarm", .box = {10, 200, 200}};
  picture.swimmers.push_back({.beads = {{{1, 1, 1}, 1}, {{3, 1, 1}, 1}, {{5, 1, 1}, 1}}});
  picture.notes = sixty_words();
  expect_notes_on_page(draw(picture).svg, 44);
}

TEST(Note, NotesOfASketchAreInsideThePage) {
  SwimmerSketch sketch{.title = "Swimmer", .radii = {4, 4, 4}, .rest_lengths = {9, 9}};
  sketch.notes = sixty_words();
  expect_notes_on_page(draw(sketch).svg, 200);
}

}  // namespace
}  // namespace beadswim
