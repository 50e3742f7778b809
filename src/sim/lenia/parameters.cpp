#include "sim/lenia/parameters.hpp"

#include "sim/ports/field_source.hpp"

#include <string_view>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::string_view digits62 = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr int maxKernels = 8, maxLeniaSide = 8192;

}  // namespace

// Orbium, grown from random patches with R = 13, T = 10, mu = 0.15, sigma = 0.015 and polynomial functions
// until it was stable. It glides down and to the right by 0.48 times its kernel's radius per unit of time.
const std::vector<LeniaShape>& leniaCreatures() {
  static const std::vector<LeniaShape> list = {
      {"orbium",
       {"00000000047630000000", "000001CLwjfefd710000", "00cAFq2000004bea3000", "000aa000000006egb300",
        "005b100000000bikh920", "009700000008oxxtmf60", "02b500000iGWYSKBri92", "02b7007sEQZZWNKEvlc3",
        "02be8cmyJSZVLIJGxmd4", "0alphgpAJRZZVSPIwmd4", "6epvlgmxFNVZZXLBrkb2", "4dmtlcgowEHBuokjjh90",
        "05dlf30000000007de50", "001ba00000000005da00", "0007c4000000000ad300", "0001aa20000000de4000",
        "000019d71000lpc00000", "0000004nNSKp20000000", "0000cf40000000000000"}}};
  return list;
}

float leniaDigit(char digit) {
  const auto value = digits62.find(digit);
  return value == std::string_view::npos ? 0.0F : static_cast<float>(value) / 61.0F;
}

LeniaParameters::LeniaParameters() {
  display.stops = {{0.004F, 0.006F, 0.020F},
                   {0.010F, 0.050F, 0.130F},
                   {0.040F, 0.300F, 0.340F},
                   {0.650F, 0.620F, 0.300F},
                   {1.000F, 0.900F, 0.700F}};
  display.border = display.stops.front();
}

void LeniaKernel::describe(scene::Fields& f) {
  f.number("radius", radius, {2, maxLeniaRadius}, "cells", "R, how far it reaches.");
  f.integers("rings", rings, {0, 100}, "%",
             "Heights of its rings, equally wide, from the middle outwards: [100] is one ring.");
  f.choice("core", core, {"polynomial", "exponential"},
           "Profile of a ring, r from 0 to 1 across it: (4 r (1 - r))^4, or exp(4 - 1 / (r (1 - r))).");
  f.choice("growth", growth, {"polynomial", "gaussian", "step"},
           "2 max(0, 1 - d^2 / (9 sigma^2))^4 - 1, 2 exp(-d^2 / (2 sigma^2)) - 1, or 1 for |d| <= sigma "
           "and else "
           "-1, of d = u - mu.");
  f.number("mu", mu, {0, 1}, "", "Weighted mean u of the cells around at which a cell grows most.");
  f.number("sigma", sigma, {1e-4, 1}, "", "Distance that u may have from \"mu\".");
  f.number("weight", weight, {-10, 10}, "", "Weight of this kernel in the growth.");
  bool any = false;
  for (const int ring : rings) any = any || ring > 0;
  if (!any || rings.size() > 8) f.error("rings", "a kernel has 1 to 8 rings, of which one is above 0 %");
}

void LeniaCreature::describe(scene::Fields& f) {
  std::vector<const char*> names;
  for (const LeniaShape& shape : leniaCreatures()) names.push_back(shape.name);
  f.oneOf("kind", kind, names, "Which creature.");
  glm::ivec2 corner = at.value_or(glm::ivec2(0));
  f.pair("at", corner, {-maxLeniaSide, maxLeniaSide}, "cells",
         "Place of its middle; the torus wraps it round.");
  f.leftOut("at", "the middle");
  if (f.given("at")) at = corner;
  f.integer("rotate", rotate, {0, 270}, "degrees", "Clockwise: 0, 90, 180 or 270.");
  f.boolean("mirrored", mirrored, "Mirrors left and right, before it is turned.");
  if (rotate % 90 != 0) f.error("rotate", "creatures turn by 0, 90, 180 or 270 degrees only");
}

