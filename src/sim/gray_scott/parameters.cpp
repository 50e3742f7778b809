#include "sim/gray_scott/parameters.hpp"

#include "sim/ports/field_source.hpp"

#include <fmt/format.h>

namespace simreel::sim {

namespace {

const std::vector<const char*> presetNames = {"spots",    "stripes", "maze", "solitons",
                                              "unstable", "leopard", "chaos"};

/// Declares a rate whose default is the preset's value; it may be animated.
void rate(scene::Fields& f, const char* name, std::optional<scene::Animated<float>>& value, float standard,
          const char* doc) {
  scene::Animated<float> read = value ? *value : scene::Animated<float>(standard);
  f.number(name, read, {0, 0.2}, "per unit of time", doc);
  f.leftOut(name, "the preset's");
  if (f.given(name)) value = read;
}

}  // namespace

FeedKill ratesOf(GrayScottPreset preset) {
  constexpr FeedKill rates[] = {{0.035F, 0.065F}, {0.040F, 0.060F}, {0.025F, 0.055F}, {0.050F, 0.065F},
                                {0.060F, 0.062F}, {0.032F, 0.063F}, {0.018F, 0.051F}};
  return rates[static_cast<std::size_t>(preset)];
}

GrayScottParameters::GrayScottParameters() {
  display.map = "magma";
  display.high = 0.4;
  display.relief = 1.0F;
}

void GrayScottParameters::describe(scene::Fields& f) {
  f.pair("size", size, {4, 32768}, "cells",
         "Width and height; the left edge meets the right, the top the bottom. In every step u and v are "
         "held to 0 to 1, and a warning tells when that changes a value.");
  f.leftOut("size", "[256,256]; in version 2 as many cells with the picture's aspect ratio");
  display.sized = f.given("size");
  f.choice("preset", preset, presetNames, "Rates by name; README.md of src/sim says what each grows.");
  const FeedKill standard = ratesOf(preset);
  rate(f, "feed", feed, standard.feed, "F, the rate at which u comes in; left out: the preset's.");
  rate(f, "kill", kill, standard.kill, "k, the rate at which v goes away; left out: the preset's.");
  f.optionalGroup(
      "health", health, "Moves the rates between two presets.", [](scene::Fields& h, GrayScottHealth& of) {
        h.number("level", of.level, {0, 1}, "", "1: the rates of \"well\"; 0: the rates of \"ill\".");
        h.choice("well", of.well, presetNames, "Preset at health 1.");
        h.choice("ill", of.ill, presetNames, "Preset at health 0.");
      });
  if (health)
    for (const char* name : {"preset", "feed", "kill"})
      if (f.given(name)) f.error(name, fmt::format("\"health\" sets the rates; leave out \"{}\"", name));
  if (feed && kill) f.idleUnless(false, "feed", {"preset"}, "rates that are not both given");
  f.optionalNumber("feedAcross", feedAcross, {0, 0.2}, "per unit of time",
                   "F at the right edge; it changes evenly from \"feed\" at the left.");
  f.optionalNumber("killDown", killDown, {0, 0.2}, "per unit of time",
                   "k at the bottom; it changes evenly from \"kill\" at the top.");
  f.boolean("axes", axes,
            "Draws scales of F and k at the edges of the picture, where \"feedAcross\" and \"killDown\" "
            "vary them.");
  if (axes && !feedAcross && !killDown)
    f.error("axes", "there is nothing to draw a scale of: give \"feedAcross\" or \"killDown\"");
  f.asset("feedImage", feedImage,
          "Picture that sets F: \"feed\" where it is black, \"feedWhite\" where white.");
  f.number("feedWhite", feedWhite, {0, 0.2}, "per unit of time", "F where \"feedImage\" is white.");
  f.asset("killImage", killImage,
          "Picture that sets k: \"kill\" where it is black, \"killWhite\" where white.");
  f.number("killWhite", killWhite, {0, 0.2}, "per unit of time", "k where \"killImage\" is white.");
  if (feedAcross && !feedImage.empty())
    f.error("feedImage", "F is set by \"feedAcross\" already; leave out one");
  if (killDown && !killImage.empty())
    f.error("killImage", "k is set by \"killDown\" already; leave out one");
  f.idleUnless(!feedImage.empty(), "feedImage", {"feedWhite"}, "a \"feedImage\"");
  f.idleUnless(!killImage.empty(), "killImage", {"killWhite"}, "a \"killImage\"");
  f.number("diffuseU", diffuseU, {0, 1e3}, "cells^2 per unit of time", "Diffusion rate of u.");
  f.number("diffuseV", diffuseV, {0, 1e3}, "cells^2 per unit of time", "Diffusion rate of v.");
  f.number("dt", dt, {1e-3, 4}, "units of time", "Length of a step.");
  for (const auto& [name, diffusion] : {std::pair{"diffuseU", diffuseU}, std::pair{"diffuseV", diffuseV}})
    if (dt * diffusion > maxGrayScottDiffusion)
      f.error(f.given(name) ? name : "dt",
              fmt::format("dt * {} is {}, and a step is stable up to {}; lower dt to {:.3g} or less", name,
                          dt * diffusion, maxGrayScottDiffusion, maxGrayScottDiffusion / diffusion));
  f.integer("steps", steps, {0, 100000}, "per frame", "Steps a frame takes.");
  f.integer("presteps", presteps, {0, 1e7}, "", "Steps before the first frame, with the rates of time 0.");
  f.asset("image", image, "Picture of v at the start: white is the value of \"seeds\", black none.");
  f.group("seeds", "Round patches of v at the start.", [&](scene::Fields& s) {
    if (!image.empty()) seedCount = 0;
    s.integer("count", seedCount, {0, 1e6}, "",
              "Number of patches, at random places; none beside an \"image\" unless given.");
    s.leftOut("count", "24, or 0");
    s.number("radius", seedRadius, {0, 1e4}, "cells", "Radius of each patch.");
    s.number("value", seedValue, {0, 1}, "", "v within them; u is the rest of 1.");
    s.number("noise", seedNoise, {0, 1}, "", "Fraction by which v differs at random from cell to cell.");
    s.idleUnless(seedCount > 0, "count", {"radius"}, "seeds of a \"count\"");
  });
  f.list("strokes", strokes, "Timed strokes of a brush.", [](scene::Fields& s, StrokeParameters& stroke) {
    stroke.describe(s, 1, "v that is painted; u becomes the rest of 1.");
  });
  f.group("display", "Placement of v over the picture.", [&](scene::Fields& d) { display.describe(d); });
  if (axes && feedAcross)
    display.across =
        FieldDisplay::Axis{"F, feed rate", feed ? *feed : scene::Animated<float>(standard.feed),
                           static_cast<float>(*feedAcross)};
  if (axes && killDown)
    display.down = FieldDisplay::Axis{"k, kill rate", kill ? *kill : scene::Animated<float>(standard.kill),
                                      static_cast<float>(*killDown)};
}

FeedKill GrayScottParameters::ratesAt(double time) const {
  if (health) {
    const float level = health->level.at(time);
    const FeedKill a = ratesOf(health->ill);
    const FeedKill b = ratesOf(health->well);
    return {a.feed + (b.feed - a.feed) * level, a.kill + (b.kill - a.kill) * level};
  }
  const FeedKill standard = ratesOf(preset);
  return {feed ? feed->at(time) : standard.feed, kill ? kill->at(time) : standard.kill};
}

void GrayScottParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>().parts = {"u"};
}

}  // namespace simreel::sim
