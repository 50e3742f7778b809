#include "scene/light.hpp"

#include <cstddef>

#include <fmt/format.h>

namespace simreel::scene {

void describeTemperature(Fields& fields, std::optional<double>& temperature) {
  fields.optionalNumber(
      "temperature", temperature, blackBodyRange, "K",
      "Colour of its light as the temperature of a black body: candles 1900, lamps 2700, daylight 6500.");
  fields.leftOut("temperature", "the colour");
  if (fields.given("temperature") && fields.given("color"))
    fields.error("temperature", "\"temperature\" sets the colour of the light; leave out \"color\"");
}

void Flicker::describe(Fields& fields) {
  fields.number("amount", amount, fraction, "", "Fraction of the intensity that flickers.");
  fields.number("rate", rate, {0.001, 1000}, "1/s", "Rate of change.");
  fields.number("sway", sway, {0, 1000}, "m",
                "Distance that the light moves about its position; its shadows move with it.");
  fields.idleUnless(!isNothing(amount) || !isNothing(sway), "amount", {"rate"},
                    "a flicker with an \"amount\" or \"sway\"");
}

void Spot::describe(Fields& fields) {
  fields.vector("target", target, anyNumber, "m", "Place at which the axis of the cone points.");
  fields.number("angle", angle, {0.1, 179}, "degrees",
                "Angle of the cone, from edge to edge; beyond it there is no light.");
  fields.number("softness", softness, {0, 1}, "",
                "Fraction of the angle over which the light fades towards the edge; 0: a sharp edge.");
}

void Area::describe(Fields& fields) {
  fields.vector("target", target, anyNumber, "m", "Place that the front of the rectangle faces.");
  fields.number("width", width, {0.001, 1e4}, "m", "Length of its horizontal sides.");
  fields.number("height", height, {0.001, 1e4}, "m", "Length of the other sides.");
}

void Light::describe(Fields& fields) {
  constexpr const char* typeNames[] = {"point", "spot", "area"};
  fields.choice(
      "type", type, {typeNames[0], typeNames[1], typeNames[2]},
      "point: the same light in all directions. spot: within a cone, as \"spot\" says. area: from "
      "the front of a rectangle, as \"area\" says.");
  bool given = false, isRectangle = false;
  fields.optionalGroup("spot", given, "The cone of a light of type spot.",
                       [&](Fields& inner) { spot.describe(inner); });
  fields.optionalGroup("area", isRectangle, "The rectangle of a light of type area.",
                       [&](Fields& inner) { area.describe(inner); });
  const char* const own = typeNames[static_cast<std::size_t>(type)];
  if (given && type != Type::spot)
    fields.error(
        "spot",
        fmt::format("\"spot\" is for lights of \"type\": \"spot\", and this one is of type \"{}\"", own));
  if (isRectangle && type != Type::area)
    fields.error(
        "area",
        fmt::format("\"area\" is for lights of \"type\": \"area\", and this one is of type \"{}\"", own));
  if (type == Type::area && fields.given("glow"))
    fields.error("glow", "a light of type \"area\" is not seen by the camera; leave out \"glow\"");
  fields.vector("position", position, anyNumber, "m", "Place of the light.");
  fields.optionalGroup(
      "follow", follow,
      "Place on a path that an object has found; the light is dark until there is a path.");
  if (follow && fields.given("position"))
    fields.error("position", "\"follow\" sets the place of the light; leave out \"position\"");
  if (type == Type::spot && !follow && !position.moves() && !spot.target.moves() &&
      position.at(0) == spot.target.at(0))
    fields.error(
        given ? "spot" : "position",
        "the light is at the place at which its \"spot\" points, so it has no direction; move \"target\"");
  if (type == Type::area && !follow && !position.moves() && !area.target.moves() &&
      position.at(0) == area.target.at(0))
    fields.error(
        isRectangle ? "area" : "position",
        "the light is at the place that its \"area\" faces, so it has no direction; move \"target\"");
  fields.color("color", color, notNegative, "Colour of its light, linear RGB.");
  describeTemperature(fields, temperature);
  fields.choice(
      "unit", unit, {"cd", "lm", "W"},
      "Unit of the intensity. cd: luminous intensity, for a rectangle in front of it; 1 cd gives 1 lx at 1 "
      "m. lm: luminous flux, all that the light sends out. W: watts of light (not of electricity), 179 lm "
      "each.");
  fields.number("intensity", intensity, notNegative, "",
                "Brightness in its \"unit\", for the colour 1; the sun's intensity is in lx.");
  fields.number("radius", radius, {0.001, 1000}, "m",
                "Radius of the ball that shines. It widens highlights, and objects within it cast no "
                "shadow; for a rectangle only the latter.");
  fields.number("range", range, {0, 1e6}, "m",
                "Distance at which its light ends; it fades by (1 - (d / range)^4)^2. Lights without "
                "shadows are computed only within their range. 0: it reaches everywhere.");
  fields.number("glow", glow, notNegative, "",
                "Factor on the shining ball as the camera sees it; 0 hides it.");
  fields.optionalGroup("flicker", flicker, "Flicker as of a flame, random by name, time and seed.");
  fields.boolean("shadow", shadow, "Casts shadows.");
  fields.integer("shadowSize", shadowSize, {16, 4096}, "texels",
                 "Side of each of the six maps of its shadow.");
  fields.number("shadowSoftness", shadowSoftness, {0, 16}, "texels", "Radius of the shadow's soft edge.");
  fields.idleUnless(shadow, "shadow", {"shadowSize", "shadowSoftness"}, "a light with \"shadow\"");
  fields.idleUnless(shadow || type != Type::area, "shadow", {"radius"},
                    "lights of other types, and for what shadows an \"area\" casts");
}

}  // namespace simreel::scene
