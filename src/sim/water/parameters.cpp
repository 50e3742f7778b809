#include "sim/water/parameters.hpp"

#include "sim/mesh/height_field.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/landform.hpp"
#include "sim/ports/markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::array<const char*, 4> sideNames = {"west", "east", "north", "south"};
constexpr std::int64_t maxCells = 8192LL * 8192;
constexpr scene::Range heights{-1e4, 1e4};

}  // namespace

WaterParameters::WaterParameters() {
  display.layer = FieldDisplay::Layer::none;
  display.map = "viridis";
  display.high = 1;
}

void WaterParameters::describe(scene::Fields& f) {
  f.pair("size", size, {2, 16384}, "cells", "Cells along x and z.");
  if (std::int64_t{size.x} * size.y > maxCells)
    f.error("size", fmt::format("{}x{} are more than {} cells", size.x, size.y, maxCells));
  f.number("cell", cell, {1e-3, 1e3}, "m", "Side of a cell.");
  f.vector("position", position, scene::anyNumber, "m", "The grid's middle, at level 0.");
  describeStart(f);
  describeFlow(f);
  f.list(
      "floats", floats, "Bodies that float on the water and push it.",
      [this](scene::Fields& b, WaterFloat& body) {
        body.describe(b);
        const glm::vec2 half = 0.5F * cell * glm::vec2(size);
        if (std::abs(body.position.x) > half.x || std::abs(body.position.z) > half.y)
          b.error("position", fmt::format("it starts outside the water, which reaches {:g} m along x and "
                                          "{:g} m along z from its middle",
                                          half.x, half.y));
      },
      64);
  describeLook(f);
  restsOnGround = f.version() > 1;
  rainOnPond(f);
}

bool WaterParameters::staysPond(const scene::Fields& f) const {
  if (f.given("level") || f.given("pools")) return false;
  return f.version() > 1 ? !ownTerrain : !f.given("terrain");
}

WaterRain WaterParameters::pondRain(int version) const {
  const float smaller = std::min(static_cast<float>(size.x), static_cast<float>(size.y)) * cell;
  WaterRain all;
  all.rate = 60;
  all.radius = all.height = 0.017F * smaller;
  if (version > 1) {
    all.duration = 0.1;
    all.variation = 0.6;
  }
  return all;
}

void WaterParameters::rainOnPond(scene::Fields& f) {
  f.leftOut("rain",
            "rain on a round pond, if none of \"level\", \"pools\", \"terrain\", \"rainfall\", "
            "\"drops\" and \"strokes\" is given; else off. In version 2 a pond stays a pond with the last "
            "three, and with a \"terrain\" of colours alone");
  const bool wetted = f.given("rainfall") || f.given("drops") || f.given("rain") || f.given("strokes");
  if (!staysPond(f) || (wetted && f.version() == 1)) return;
  const glm::vec2 extent = glm::vec2(size) * cell;
  const float smaller = std::min(extent.x, extent.y);
  isPond = true;
  if (!wetted) rain = pondRain(f.version());
  clarity = 0.045F * smaller;
  if (!ownGround) ground = {0.17F, 0.165F, 0.07F};
  pondTerrain(extent, smaller);
}

/// Sets the default terrain of the pond: a hollow between hills, with two stones.
void WaterParameters::pondTerrain(glm::vec2 extent, float smaller) {
  struct Hill {
    float x, z, across, along, height;
  };
  constexpr Hill shape[] = {
      {-0.06F, 0.12F, 0.58F, 0.62F, -0.22F},   {0.32F, -0.44F, 0.3F, 0.26F, 0.12F},
      {-0.22F, -0.5F, 0.36F, 0.22F, 0.09F},    {0.5F, 0.05F, 0.2F, 0.4F, 0.08F},
      {0.14F, -0.12F, 0.075F, 0.055F, 0.058F}, {0.2F, -0.07F, 0.045F, 0.04F, 0.042F},
  };
  bed = 0.1F * smaller;
  hills.clear();
  for (const Hill& h : shape)
    hills.push_back({glm::vec3(h.x * extent.x, 0, h.z * extent.y),
                     glm::vec3(h.across * extent.x, 0, h.along * extent.y), h.height * smaller});
}

