#include "sim/life/parameters.hpp"

#include "sim/automata/rule/cell_rule.hpp"
#include "sim/life/cell_pattern.hpp"
#include "sim/ports/field_source.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int fittedTrail = 24;  // A fitted grid has few, large cells. Their trail shows how the pattern
                                 // moves.
constexpr std::int64_t trailCells = 1 << 20;  // Larger grids have a trail only if the scene gives it,
                                              // because it takes four times the memory of the cells.

}  // namespace

LifeParameters::LifeParameters() {
  display.smooth = false;
  // The live cells stand out from the dying ones, because the fourth colour corresponds to a level of 3/4.
  display.stops = {{0.006F, 0.009F, 0.018F},
                   {0.010F, 0.022F, 0.060F},
                   {0.014F, 0.070F, 0.130F},
                   {0.030F, 0.200F, 0.230F},
                   {1.000F, 0.820F, 0.420F}};
  display.border = display.stops.front();
}

void LifePattern::describe(scene::Fields& f) {
  f.asset("file", file,
          "Pattern as RLE, plaintext (.cells), Life 1.05 or 1.06, or macrocell (.mc); also packed (.gz).");
  glm::ivec2 corner = at.value_or(glm::ivec2(0));
  f.pair("at", corner, {-maxLifeSide, maxLifeSide}, "cells",
         "Place of its top left corner after flipping and turning; a torus wraps it round. Left out: a "
         "file made for a bounded grid (Golly's) may give it.");
  f.leftOut("at", "the middle");
  if (f.given("at")) at = corner;
  f.choice("flip", flip, {"none", "horizontal", "vertical"}, "Mirrors it, before it is turned.");
  f.integer("rotate", rotate, {0, 270}, "degrees", "Clockwise: 0, 90, 180 or 270.");
  if (file.empty()) f.error("file", "a pattern needs \"file\", for example an RLE file");
  if (rotate % 90 != 0) f.error("rotate", "patterns turn by 0, 90, 180 or 270 degrees only");
}

void LifeParameters::describe(scene::Fields& f) {
  f.pair(
      "size", size, {1, maxLifeSide}, "cells",
      "Width and height of the grid; 2 bits of memory a cell. Left out beside patterns: the size of a "
      "pattern made for a bounded grid, else 16 to 9 with a margin of half the longest side around them.");
  f.leftOut("size",
            "[512,512], or fits the patterns; in version 2 128^2 cells with the picture's aspect ratio");
  display.sized = f.given("size");
  f.text(
      "rule", rule,
      "\"B3/S23\" (or \"23/3\", survival first), with letters of arrangements (\"B2-a/S12\"), of four or "
      "six "
      "neighbours (V, H); Generations (\"/2/3\"), Larger than Life, cyclic, MAP, Wolfram's (\"W110\"), or "
      "a "
      "name: see below. Not "
      "given: of the first pattern that names one, else B3/S23.");
  if (!rule.empty()) {
    CellRule read;
    if (const RuleProblem problem = parseCellRule(rule, read); !problem.message.empty())
      f.error("rule", fmt::format("character {} of the rule: {}", problem.at + 1, problem.message));
  }
  f.asset("ruleFile", ruleFile,
          "A rule as a file of Golly's format .rule (@TABLE or @TREE), instead of \"rule\".");
  if (!rule.empty() && !ruleFile.empty()) f.error("ruleFile", "give \"rule\" or \"ruleFile\", not both");
  f.choice("border", border,
           {"torus", "dead", "cylinder", "klein", "kleinSideways", "crossSurface", "sphere"},
           "torus: each edge meets the opposite one; dead: beyond the edge nothing lives; cylinder: left "
           "meets right; klein: a torus whose top meets the bottom reversed; kleinSideways: a torus whose "
           "left meets the right reversed; crossSurface: both; sphere: top meets left, right meets bottom. "
           "Left out: the border of a pattern made for a bounded grid, if there is one.");
  f.leftOut("border", "\"torus\", or a pattern's");
  borderGiven = f.given("border");
  f.pair("shift", shift, {-maxLifeSide, maxLifeSide}, "cells",
         "Shift of a torus or a Klein bottle: cells beyond the lower edge are this much further right, or "
         "cells beyond the right edge this much further down.");
  if (f.given("shift") && f.given("size"))
    if (const std::string problem = shape().problem(size); !problem.empty()) f.error("shift", problem);
  f.number("fill", fill, {0, 1}, "",
           "Fraction of cells alive at the start, by a hash of place and seed; of cyclic rules and rule "
           "files in "
           "any state but 0. 0 where patterns are given and this is not.");
  f.leftOut("fill", "0.3, or 0");
  fillGiven = f.given("fill");
  f.list(
      "patterns", patterns, "Pattern files set into the first state; their living cells are added.",
      [](scene::Fields& g, LifePattern& pattern) { pattern.describe(g); }, 4096);
  if (!patterns.empty() && !f.given("fill")) fill = 0;
  fitted = !patterns.empty() && !f.given("size");
  if (fitted) display.fit = FieldDisplay::Fit::contain;
  f.list("strokes", strokes, "Timed brush strokes.", [](scene::Fields& g, StrokeParameters& stroke) {
    stroke.describe(g, 255, "The state that is painted: 1 alive, 0 dead.");
  });
  f.number("stepsPerSecond", stepsPerSecond, {1e-3, 1e6}, "1/s",
           "Generations a second, whatever the frame rate.");
  const bool fewCells = f.version() > 1 && patterns.empty() && !display.sized;
  if (fewCells) size = {128, 128};
  const bool fewGiven = f.version() > 1 && std::int64_t{size.x} * size.y <= trailCells;
  if (fitted || fewGiven) trail = fittedTrail;
  f.integer("trail", trail, {0, maxTrail}, "steps",
            "For how long dead cells fade, of two states; needs another byte a cell; 0: no trail.");
  trailGiven = f.given("trail");
  f.leftOut("trail", "0; 24 where the grid fits patterns, or in version 2 has at most 2^20 cells");
  if (trail > 0) display.high = brightLevel();
  f.group("display",
          "How it is laid over the picture. Values: 0 dead, 1 alive; with a trail 0 to trail for what has "
          "died, a third more for the living. Of several states each has a colour: with those that age the "
          "last is for 1, and 2 and on go down to the second; else they are spread from the first to the "
          "last. A grid that fits its patterns is shown whole (\"contain\").",
          [&](scene::Fields& g) {
            display.describe(g);
            colorsGiven = g.given("stops") || g.given("map");
            g.leftOut("high", "1, or by trail");
            g.leftOut("fit", "\"cover\", or \"contain\"");
          });
}

void LifeParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>();
}

std::span<const scene::Quantity> LifeParameters::quantities() const {
  static const scene::Quantity table[] = {{"population", "cells", "Living cells."},
                                          {"density", "", "Fraction of cells alive."},
                                          {"generation", "steps", "Steps taken."}};
  return table;
}

}  // namespace simreel::sim
