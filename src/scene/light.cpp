#include "scene/light.hpp"

namespace simreel::scene {

void describeTemperature(Fields& fields, std::optional<double>& temperature) {
  fields.optionalNumber("temperature", temperature, blackBodyRange, "K",
                        "Colour of its light as that of a black body so hot: candles 1900, lamps 2700, "
                        "daylight 6500.");
  fields.leftOut("temperature", "the colour");
  if (fields.given("temperature") && fields.given("color"))
    fields.error("temperature", "\"temperature\" says which colour the light has; leave out \"color\"");
}

void Flicker::describe(Fields& fields) {
  fields.number("amount", amount, fraction, "", "Share of the intensity that comes and goes.");
  fields.number("rate", rate, {0.001, 1000}, "1/s", "How often it changes.");
  fields.number("sway", sway, {0, 1000}, "m",
                "How far the light moves about its position; its shadows move with it.");
}

void Spot::describe(Fields& fields) {
  fields.vector("target", target, anyNumber, "m", "What the middle of the cone points at.");
  fields.number("angle", angle, {0.1, 179}, "degrees",
                "Of the cone, from edge to edge; beyond it there is no light.");
  fields.number("softness", softness, {0, 1}, "",
                "Share of the angle over which the light fades towards the edge; 0: a sharp edge.");
}

void Light::describe(Fields& fields) {
  fields.choice("type", type, {"point", "spot"},
                "point: the same light in all directions. spot: within a cone, as \"spot\" says.");
  bool given = false;
  fields.optionalGroup("spot", given, "The cone of a light of type spot.",
                       [&](Fields& inner) { spot.describe(inner); });
  if (given && type != Type::spot)
    fields.error("spot", "\"spot\" is for lights of \"type\": \"spot\", and this one is a point");
  fields.vector("position", position, anyNumber, "m", "Where it is.");
  fields.optionalGroup("follow", follows,
                       "By a path that an object has found; it is dark while there is none.",
                       [&](Fields& inner) { follow.describe(inner); });
  if (follows && fields.given("position"))
    fields.error("position", "\"follow\" says where the light is; leave out \"position\"");
  if (type == Type::spot && !follows && !position.moves() && !spot.target.moves() &&
      position.at(0) == spot.target.at(0))
    fields.error(given ? "spot" : "position",
                 "the light stands where its \"spot\" points at, so it shines nowhere; move \"target\"");
  fields.vector("color", color, notNegative, "", "Colour of its light, linear RGB.");
  describeTemperature(fields, temperature);
  fields.choice("unit", unit, {"cd", "lm", "W"},
                "Of the intensity. cd: luminous intensity, 1 cd gives 1 lx at 1 m. lm: luminous flux, of "
                "all that it sends. W: watts of light (not of electricity), 179 lm each.");
  fields.number("intensity", intensity, notNegative, "",
                "How bright it is, in its unit, for the colour 1; the sun's intensity is in lx.");
  fields.number("radius", radius, {0.001, 1000}, "m",
                "Of the ball that shines: widens highlights; what lies within it casts no shadow.");
  fields.number("glow", glow, notNegative, "",
                "Factor on the shining ball as the camera sees it; 0 hides it.");
  fields.optionalGroup("flicker", hasFlicker, "Unrest of a flame, by a hash of name, time and seed.",
                       [&](Fields& inner) { flicker.describe(inner); });
  fields.boolean("shadow", shadow, "Whether it casts shadows.");
  fields.integer("shadowSize", shadowSize, {16, 4096}, "texels",
                 "Side of each of the six maps of its shadow.");
  fields.number("shadowSoftness", shadowSoftness, {0, 16}, "texels", "Radius of the shadow's soft edge.");
}

}  // namespace simreel::scene