void WaterParameters::describeStart(scene::Fields& f) {
  f.number("level", level, heights, "m",
           "Level of the water at the start; where the bed is higher, it is dry.");
  f.list("pools", pools, "Parts with a level of their own at the start: a dam's two sides, say.",
         [](scene::Fields& p, WaterPool& pool) {
           p.vector("from", pool.from, scene::anyNumber, "m",
                    "A corner, from the grid's middle; y is unused.");
           p.vector("to", pool.to, scene::anyNumber, "m", "The corner opposite.");
           p.number("level", pool.level, heights, "m", "Within it.");
         });
  f.group("terrain", "Ground under the water.", [&](scene::Fields& t) {
    t.number("bed", bed, heights, "m", "Height of a flat bed; unused with an image.");
    t.text(
        "object", groundObject,
        "Object whose heights are the ground, at each moment: kernels with a \"terrain\" that collides, or "
        "a plane with \"deform\" that collides. Beside it the ground has the height \"bed\". The object "
        "draws itself. Ground that rises lifts the water on it.");
    t.asset("image", terrain,
            "Picture of heights (heightmap): \"low\" where it is black, \"high\" where white; a PNG may "
            "have 16 bits.");
    t.number("low", terrainLow, heights, "m", "Height where the image is black.");
    t.number("high", terrainHigh, heights, "m", "Height where the image is white.");
    t.integer("smooth", terrainSmooth, {0, 64}, "",
              "Times that an image's heights are averaged over nine cells; an image of 8 bits has only 256 "
              "heights.");
    t.list("hills", hills, "Round hills that are added, hollows where the height is negative.",
           [](scene::Fields& h, WaterHill& hill) {
             h.vector("center", hill.center, scene::anyNumber, "m",
                      "Middle, from the grid's; y is unused.");
             h.vector("radii", hill.radii, {0, 1e6}, "m", "To its foot along x and z; y is unused.");
             if (hill.radii.x < 1e-3F || hill.radii.z < 1e-3F)
               h.error("radii", "a hill is at least 0.001 m wide and deep");
             h.number("height", hill.height, heights, "m", "Height in the middle.");
           });
    for (const char* name : {"low", "high", "smooth"})
      if (terrain.empty() && t.given(name))
        t.error(name, fmt::format("\"{}\" needs an image; give \"image\"", name));
    for (const char* name : {"image", "hills"})
      if (!groundObject.empty() && t.given(name))
        t.error(name, "\"object\" gives the heights; leave one of the two out");
    if (!terrain.empty() && t.given("bed")) t.error("bed", "an image gives the heights; leave out \"bed\"");
    for (const char* name : {"bed", "object", "image", "low", "high", "smooth", "hills"})
      ownTerrain = ownTerrain || t.given(name);
    ownGround = t.given("color");
    t.color("color", ground, scene::fraction, "Colour of the ground, linear RGB.");
    t.number("roughness", groundRoughness, scene::fraction, "",
             "Roughness of the ground; 0 mirrors, 1 is matt.");
    t.asset("texture", groundTexture, "Picture laid over the ground, multiplied with its colour.");
    t.number("repeat", groundRepeat, {1e-3, 1e4}, "", "Repeats of the texture along x.");
    if (groundTexture.empty() && t.given("repeat"))
      t.error("repeat", "\"repeat\" needs a texture; give \"texture\"");
  });
}

