#include "sim/water/floats.hpp"

#include "scene/value/implied_shape.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

WaterFloat::WaterFloat() {
  material.color = {0.62F, 0.1F, 0.05F};
  material.roughness = 0.45F;
}

void WaterFloat::describe(scene::Fields& f) {
  f.choice("shape", shape, {"ball", "box", "file"}, "Shape of the body; \"file\": a closed mesh.");
  f.number("radius", radius, {1e-3, 1e3}, "m", "Radius of a ball.");
  f.vector("size", size, {1e-3, 1e3}, "m", "Size of a box.");
  f.asset("file", file, "Closed mesh (OBJ, PLY, glTF), y up, its bow towards +z.");
  scene::implyShape(f, shape, WaterFloatShape::file, "file", file, "file", "ball");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on the coordinates of files.");
  if (shape == WaterFloatShape::file && file.empty())
    f.error("shape", "the shape \"file\" needs \"file\": the mesh to read");
  const auto only = [&](const char* name, WaterFloatShape wanted, const char* what) {
    if (shape != wanted && f.given(name)) f.error(name, fmt::format("\"{}\" is only for {}", name, what));
  };
  only("radius", WaterFloatShape::ball, "a \"ball\"");
  only("size", WaterFloatShape::box, "a \"box\"");
  f.asset("drawn", drawn, "Mesh that is drawn in its place; it may be open: a leaf, a bowl.");
  if (shape != WaterFloatShape::file && drawn.empty() && f.given("scale"))
    f.error("scale", "\"scale\" is only for files; give \"drawn\", or the shape \"file\"");
  f.number("density", density, {1, 1e5}, "kg/m^3", "Density of the body; water has 1000.");
  f.optionalNumber("mass", mass, {1e-6, 1e12}, "kg", "Mass of the body, instead of \"density\".");
  f.leftOut("mass", "density * volume");
  if (mass && f.given("density"))
    f.error("density", "\"mass\" already determines the density; leave out \"density\"");
  f.vector("ballast", ballast, {-1e3, 1e3}, "m",
           "Offset from the middle of its volume to its centre of mass; if that lies low, the body does "
           "not capsize.");
  f.vector("position", position, scene::anyNumber, "m",
           "Place of its origin at the start, relative to the middle of the grid; y is the height above "
           "level 0.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees",
           "Rotation at the start, about x, then y, then z.");
  f.vector("velocity", velocity, {-1e3, 1e3}, "m/s", "Velocity at the start.");
  f.vector("spin", spin, {-1e5, 1e5}, "degrees/s", "Angular velocity at the start, about x, y and z.");
  f.number("drag", drag, scene::notNegative, "1/s",
           "Rate at which it loses its speed through the water, if it is as dense as water and wholly "
           "under it.");
  f.number("resistance", resistance, {0, 100}, "",
           "Drag coefficient: force over density * speed^2 * area / 2; 0.5 a ball, 1 a box.");
  f.number("keel", keel, {1, 1000}, "", "Factor on both drags sideways, along its x.");
  f.number("air", air, scene::notNegative, "1/s", "Rate at which it loses its speed in the air.");
  f.number("friction", friction, {0, 10}, "",
           "Coulomb's coefficient on the ground, and of two floats that touch the mean of theirs.");
  f.optionalNumber(
      "apart", apart, {0, 1e4}, "m",
      "Radius of a sphere around its middle of mass that other floats touch instead of its shape.");
  f.leftOut("apart", "they touch its shape");
  f.number("thrust", thrust, {-1e9, 1e9}, "N",
           "Thrust of its engine, along its z, while it is in the water.");
  f.number("steering", steering, {-1e9, 1e9}, "N m", "Torque about its y, while it is in the water.");
  f.optionalGroup("tow", tow, "A line that pulls it along.", [](scene::Fields& t, FloatTow& of) {
    t.vector("position", of.position, scene::anyNumber, "m",
             "Where to, from the grid's middle; y is unused: it floats there.");
    t.boolean("turns", of.turns, "Turns its z along the way.");
    t.number("pull", of.pull, {1e-2, 50}, "1/s",
             "Rate at which it follows: the tow is a critically damped spring.");
  });
  f.color("color", material.color, scene::fraction,
          "Colour of the body, linear RGB. If neither this nor a parameter below is given, a file's own "
          "materials show.");
  f.asset("texture", material.texture, "Picture laid over it by its uv, multiplied with the colour.");
  f.number("roughness", material.roughness, scene::fraction, "", "0 mirrors, 1 is matt.");
  f.number("translucency", material.translucency, scene::fraction, "",
           "Fraction of the light from behind that shines through.");
  f.number("metallic", material.metallic, scene::fraction, "", "1 for metal.");
  for (const char* name : {"color", "texture", "roughness", "translucency", "metallic"})
    if (f.given(name)) materialKeys.insert(name);
}

scene::Object WaterFloat::shownAs(const std::string& name) const {
  scene::Object object;
  object.name = name;
  object.material = material;
  object.materialKeys = materialKeys;
  return object;
}

}  // namespace simreel::sim