void LeniaParameters::describe(scene::Fields& f) {
  f.pair("size", size, {1, maxLeniaSide}, "cells",
         "Width and height of the grid, a torus; 8 bytes a cell.");
  f.leftOut("size", "[256,144]; in version 2 as many cells with the picture's aspect ratio");
  display.sized = f.given("size");
  f.choice("model", model, {"lenia", "smoothLife"},
           "lenia: A' = [A + dt sum h G(K * A)] held to 0 to 1; smoothLife: A' = [A + dt (2 s(n, m) - 1)], "
           "of the "
           "filling n of a ring and m of a disc.");
  f.list(
      "kernels", kernels, "Kernels of Lenia; left out: the one kernel of Orbium.",
      [](scene::Fields& g, LeniaKernel& kernel) { kernel.describe(g); }, maxKernels);
  if (kernels.empty()) f.error("kernels", "Lenia has at least one kernel");
  f.number("timeScale", timeScale, {1, 1000}, "", "T, steps in a unit of time: dt = 1 / T.");
  f.number("stepsPerSecond", stepsPerSecond, {1e-3, 1e5}, "1/s",
           "Steps a second, whatever the frame rate.");
  f.number("radius", radius, {3, maxLeniaRadius}, "cells",
           "Radius of SmoothLife's ring; its disc is a third of that.");
  f.number("bornMin", bornMin, {0, 1}, "",
           "Least filling of the ring at which a dead cell of SmoothLife comes alive.");
  f.number("bornMax", bornMax, {0, 1}, "",
           "Greatest filling of the ring at which a dead cell comes alive.");
  f.number("surviveMin", surviveMin, {0, 1}, "",
           "Least filling of the ring at which a living cell stays alive.");
  f.number("surviveMax", surviveMax, {0, 1}, "",
           "Greatest filling of the ring at which a living cell stays alive.");
  f.number("alphaRing", alphaRing, {1e-3, 1}, "", "Softness of the limits of the ring's filling.");
  f.number("alphaDisc", alphaDisc, {1e-3, 1}, "", "Softness of the limit between dead and living.");
  const bool smooth = model == Model::smoothLife;
  f.idleUnless(!smooth, "model", {"kernels"}, "the model \"lenia\"");
  f.idleUnless(smooth, "model",
               {"radius", "bornMin", "bornMax", "surviveMin", "surviveMax", "alphaRing", "alphaDisc"},
               "the model \"smoothLife\"");
  if (bornMin > bornMax)
    f.error("bornMax", fmt::format("\"bornMin\" ({}) is above \"bornMax\" ({})", bornMin, bornMax));
  if (surviveMin > surviveMax)
    f.error("surviveMax",
            fmt::format("\"surviveMin\" ({}) is above \"surviveMax\" ({})", surviveMin, surviveMax));
  f.list(
      "creatures", creatures, "Creatures that the first state has.",
      [](scene::Fields& g, LeniaCreature& creature) { creature.describe(g); }, 1024);
  if (!creatures.empty() && !f.given("patches")) patches = 0;
  f.integer("patches", patches, {0, 10000}, "", "Squares of random values at random places at the start.");
  f.leftOut("patches", "24, or 0 beside creatures");
  f.list("strokes", strokes, "Timed brush strokes.", [](scene::Fields& g, StrokeParameters& stroke) {
    stroke.describe(g, 1, "The value that is painted, 0 to 1.");
  });
  f.group("display", "Placement of the field over the picture. Values: 0 to 1.",
          [&](scene::Fields& g) { display.describe(g); });
}

void LeniaParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>();
}

std::span<const scene::Quantity> LeniaParameters::quantities() const {
  static const scene::Quantity table[] = {{"mass", "cells", "Sum of all values."},
                                          {"area", "cells", "Cells above 0.1."}};
  return table;
}

}  // namespace simreel::sim