void WaterParameters::describeFlow(scene::Fields& f) {
  f.group("sides",
          "Kind of each side; \"sea\" is still water at \"level\": \"swell\" comes from it, and waves "
          "leave into it.",
          [&](scene::Fields& s) {
            const char* const docs[] = {"Towards -x.", "Towards +x.", "Towards -z.", "Towards +z."};
            for (std::size_t i = 0; i < 4; ++i)
              s.choice(sideNames[i], sides[i], {"wall", "open", "periodic", "sea"}, docs[i]);
            for (std::size_t i = 0; i < 4; i += 2)
              if ((sides[i] == WaterBorder::periodic) != (sides[i + 1] == WaterBorder::periodic))
                s.error(s.given(sideNames[i]) ? sideNames[i] : sideNames[i + 1],
                        fmt::format("\"{}\" and \"{}\" are periodic together or not at all", sideNames[i],
                                    sideNames[i + 1]));
          });
  f.list(
      "swell", swell, "Waves that come in from a side that is \"sea\"; waves of one side add up.",
      [&](scene::Fields& w, WaterSwell& wave) {
        w.oneOf("side", wave.side, {sideNames.begin(), sideNames.end()}, "Where from.");
        w.number("height", wave.height, {0, 1e3}, "m", "Height from trough to crest.");
        w.number("period", wave.period, {1e-2, 1e4}, "s", "Time from crest to crest.");
        w.number("phase", wave.phase, {-1e3, 1e3}, "periods", "0 rises through the sea's level at 0 s.");
        if (sides[static_cast<std::size_t>(wave.side)] != WaterBorder::sea)
          w.error("side", fmt::format("waves need a side that is \"sea\", and \"{}\" is not; set it in "
                                      "\"sides\", or choose another \"side\"",
                                      sideNames[static_cast<std::size_t>(wave.side)]));
      },
      16);
  f.number("gravity", gravity, {1e-3, 1e3}, "m/s^2", "Downwards.");
  f.number("drag", drag, scene::notNegative, "1/s", "Rate at which the water loses speed everywhere.");
  f.number("manning", manning, {0, 1}, "s/m^(1/3)",
           "Roughness of the bed after Manning: 0.01 glass, 0.03 a river, 0.1 reeds.");
  f.number("rainfall", rainfall, {0, 1e9}, "mm/h", "Rain that falls evenly on everything.");
  f.integerOr("substeps", substeps, "auto", {1, 1e5}, "per frame",
              "Steps that a frame is divided into; \"auto\": so many that nothing goes farther than a "
              "quarter of a cell in one.");
  f.optionalNumber("greatestDepth", greatestDepth, {1e-6, 1e4}, "m",
                   "Greatest depth that is expected, for \"auto\" and to decide which cells count as dry.");
  f.leftOut("greatestDepth", "the first state's");
  f.optionalNumber("greatestSpeed", greatestSpeed, {0, 1e4}, "m/s",
                   "Greatest speed of the water, for \"auto\". Faster water is safe while it and its waves "
                   "go at most half a cell in a step; beyond, there is a warning.");
  f.leftOut("greatestSpeed", "sqrt(gravity * greatestDepth)");
  f.list("drops", drops, "Water that falls in at once, where there is water.",
         [](scene::Fields& d, WaterDropParameters& drop) {
           d.number("at", drop.at, scene::anyNumber, "s", "Time at which it falls.");
           d.vector("center", drop.center, scene::anyNumber, "m",
                    "Place, from the middle of the grid; y is unused.");
           d.number("radius", drop.radius, {1e-4, 1e4}, "m", "Radius of the drop.");
           d.number("height", drop.height, heights, "m",
                    "Rise of the level in its middle; below 0 it is a dent.");
         });
  f.list("drains", drains, "Holes through which water leaves, down to a film.",
         [](scene::Fields& d, WaterDrain& drain) {
           d.vector("center", drain.center, scene::anyNumber, "m",
                    "Place, from the middle of the grid; y is unused.");
           d.number("radius", drain.radius, {1e-4, 1e4}, "m", "Radius of the drain.");
           d.number(
               "speed", drain.speed, {0, 1e3}, "m/s",
               "Speed at which the level would fall in its middle: pi / 3 radius^2 speed m^3 a second.");
           d.number("from", drain.from, scene::anyNumber, "s", "Time at which it opens.");
           d.number("until", drain.until, scene::anyNumber, "s", "Time at which it closes.");
         });
  // In version 2, the keys of a pond's rain are replaced one by one.
  const bool otherwiseWet = f.given("rainfall") || f.given("drops") || f.given("strokes");
  if (f.version() > 1 && f.given("rain") && staysPond(f) && !otherwiseWet) rain = pondRain(f.version());
  f.optionalGroup(
      "rain", rain, "Drops at random places, where there is water.", [](scene::Fields& r, WaterRain& of) {
        r.number("rate", of.rate, {1e-3, 1e4}, "1/s", "Drops on the whole grid.");
        r.number("radius", of.radius, {1e-4, 1e4}, "m",
                 "Radius of the mean drop; drops have half to one and a half of it.");
        r.number("height", of.height, heights, "m", "Rise of the level in the middle of each drop.");
        r.number("duration", of.duration, {0, 10}, "s",
                 "Time over which the water of a drop arrives. 0: in one step, which leaves a cone.");
        r.number("variation", of.variation, {0, 1}, "",
                 "Part by which the heights of drops and the times between them vary at random.");
        r.number("from", of.from, scene::anyNumber, "s", "Time at which it begins.");
        r.number("until", of.until, scene::anyNumber, "s", "Time at which it ends.");
        if (of.until < of.from) r.error("until", "the rain ends before it begins");
      });
  f.list("strokes", strokes, "Timed strokes of a brush, in cells: sources.",
         [](scene::Fields& s, StrokeParameters& stroke) {
           stroke.describe(s, 1e4,
                           "Depth of water that is added (m); while a stroke lasts, of each second (m/s).");
           s.number("strength", stroke.strength, {0, 1e6}, "", "Factor on the value, by keyframes.");
         });
}

