#include "sim/fluid/parameters.hpp"

#include "scene/value/implied_shape.hpp"
#include "sim/fluid/model.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

const std::vector<const char*> sideKinds = {"wall", "slip", "inflow", "open", "periodic"};

void describeSide(scene::Fields& f, const char* name, FluidSide& side) {
  f.shorthand(name, "kind");
  f.group(name, "A border of the grid, or only its kind.", [&](scene::Fields& s) {
    s.choice("kind", side.kind, sideKinds,
             "The fluid sticks to a wall and slides along a slip side; an inflow has a velocity, an open "
             "side pressure 0; two opposite periodic sides are joined.");
    s.vector("velocity", side.velocity, {-1e5, 1e5}, "cells/s",
             "Velocity of a wall along itself, or of an inflow. The third number is unused.");
    s.choice(
        "profile", side.profile, {"even", "parabola"},
        "Profile of an inflow: even, or a parabola with the velocity in the middle and 0 at both ends.");
    if (s.given("velocity") && side.kind != FluidSide::Kind::wall && side.kind != FluidSide::Kind::inflow)
      s.error("velocity", "only a \"wall\" or an \"inflow\" has a velocity");
    s.idleUnless(side.kind == FluidSide::Kind::inflow, "kind", {"profile"}, "an \"inflow\"");
  });
}

void describeStroke(scene::Fields& f, FluidStroke& stroke) {
  stroke.describe(
      f, 1, "Strength of the brush in each substep, as a part of the way to its values: 1 sets them.");
  f.number("strength", stroke.strength, {0, 1e6}, "", "Factor on \"value\" and \"force\", by keyframes.");
  f.vector("velocity", stroke.velocity, {-1e5, 1e5}, "cells/s",
           "Velocity that it sets; the third is unused.");
  f.leftOut("velocity", "not set");
  f.number("temperature", stroke.temperature, {-1e6, 1e6}, "", "Temperature that it sets.");
  f.leftOut("temperature", "not set");
  f.vector("dye", stroke.dye, {0, 8}, "", "Dye that it sets: red, green, blue.");
  f.leftOut("dye", "not set");
  f.vector("force", stroke.force, {-1e6, 1e6}, "cells/s^2", "Acceleration; the third is unused.");
  f.number("soft", stroke.soft, scene::fraction, "",
           "Fraction of the radius over which it fades towards its rim; unused for images.");
  if (f.given("velocity")) stroke.setsVelocity = true;
  if (f.given("temperature")) stroke.setsTemperature = true;
  if (f.given("dye")) stroke.setsDye = true;
}

/// Returns the default strokes: thin jets that start on an ellipse and are all aimed past the centre on the
/// same side, so that together they rotate. Each jet has two adjacent colours, one of which it has in
/// common with the next jet. `early`: true if they begin with the run rather than at 0 s.
std::vector<FluidStroke> standardStrokes(glm::ivec2 size, bool early) {
  constexpr int count = 5;
  constexpr glm::vec3 colors[count] = {{1.7F, 0.03F, 0.01F},
                                       {1.6F, 0.45F, 0.01F},
                                       {0.02F, 0.9F, 0.5F},
                                       {0.01F, 0.25F, 1.6F},
                                       {0.9F, 0.02F, 0.7F}};
  const auto w = static_cast<float>(size.x), h = static_cast<float>(size.y);
  const float scale = std::min(h / 180, w / 320);
  std::vector<FluidStroke> strokes;
  for (int i = 0; i < count; ++i) {
    const float angle = (static_cast<float>(i) + 0.25F) * 2 * std::numbers::pi_v<float> / count;
    const glm::vec2 from(0.4F * w * shader::exactCos(angle), 0.44F * h * shader::exactSin(angle));
    const glm::vec2 inward = -from / std::sqrt(from.x * from.x + from.y * from.y);
    const glm::vec2 way = 165.0F * inward + 36.0F * glm::vec2(inward.y, -inward.x);
    const glm::vec2 across = glm::vec2(-way.y, way.x) / std::sqrt(way.x * way.x + way.y * way.y);
    for (const int side : {0, 1}) {
      const glm::vec2 at =
          0.5F * glm::vec2(w, h) + from + across * (2.6F * scale * static_cast<float>(2 * side - 1));
      FluidStroke s;
      s.until = 1e6;
      s.early = early;
      s.from = s.to = glm::vec3(at, 0);
      s.radius = std::max(4.2F * scale, 1.5F);
      s.setsVelocity = s.setsDye = true;
      s.velocity = glm::vec3(std::min(scale, 1.0F) * way, 0);
      s.dye = colors[(i + side) % count];
      strokes.push_back(s);
    }
  }
  return strokes;
}

}  // namespace

