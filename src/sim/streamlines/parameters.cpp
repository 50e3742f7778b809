#include "sim/streamlines/parameters.hpp"

#include "sim/flow/look.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/field_source.hpp"

namespace simreel::sim {

void StreamlineParameters::describe(scene::Fields& f) {
  f.text("of", of, "Object whose flow it draws: a fluid, a flow, or kernels with \"wind\".");
  f.optionalNumber("separation", separation, {1e-4, 1e4}, "m",
                   "Distance of neighbouring lines; they come no closer than half of it.");
  f.leftOut("separation", "a 56th of the longer side");
  f.optionalNumber("length", length, {1e-4, 1e5}, "m", "Greatest length of a line.");
  f.leftOut("length", "30 times \"separation\"");
  f.optionalNumber("width", width, {1e-6, 1e4}, "m", "Diameter of the lines.");
  f.leftOut("width", "0.3 times \"separation\"");
  f.integerOr("seed", seed, "scene", {0, 1 << 30}, "",
              "Number that moves the points from which lines start; \"scene\": the scene's own seed.");
  describeColors(f, colors);
  speeds.describe(f, "Speed of the last colour; \"auto\": the highest of the run.",
                  "of a fluid its \"speed\", of a flow the greatest; in version 2 \"auto\"");
  f.optionalNumber("height", height, {-1e4, 1e4}, "m",
                   "Distance of the lines in front of the source's rectangle.");
  f.leftOut("height", "\"width\"");
  f.boolean("sheet", sheet, "Draws the source's rectangle behind the lines, in the colours of its field.");
  frames = f.version() > 1;
  if (of.empty()) f.error("of", "whose flow? Give \"of\", the name of a fluid or a flow");
}

void StreamlineParameters::ports(Ports& ports) const {
  if (of.empty()) return;
  ports.requireFrom<FluidWind>(of, {"of"});
  if (sheet) ports.want<FieldSource>(of, {"of"});
  ports.provide<ColorScale>(!colors.empty(), " without \"colors\"");
}

}  // namespace simreel::sim
