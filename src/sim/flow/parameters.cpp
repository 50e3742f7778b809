#include "sim/flow/parameters.hpp"

#include "base/error.hpp"
#include "sim/core/expression.hpp"
#include "sim/grid/color_map.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr const char* maps[] = {"grey", "viridis", "magma", "inferno", "plasma", "turbo"};

/// Returns a compiled expression in x and y. Throws scene::ExpressionMistake.
Expression compiled(const std::string& text) {
  static const std::vector<std::string> names = {"x", "y", "pi"};
  return Expression(
      text,
      [](const std::string& name) {
        const auto found = std::find(names.begin(), names.end(), name);
        return found == names.end() ? -1 : static_cast<int>(found - names.begin());
      },
      names);
}

void checkExpression(scene::Fields& f, const char* name, const std::string& text) {
  try {
    static_cast<void>(compiled(text));
  } catch (const scene::ExpressionMistake& mistake) {
    f.errorIn({name}, mistake.begin, mistake.end, mistake.message);
  }
}

}  // namespace

void FlowParameters::describe(scene::Fields& f) {
  f.asset(
      "file", file,
      "Velocities: npy of shape (rows, columns, 2), or CSV whose first line names x, y, u and v, a line "
      "for each point of a regular grid.");
  f.leftOut("file", "\"u\" and \"v\"");
  f.text("u", u,
         "Velocity to the right in m/s, an expression in x and y: metres from the middle, to the right and "
         "up.");
  f.text("v", v, "Velocity up in m/s, an expression in x and y.");
  f.pair("size", size, {2, 4096}, "cells",
         "Width and height of the grid on which \"u\" and \"v\" are evaluated.");
  f.choice("rows", rows, {"down", "up"},
           "Side to which the rows of an npy array follow each other, and to which its second velocity "
           "points. A CSV file has y up.");
  f.number("scale", scale, scene::anyNumber, "m/s", "Speed of a velocity of 1 in the file.");
  f.group("plane", "Rectangle in the world where the velocities are.", [&](scene::Fields& p) {
    plane.describe(p);
    ownCell = p.given("cell");
  });
  f.choice("show", show, {"speed", "none"}, "Draws the rectangle in colours of the speed, or not at all.");
  int index = 0;
  f.oneOf("colors", index, {std::begin(maps), std::end(maps)}, "Colour map of the speed.");
  f.leftOut("colors", "grey; in version 2 viridis");
  if (f.version() > 1 && !f.given("colors")) index = 1;
  map = maps[index];
  f.number("low", low, scene::notNegative, "m/s", "Speed of the first colour.");
  f.number("high", high, scene::notNegative, "m/s", "Speed of the last colour.");
  f.leftOut("high", "the greatest speed");
  ownHigh = f.given("high");
  if (ownHigh && high <= low) f.error("high", "\"high\" must be above \"low\"");
  checkExpression(f, "u", u);
  checkExpression(f, "v", v);
  f.idleUnless(file.empty(), "file", {"u", "v", "size"}, "a flow without a \"file\"");
  f.idleUnless(!file.empty(), "file", {"scale", "rows"}, "a flow with a \"file\"");
  f.idleUnless(show == Show::speed, "show", {"colors", "low", "high"}, "\"show\": \"speed\"");
}

void FlowParameters::ports(Ports& ports) const {
  ports.provide<FluidWind>();
  ports.provide<FieldSource>();
}

FlowGrid FlowParameters::gridOfFile() const {
  FlowGrid grid = readFlow(file, rows == Rows::up, plane.cell);
  if (ownCell) grid.cell = plane.cell;
  for (glm::dvec2& value : grid.values) value *= static_cast<double>(scale);
  return grid;
}

FlowGrid FlowParameters::gridOfExpressions() const {
  const Expression right = compiled(u), up = compiled(v);
  FlowGrid grid{size, plane.cell, {}};
  const double cell = plane.cell;
  for (int row = 0; row < size.y; ++row)
    for (int column = 0; column < size.x; ++column) {
      const std::array<double, 3> at = {cell * (column + 0.5 - 0.5 * size.x),
                                        cell * (0.5 * size.y - row - 0.5), 3.14159265358979323846};
      grid.values.emplace_back(right.at(at), -up.at(at));
    }
  return grid;
}

FlowGrid FlowParameters::grid() const {
  FlowGrid grid = file.empty() ? gridOfExpressions() : gridOfFile();
  constexpr double maximum = 1e6;
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    if (!(std::abs(grid.values[i].x) <= maximum && std::abs(grid.values[i].y) <= maximum)) {
      const auto width = static_cast<std::size_t>(grid.size.x);
      fail(ExitCode::usage,
           "the velocity of column {}, row {} is not a number or above 1e6 m/s; give every point a "
           "velocity (0 where there is none)",
           i % width, i / width);
    }
  return grid;
}

std::optional<scene::Box> FlowParameters::framed() const {
  return show == Show::none ? std::nullopt : framedAlone();
}

std::optional<scene::Box> FlowParameters::framedAlone() const {
  try {
    const FlowGrid made = grid();
    FluidPlane placed = plane;
    placed.cell = made.cell;
    return boxOfPlane(placed, made.size);
  } catch (const UserError&) {                 // The constructor of the simulation reports this error.
  } catch (const scene::ExpressionMistake&) {  // describe() has already reported this error.
  }
  return std::nullopt;
}

}  // namespace simreel::sim