void WaterParameters::describeLook(scene::Fields& f) {
  f.boolean("collides", collides,
            "Lets cloth, and particles that collide, fall onto the water and the dry ground as onto a mesh "
            "that collides; the water does not feel it. Only one object of a scene can.");
  f.number("grip", grip, {0, 1e6}, "1/s", "Rate at which sliding objects lose speed, if it collides.");
  if (!collides && f.given("grip")) f.error("grip", "\"grip\" is for water with \"collides\": true");
  f.boolean("visible", visible, "Draws water and ground.");
  f.group("look", "The water's colours.", [&](scene::Fields& l) {
    l.color("deep", deep, scene::fraction, "Colour of deep water, linear RGB.");
    l.leftOut("deep", "the material's \"color\", else [0.003,0.022,0.024]");
    ownDeep = l.given("deep");
    l.number("roughness", roughness, scene::fraction, "", "Roughness of its surface.");
    l.leftOut("roughness", "the material's, else 0.04");
    ownRoughness = l.given("roughness");
    l.color("shallow", shallow, scene::fraction,
            "Colour of the ground seen through thin water, linear RGB.");
    l.number("clarity", clarity, {1e-4, 1e4}, "m",
             "Depth in which all but 1/e of the ground's light is lost.");
    l.number("foam", foam, {0, 1e3}, "", "White for each unit of slope beyond 0.1.");
  });
  f.idleUnless(visible, "visible", {"look"}, "water that is \"visible\"");
  f.group("display", "Placement of the depth over the picture; \"layer\" shows it.",
          [&](scene::Fields& d) { display.describe(d); });
}

std::optional<scene::Box> WaterParameters::framed() const {
  if (!visible) return std::nullopt;
  // The box is so high that the default camera looks along the water surface. For the pond, it covers only
  // the middle.
  const glm::vec3 extent = cell * glm::vec3(size.x, 0, size.y);
  glm::vec3 reach = (isPond ? 0.15F : 0.5F) * extent;
  reach.y = 0.51F * std::max(reach.x, reach.z);
  // Dry ground is framed by its own heights.
  const bool dry = !terrain.empty() && level < std::min(terrainLow, terrainHigh);
  if (dry && restsOnGround) reach.y = 0.5F * std::abs(terrainHigh - terrainLow);
  const glm::vec3 middle = position + glm::vec3(0, dry ? 0.5F * (terrainLow + terrainHigh) : level, 0);
  return scene::Box{middle - reach, middle + reach};
}

std::optional<scene::Box> WaterParameters::framedWhole() const {
  if (!visible || !isPond || !restsOnGround) return std::nullopt;
  const glm::vec3 half = 0.5F * cell * glm::vec3(size.x, 0, size.y);
  float top = bed;
  for (const WaterHill& hill : hills) top = std::max(top, bed + hill.height);
  const scene::Box flat{position - half, position + half};
  return scene::Box{flat.min + glm::vec3(0, lowestGround(), 0), flat.max + glm::vec3(0, top, 0)};
}

float WaterParameters::lowestGround() const {
  float lowest = terrain.empty() ? bed : std::min(terrainLow, terrainHigh);
  for (const WaterHill& hill : hills) lowest += std::min(hill.height, 0.0F);
  return lowest;
}

std::optional<float> WaterParameters::supportHeight() const {
  if (!visible || !restsOnGround || !groundObject.empty()) return std::nullopt;
  // The small distance keeps a flat bed in front of the ground.
  const float apart = 2e-3F * cell * static_cast<float>(std::max(size.x, size.y));
  return position.y + lowestGround() - apart;
}

bool WaterParameters::isTorus() const {
  return std::all_of(sides.begin(), sides.end(), [](WaterBorder b) { return b == WaterBorder::periodic; });
}

void WaterParameters::ports(Ports& ports) const {
  ports.want<HeightField>(groundObject, {"terrain", "object"});
  ports.provide<FieldSource>().parts = {"speed", "level"};
  ports.provide<Landform>();
  ports.provide<HeightField>(collides).path = {"collides"};
  ports.provide<Touchable>(collides);
}

}  // namespace simreel::sim
