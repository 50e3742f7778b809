#include "sim/cave/parameters.hpp"

#include "sim/contour/walls.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/markers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Tolerance for rounding errors, in automaton steps. Frame times are multiples of the frame duration only
/// up to rounding.
constexpr double hair = 1e-6;
constexpr double maxCells = 1 << 28;

}  // namespace

CaveParameters::CaveParameters() {
  display.layer = FieldDisplay::Layer::none;
  display.stops = {floor, rock};
  display.smooth = false;
}

void CaveParameters::describe(scene::Fields& f) {
  f.pair("size", size, {1, 32768}, "cells", "Width and depth; the border is rock.");
  if (static_cast<double>(size.x) * size.y > maxCells)
    f.error("size", fmt::format("a cave has at most {} cells; make \"size\" smaller", 1 << 28));
  f.number("fill", fill, {0, 1}, "", "Probability that a cell is rock at first.");
  f.integer("smoothing", smoothing, {0, 100}, "",
            "Steps in which a cell becomes rock where at least 5 of the 9 around it are.");
  f.integer("smallestRoom", smallestRoom, {0, 1e9}, "cells",
            "Smaller open regions become rock; the largest stays.");
  f.integer("smallestRock", smallestRock, {0, 1e9}, "cells", "Smaller regions of rock become open.");
  f.boolean("connect", connect, "Joins rooms by corridors, each with its nearest.");
  f.integer("corridor", corridor, {1, 64}, "cells", "Width of corridors.");
  f.number("stepSeconds", stepSeconds, {0, 1e6}, "s",
           "Time between the steps that grow the cave: each smoothing of the noise, then removal, then "
           "corridors; 0: all before the first frame.");
  if (f.version() > 1 && !f.given("transition")) transition = 1;
  f.number(
      "transition", transition, {0, 1}, "",
      "Part of each step in which the solid's walls move from the stage before to the new one; 0: they "
      "jump. The cells and the path change at the start of the step.");
  f.leftOut("transition", "1, or 0 in version 1");
  f.idleUnless(stepSeconds > 0, "stepSeconds", {"transition"}, "a cave with \"stepSeconds\"");
  f.vector("position", position, scene::anyNumber, "m", "Middle of the floor.");
  f.number("cell", cell, scene::positive, "m", "Side of a cell.");
  f.number("height", height, scene::notNegative, "m", "Height of the walls.");
  f.number("base", base, scene::positive, "m", "Rock below the floor.");
  f.boolean("ceiling", ceiling, "Closes the cave above; the sun no longer gets in.");
  f.number("roof", roof, scene::positive, "m", "Rock above a ceiling.");
  f.color("floor", floor, scene::notNegative, "Colour of the floor, linear RGB.");
  f.color("wall", wall, scene::notNegative, "Colour of the walls, linear RGB.");
  f.color("rock", rock, scene::notNegative, "Colour of the rock above them, linear RGB.");
  f.number("grip", grip, {0, 1e6}, "1/s",
           "Rate at which sliding cloth and particles with \"walls\" lose speed.");
  f.boolean("visible", visible, "Draws it as a solid.");
  f.idleUnless(connect, "connect", {"corridor"}, "rooms that \"connect\"");
  f.idleUnless(ceiling, "ceiling", {"roof"}, "a cave with a \"ceiling\"");
  f.idleUnless(visible, "visible", {"floor", "wall", "rock"}, "a cave that is \"visible\"");
  f.choice("show", show, {"cells", "distances"},
           "Value that the display shows: rock and floor, or steps from the entrance, from 0 to the number "
           "at the exit.");
  if (show == Show::distances) {
    display.stops.clear();
    display.map = "inferno";
  }
  f.group("display", "Placement of its map over the picture.", [&](scene::Fields& d) {
    display.describe(d);
    d.leftOut("layer", "\"none\"");
  });
}

int CaveParameters::stageAt(double time) const {
  if (stepSeconds <= 0) return lastStage();
  const double stage = std::floor(time / stepSeconds + hair);
  return static_cast<int>(std::clamp(stage, 0.0, static_cast<double>(lastStage())));
}

float CaveParameters::transitionAt(double time) const {
  const int stage = stageAt(time);
  if (!moves() || stage == 0) return 1;
  const double since = time / stepSeconds - stage + hair;
  return static_cast<float>(std::clamp(since / transition, 0.0, 1.0));
}

std::optional<scene::Box> CaveParameters::framed() const {
  if (!visible) return std::nullopt;
  const glm::vec2 half = 0.5F * cell * glm::vec2(size + 1);
  return scene::Box{position + glm::vec3(-half.x, -base, -half.y),
                    position + glm::vec3(half.x, height.at(0) + (ceiling ? roof : 0.0F), half.y)};
}

std::uint32_t CaveParameters::threshold() const {
  return static_cast<std::uint32_t>(std::min(std::floor(fill * 4294967296.0), 4294967295.0));
}

SolidShape CaveParameters::shape(double time) const {
  SolidShape shape;
  shape.size = size;
  shape.levels = {0.5F};
  shape.heights = heightsAt(time);
  shape.spacing = cell;
  shape.base = base;
  shape.outside = 1;
  shape.ceiling = ceiling;
  shape.roof = roof;
  return shape;
}

void CaveParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>().parts = {"distance"};
  ports.provide<PathPort>();
  ports.provide<Walls>();
}

std::span<const scene::Quantity> CaveParameters::quantities() const {
  static constexpr scene::Quantity list[] = {
      {"openCells", "", "Cells that are not rock."},
      {"pathLength", "cells", "Steps from the entrance to the exit; -1 before it is done."}};
  return list;
}

}  // namespace simreel::sim