FluidParameters::FluidParameters() {
  display.map = "viridis";
  strokes = standardStrokes(size, false);
}

ShownQuantity FluidParameters::shownQuantity() const {
  switch (show) {
    case Show::speed:
      return {"speed", "cells/s"};
    case Show::vorticity:
      return {"vorticity", "1/s"};
    case Show::temperature:
      return {"temperature"};
    case Show::pressure:
      return {"pressure", "cells^2/s^2"};
    default:
      return {""};
  }
}

void FluidParameters::fitPicture(glm::ivec2 picture) {
  size = display.fittedGrid(size, picture);
  if (!ownStrokes) strokes = standardStrokes(size, true);
}

void FluidParameters::describe(scene::Fields& f) {
  f.pair("size", size, {4, 16384}, "cells", "Width and height.");
  f.leftOut("size", "[320,180]; in version 2 as many cells with the picture's aspect ratio");
  display.sized = f.given("size");
  f.group("sides", "The borders of the grid.", [&](scene::Fields& s) {
    describeSide(s, "left", left);
    describeSide(s, "right", right);
    describeSide(s, "top", top);
    describeSide(s, "bottom", bottom);
    const auto paired = [&](const FluidSide& a, const FluidSide& b, const char* one, const char* other) {
      const bool first = a.kind == FluidSide::Kind::periodic, second = b.kind == FluidSide::Kind::periodic;
      if (first != second)
        s.error(first ? one : other,
                fmt::format("\"{}\" and \"{}\" are periodic both or not at all", one, other));
    };
    paired(left, right, "left", "right");
    paired(top, bottom, "top", "bottom");
  });
  f.vector("flow", flow, {-1e5, 1e5}, "cells/s", "Velocity everywhere at the start; the third is unused.");
  f.number(
      "speed", speed, {1e-3, 1e6}, "cells/s",
      "Greatest speed that is expected; it determines the \"auto\" substeps and limits the speed of dye.");
  ownSpeed = f.given("speed");
  f.integerOr("substeps", substeps, "auto", {1, 10000}, "per frame",
              "Steps that a frame is divided into; \"auto\": as many as \"speed\" / \"courant\" and the "
              "viscosity need.");
  f.number("courant", courant, {0.05, 8}, "cells",
           "Cells that fluid of the speed \"speed\" crosses in a substep, if \"substeps\" is \"auto\".");
  f.choice("advection", advection, {"macCormack", "semiLagrangian", "cubic"},
           "Scheme that carries velocity and temperature along: second-order with a limiter, first-order, "
           "or by cubic interpolation with a limiter.");
  f.number("viscosity", viscosity, {0, 1e6}, "cells^2/s", "Kinematic viscosity of the fluid.");
  f.number("confinement", confinement, {0, 1e4}, "1/s",
           "Force that keeps up vortices of the size of cells, which grow at about this rate: 1 to 5 for "
           "smoke, and from about 10 on smoke frays. It fades beyond half of \"speed\" and ends at "
           "\"speed\".");
  f.number("lift", lift, {-1e5, 1e5}, "cells/s^2", "Acceleration, up the picture, of a temperature of 1.");
  f.number("cooling", cooling, {0, 1e3}, "1/s", "Rate at which temperature falls to 0.");
  f.number("dyeWeight", dyeWeight, {-1e5, 1e5}, "cells/s^2",
           "Acceleration, down the picture, of a dye of (1, 1, 1).");
  f.integer("cycles", cycles, {1, 100}, "",
            "Most cycles of the multigrid solver for the pressure in each substep; it stops once it is "
            "exact enough.");
  f.list(
      "obstacles", obstacles, "Obstacles that stand in the fluid or move through it.",
      [](scene::Fields& o, FluidObstacle& obstacle) {
        o.choice("shape", obstacle.shape, {"circle", "box", "image"}, "Shape of the obstacle.");
        o.vector("center", obstacle.center, {-1e6, 1e6}, "cells",
                 "Place of its middle; the third number is unused. With keyframes it moves and pushes the "
                 "fluid.");
        o.number("radius", obstacle.radius, {0, 1e5}, "cells", "Radius of a circle.");
        o.vector("extent", obstacle.extent, {0, 1e5}, "cells",
                 "Width and height of a box, at least 1; the third is unused.");
        o.number("turn", obstacle.turn, {-1e5, 1e5}, "degrees", "Clockwise, about its middle.");
        o.asset("image", obstacle.image,
                "Picture of shape \"image\": light pixels are solid, grey edges are solid to a fraction of "
                "a cell.");
        scene::implyShape(o, obstacle.shape, FluidObstacle::Shape::image, "image", obstacle.image, "image",
                          "circle");
        o.number("threshold", obstacle.threshold, {0.02, 0.98}, "",
                 "Brightness at the edge of an image's obstacle, as a fraction of white.");
        o.number("scale", obstacle.scale, {1e-3, 1e3}, "cells", "Side of a pixel of an image.");
        o.boolean("measured", obstacle.measured, "Counts it in the quantities \"drag\" and \"lift\".");
        const bool image = obstacle.shape == FluidObstacle::Shape::image;
        const char* const ruler = o.given("shape") ? "shape" : "image";
        o.idleUnless(obstacle.shape == FluidObstacle::Shape::circle, ruler, {"radius"}, "a \"circle\"");
        o.idleUnless(obstacle.shape == FluidObstacle::Shape::box, ruler, {"extent"}, "a \"box\"");
        o.idleUnless(image, ruler, {"threshold", "scale"}, "an \"image\"");
        if (obstacle.shape == FluidObstacle::Shape::image && obstacle.image.empty())
          o.error("shape", "shape \"image\" needs \"image\", a picture");
      },
      shader::maxSolids);
  f.boolean("obstaclesSlip", obstaclesSlip, "Lets the fluid slip along obstacles; else it sticks to them.");
  f.color("obstacleColor", obstacleColor, {0, 1e4}, "Colour of obstacles, linear RGB.");
  ownStrokes = f.given("strokes");
  if (!ownStrokes) strokes = standardStrokes(size, f.version() > 1);
  f.list("strokes", strokes, "Timed strokes that set velocity, temperature or dye, or push.",
         describeStroke);
  f.leftOut("strokes", "jets of dye from five sides");
  f.group("plane", "Rectangle in the world where the flow is the wind of other objects.",
          [&](scene::Fields& p) { plane.describe(p); });
  f.switchable("tracers");
  f.optionalGroup("tracers", tracers, "Specks that the flow carries along and that draw streaks.");
  f.choice("show", show, {"dye", "speed", "vorticity", "temperature", "pressure", "lines"},
           "Value that is drawn: dye in its own colours, lines of flow in the colour of their speed, "
           "everything else by the display's colour map.");
  f.choice("look", look, {"light", "ink", "fire"},
           "light: dye that shines on dark; ink: dye that absorbs light on paper; fire: dye that is smoke "
           "around hot, glowing gas.");
  f.number("brightness", brightness, {0, 1e4}, "", "Brightness of dye.");
  if (look == Look::ink) paper = glm::vec3(0.94F, 0.9F, 0.82F);
  f.color("paper", paper, scene::fraction, "Colour where there is no dye, linear RGB.");
  f.leftOut("paper", "dark for \"light\" and \"fire\", a warm white for \"ink\"");
  f.integer("lineDetail", lineDetail, {1, 16}, "", "Places a cell on a side in which lines are drawn.");
  f.number("lineRate", lineRate, {0, 1e3}, "1/s", "Ripples that run along the lines, with the flow.");
  if (show == Show::lines && tracers)
    f.error("tracers", "\"tracers\" are drawn over cells, not over \"show\": \"lines\"");
  for (const char* name : {"lineDetail", "lineRate"})
    if (show != Show::lines && f.given(name))
      f.error(name, fmt::format("\"{}\" is for \"show\": \"lines\"", name));
  remarkIdle(f);
  f.optionalGroup("chart", chart, "Curves over the picture: quantities, a value each frame.");
  if (chart && chart->showsForces() && obstacles.empty())
    f.error("chart", "lift and drag need \"obstacles\"; give some, or another \"of\"");
  f.group("display", "Placement of the field over the picture.", [&](scene::Fields& d) {
    if (show == Show::speed) display.high = speed;
    if (show == Show::lines) display.high = 0.6 * speed;
    if (show == Show::lines || show == Show::temperature) display.map = "inferno";
    if (show == Show::vorticity) {
      display.map = "polar";
      display.high = 0.1 * speed;
      display.low = -display.high;
    }
    display.describe(d);
  });
}

void FluidParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>().parts = fieldParts();
  ports.provide<FluidWind>();
}

std::span<const scene::Quantity> FluidParameters::quantities() const {
  static constexpr scene::Quantity list[] = {
      {"divergence", "", "max|div u| over max|u| of the worst substep so far."},
      {"kineticEnergy", "cells^2/s^2", "Mean of u^2 / 2 over the open cells."},
      {"enstrophy", "1/s^2", "Mean of half the curl's square over the corners of cells."},
      {"dye", "", "Sum of red, green and blue of all cells."},
      {"temperature", "", "Mean over the open cells."},
      {"speed", "cells/s", "The greatest |u| or |v|."},
      {"courant", "cells", "Cells that the greatest |u| or |v| crosses in a substep."},
      {"cycles", "", "Cycles of the multigrid solver, on the average of all substeps so far."},
      {"drag", "cells^3/s^2",
       "Force of the fluid on measured obstacles, to the right, over density and depth."},
      {"lift", "cells^3/s^2",
       "Force of the fluid on measured obstacles, up the picture, over density and depth."},
  };
  return list;
}

void FluidParameters::remarkIdle(scene::Fields& f) const {
  f.idleUnless(!substeps, "substeps", {"courant"}, "\"substeps\": \"auto\"");
  f.idleUnless(heats(), "strokes", {"lift", "cooling"}, "a fluid whose \"strokes\" set a \"temperature\"");
  f.idleUnless(dyes(), "strokes", {"dyeWeight"}, "a fluid whose \"strokes\" set \"dye\"");
  f.idleUnless(!obstacles.empty(), "obstacles", {"obstaclesSlip", "obstacleColor"},
               "a fluid with \"obstacles\"");
  f.idleUnless(show == Show::dye, "show", {"look", "brightness", "paper"}, "\"show\": \"dye\"");
  f.idleUnless(show != Show::dye, "show", {"display.map", "display.stops"},
               "a \"show\" that is not \"dye\"");
}

bool FluidParameters::heats() const {
  const auto sets = [](const FluidStroke& s) { return s.setsTemperature; };
  return std::any_of(strokes.begin(), strokes.end(), sets);
}

bool FluidParameters::dyes() const {
  return std::any_of(strokes.begin(), strokes.end(), [](const FluidStroke& s) { return s.setsDye; });
}

bool FluidParameters::sinks() const {
  return dyeWeight.moves() || dyeWeight.at(0) != 0;
}

bool FluidParameters::confines() const {
  return confinement.moves() || confinement.at(0) != 0;
}

bool FluidParameters::viscous() const {
  return viscosity.moves() || viscosity.at(0) != 0;
}

bool FluidParameters::obstaclesMove() const {
  return std::any_of(obstacles.begin(), obstacles.end(), [](const FluidObstacle& o) { return o.moves(); });
}

bool FluidParameters::pocketsGrow() const {
  const auto lets = [](const FluidSide& s) { return s.kind == FluidSide::Kind::inflow; };
  return !obstacles.empty() && (obstaclesMove() || lets(left) || lets(right) || lets(top) || lets(bottom));
}

}  // namespace simreel::sim
