#include "sim/arrows/parameters.hpp"

#include "sim/flow/look.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/moving_points.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace simreel::sim {

constinit const PortInfo ArrowSource::port = {
    .name = "velocities",
    .lacks =
        ", which has no velocities to draw; fluids, flows, particles and kernels with \"wind\" have them",
    .none = "the scene has no fluid, flow or particles whose velocities could be drawn",
    .implied =
        [](const scene::Object& provider, std::vector<std::string>& /*parts*/) {
          const Ports all = portsOf(provider);
          return std::any_of(all.offers.begin(), all.offers.end(), [](const Ports::Offer& offer) {
            return (offer.port == &FluidWind::port || offer.port == &MovingPoints::port) && offer.given;
          });
        },
};

void ArrowParameters::describe(scene::Fields& f) {
  f.text("of", of,
         "Object whose velocities it draws: a fluid, a flow, particles, or kernels with \"wind\".");
  f.optionalNumber("spacing", spacing, {1e-4, 1e4}, "m", "Distance of the arrows of a fluid or a flow.");
  f.leftOut("spacing", "a 28th of the longer side");
  f.integer("every", every, {1, 1 << 24}, "", "Draws the arrow of every n-th particle.");
  f.optionalNumber("length", length, {1e-4, 1e4}, "m",
                   "Greatest length of an arrow; arrows of faster flow have this length, too.");
  f.leftOut("length",
            "\"spacing\", so that arrows do not overlap; of particles, 8 times their size, "
            "in version 2 times the square root of \"every\"");
  f.optionalNumber("scale", scale, {1e-6, 1e6}, "s", "Length in metres of an arrow of 1 m/s.");
  f.leftOut("scale", "\"length\" at the speed \"high\"");
  describeColors(f, colors);
  speeds.describe(
      f, "Speed of the last colour, and of the longest arrows; \"auto\": the highest of the run.",
      "of a fluid its \"speed\", of a flow the greatest, of particles the greatest at the start; "
      "in version 2 \"auto\"");
  int place = 0;
  f.oneOf("anchor", place, {"middle", "tail"}, "Point of the arrow that is where its velocity is.");
  f.leftOut("anchor", "\"middle\", of particles \"tail\"");
  if (f.given("anchor")) anchor = static_cast<Anchor>(place);
  f.optionalNumber("height", height, {-1e4, 1e4}, "m",
                   "Distance of the arrows in front of the source's rectangle.");
  f.leftOut("height", "0.15 times \"length\"");
  f.boolean("sheet", sheet, "Draws the source's rectangle behind the arrows, in the colours of its field.");
  frames = widens = f.version() > 1;
  if (of.empty()) f.error("of", "whose velocities? Give \"of\", the name of a fluid, a flow or particles");
}

float ArrowParameters::lengthAt(float diameter) const {
  const double factor = widens ? std::sqrt(static_cast<double>(every)) : 1.0;
  return static_cast<float>(length.value_or(8.0 * static_cast<double>(diameter) * factor));
}

void ArrowParameters::ports(Ports& ports) const {
  if (of.empty()) return;
  ports.requireFrom<ArrowSource>(of, {"of"});
  if (sheet) ports.want<FieldSource>(of, {"of"});
  ports.provide<ColorScale>(!colors.empty(), " without \"colors\"");
}

}  // namespace simreel::sim
