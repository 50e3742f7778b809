#include "sim/life_parameters.hpp"

#include "sim/life_rule.hpp"
#include "sim/rle.hpp"

#include <fmt/format.h>

namespace simreel::sim {

LifeParameters::LifeParameters() {
  display.smooth = false;
  display.stops = {{0.012F, 0.016F, 0.028F}, {0.86F, 0.92F, 0.80F}};
}

void LifePattern::describe(scene::Fields& f) {
  f.asset("file", file, "Pattern in the RLE format.");
  f.pair("at", at, {-mostLifeSide, mostLifeSide}, "cells",
         "Its top left corner, once flipped and turned; a torus wraps it round.");
  f.choice("flip", flip, {"none", "horizontal", "vertical"}, "Mirrored, before it is turned.");
  f.integer("rotate", rotate, {0, 270}, "degrees", "Clockwise: 0, 90, 180 or 270.");
  if (file.empty()) f.error("file", "a pattern needs \"file\", an RLE file");
  if (rotate % 90 != 0) f.error("rotate", "patterns turn by 0, 90, 180 or 270 degrees only");
}

void LifeParameters::describe(scene::Fields& f) {
  f.pair("size", size, {1, mostLifeSide}, "cells",
         "Width and height of the grid; 2 bits of memory a cell.");
  f.text(
      "rule", rule,
      "Numbers of neighbours for birth and survival, \"B3/S23\" (or \"23/3\", survival first); not given: "
      "of the first pattern that names one, else B3/S23.");
  if (!rule.empty()) {
    LifeRule read;
    if (const LifeRuleProblem problem = parseLifeRule(rule, read); !problem.message.empty())
      f.error("rule", fmt::format("character {} of the rule: {}", problem.at + 1, problem.message));
  }
  f.choice("border", border, {"torus", "dead"},
           "torus: each edge meets the opposite one; dead: beyond the edge nothing lives.");
  f.number("fill", fill, {0, 1}, "",
           "Share of cells alive at the start, by a hash of place and seed; 0 where patterns are given and "
           "this is not.");
  f.list(
      "patterns", patterns, "RLE files set into the first state; their living cells are added.",
      [](scene::Fields& g, LifePattern& pattern) { pattern.describe(g); }, 4096);
  if (!patterns.empty() && !f.given("fill")) fill = 0;
  f.list("strokes", strokes, "Timed brush strokes, painted after the step of their time.",
         [](scene::Fields& g, StrokeParameters& stroke) {
           stroke.describe(g, 1, "1 paints living cells, 0 dead ones.");
         });
  f.number("stepsPerSecond", stepsPerSecond, {1e-3, 1e6}, "1/s",
           "Generations a second, whatever the frame rate.");
  f.integer("trail", trail, {0, mostTrail}, "steps",
            "For how long dead cells fade; needs another byte a cell; 0: no trail.");
  if (trail > 0) display.high = brightLevel();
  f.group("display",
          "How it is laid over the picture. Values: 0 dead, 1 alive; with a trail 0 to trail for what has "
          "died, a third more for the living.",
          [&](scene::Fields& g) { display.describe(g); });
}

std::span<const scene::Quantity> LifeParameters::quantities() const {
  static const scene::Quantity table[] = {{"population", "cells", "Living cells."},
                                          {"density", "", "Share of cells alive."},
                                          {"generation", "steps", "Steps taken."}};
  return table;
}

}  // namespace simreel::sim
