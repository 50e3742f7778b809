#include "sim/mesh/deform_parameters.hpp"

#include <fmt/format.h>

namespace simreel::sim {

namespace {

const char* const directionDoc = "Direction as an angle from +x towards +z, in the mesh's own space.";

void describeRipple(scene::Fields& f, Ripple& r) {
  f.number("amplitude", r.amplitude, {-1e3, 1e3}, "m", "Height of the crests.");
  f.number("speed", r.speed, {-1e4, 1e4}, "1/s", "Radians of phase a second.");
  f.number("wavelength", r.wavelength, {1e-3, 1e4}, "m", "Distance from crest to crest.");
  f.number("decay", r.decay, {0, 1e3}, "1/m", "Rate at which it dies away from the centre.");
  glm::vec3 centre(r.centre);
  f.vector("centre", centre, {-1e4, 1e4}, "m", "Place that it spreads from, in the mesh's own space.");
  r.centre = glm::vec4(centre, 0);
}

void describeWave(scene::Fields& f, Wave& w) {
  f.number("direction", w.direction, {-360, 360}, "degrees", directionDoc);
  f.number("length", w.length, {1e-3, 1e4}, "m", "Distance from crest to crest.");
  f.number("amplitude", w.amplitude, {0, 1e3}, "m", "Height of the crests.");
  f.number("steepness", w.steepness, {0, 1}, "", "0: a sine; 1: as sharp as this amplitude allows.");
  f.number("speed", w.speed, {0, 1e3}, "m/s",
           "Speed of the crests; 0: the speed of waves of this length on deep water.");
  f.number("phase", w.initial, {-360, 360}, "degrees", "At time 0.");
}

void describeSway(scene::Fields& f, Sway& s) {
  f.number("direction", s.direction, {-360, 360}, "degrees", directionDoc);
  f.number("amplitude", s.amplitude, {0, 1e3}, "m",
           "Distance that a part leans at the height \"height\" over the base.");
  f.leftOut("amplitude", "0.2; in version 2 a fifth of \"height\"");
  f.number("base", s.base, {-1e4, 1e4}, "m", "Height below which nothing moves.");
  f.leftOut("base", "0; in version 2 the lowest point of the mesh");
  f.number("height", s.height, {1e-3, 1e4}, "m", "Above the base; the lean grows with its square.");
  f.leftOut("height", "1; in version 2 the mesh's height above the base");
  f.number("wavelength", s.wavelength, {1e-2, 1e4}, "m", "Wavelength of the gusts.");
  f.leftOut("wavelength", "3; in version 2 three times \"height\"");
  const bool fits = f.version() > 1;
  s.fitted = {fits && !f.given("amplitude"), fits && !f.given("base"), fits && !f.given("height"),
              fits && !f.given("wavelength")};
  f.number("speed", s.speed, {-1e4, 1e4}, "1/s", "Radians of the gusts' phase a second.");
  f.number("lean", s.lean, {-10, 10}, "", "Constant fraction of the amplitude.");
  f.number("gusts", s.gusts, {0, 10}, "", "Changing fraction of the amplitude.");
}

void describeFootprints(scene::Fields& f, Footprints& p) {
  f.pair("cells", p.cells, {2, 4096}, "cells", "Cells of the trail, over the width and depth of the mesh.");
  f.number("height", p.height, {-1e4, 1e4}, "m", "Height of the surface that is pressed.");
  f.number("depth", p.depth, {1e-4, 1e3}, "m", "Depth of the deepest print.");
  f.number("rim", p.rim, {0, 10}, "",
           "Height of the rim beside a print, as a fraction of the print's depth.");
  f.number("rimWidth", p.rimWidth, {1e-3, 1e3}, "m", "Width of the rim.");
}

void describePush(scene::Fields& f, Push& p) {
  f.number("softness", p.softness, {0, 1e3}, "m",
           "Distance around a collider within which the mesh bends away.");
  f.number("base", p.base, {-1e4, 1e4}, "m", "Height at which the mesh is rooted.");
  f.number("height", p.height, {0, 1e4}, "m",
           "Height above the base over which the bending grows to its full size; 0: full size everywhere.");
}

/// Returns the number of shader displacements that an entry needs: one for each wave, or one for any other
/// kind.
std::size_t displacementsOf(const DisplacementParameters& entry) {
  return entry.waves.empty() ? 1 : entry.waves.size();
}

}  // namespace

void DisplacementParameters::describe(scene::Fields& f) {
  f.optionalGroup("ripple", ripple.on, "Rings of waves from a centre.",
                  [&](scene::Fields& g) { describeRipple(g, ripple); });
  f.list("waves", waves, "Travelling waves (Gerstner) that add up.",
         [](scene::Fields& g, Wave& wave) { describeWave(g, wave); });
  f.optionalGroup("sway", sway.on, "Wind that bends the standing parts of the mesh.",
                  [&](scene::Fields& g) { describeSway(g, sway); });
  f.optionalGroup("footprints", footprints.on,
                  "Permanent prints that the scene's spheres and capsules leave.",
                  [&](scene::Fields& g) { describeFootprints(g, footprints); });
  f.optionalGroup("push", push.on, "Bends away from the scene's spheres and capsules.",
                  [&](scene::Fields& g) { describePush(g, push); });
}

void DeformParameters::describe(scene::Fields& f) {
  f.list("deform", list, "Displacements, one after the other; each entry is one of them.",
         [](scene::Fields& g, DisplacementParameters& entry) { entry.describe(g); });
  f.choice("technique", technique, {"compute", "single-thread", "jobs", "mapped", "vertex-shader"},
           "Place where deformed vertices are computed: on the device; on one thread; on all threads; on "
           "all, straight into mapped memory; or in the vertex shader that draws them.");
  f.boolean("readback", readback,
            "Makes \"compute\" copy each frame's positions to the CPU too, without waiting for them.");
  std::size_t count = 0;
  int trails = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const DisplacementParameters& d = list[i];
    count += displacementsOf(d);
    trails += d.footprints.on ? 1 : 0;
    const int named = static_cast<int>(d.ripple.on) + static_cast<int>(!d.waves.empty()) +
                      static_cast<int>(d.sway.on) + static_cast<int>(d.footprints.on) +
                      static_cast<int>(d.push.on);
    if (named != 1)
      f.error("deform",
              fmt::format("entry {} names {} displacements; it must name exactly one of \"ripple\", "
                          "\"waves\", \"sway\", \"footprints\" and \"push\"",
                          i, named));
  }
  if (count > shader::maxDisplacements)
    f.error("deform", fmt::format("{} displacements (each wave counts as one) are more than {}", count,
                                  shader::maxDisplacements));
  if (trails > 1) f.error("deform", "a mesh has one trail of footprints");
  f.idleUnless(!list.empty(), "deform", {"technique", "readback"}, "a mesh with a \"deform\"");
  if (!list.empty())
    f.idleUnless(technique == DeformTechnique::compute, "technique", {"readback"},
                 "the technique \"compute\"");
}

}  // namespace simreel::sim
