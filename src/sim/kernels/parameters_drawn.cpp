// Parameters of what a scene draws and measures of the memory of kernels.
#include "scene/value/implied_shape.hpp"
#include "sim/grid/color_map.hpp"
#include "sim/kernels/parameters.hpp"
#include "sim/ports/color_scale.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::sim {

namespace {

void describe(scene::Fields& f, KernelSurface& surface) {
  f.text("of", surface.of, "Buffer whose elements are the vertices.");
  f.text("position", surface.position, "Member that holds a vertex's place (m).");
  f.text("normal", surface.normal, "Member that holds its normal.");
  f.leftOut("normal", "from the neighbours of a grid, or from the triangles");
  f.pair("grid", surface.grid, {0, 16384}, "vertices",
         "Width and height of a grid of vertices, x fastest.");
  f.leftOut("grid", "the buffer's size");
  f.text("indices", surface.indices, "Buffer of uints, three a triangle.");
  f.asset("mesh", surface.mesh, "OBJ, PLY or glTF file whose triangles join the vertices.");
  f.boolean("doubleSided", surface.doubleSided, "Shows both sides.");
}

void describeMap(scene::Fields& f, std::string& chosen) {
  const auto& names = colorMapNames();
  int map = static_cast<int>(std::find(names.begin(), names.end(), chosen) - names.begin());
  std::vector<const char*> words;
  words.reserve(names.size());
  for (const std::string& name : names) words.push_back(name.c_str());
  f.oneOf("colors", map, words, "Colour map.");
  chosen = names[static_cast<std::size_t>(map)];
}

void describe(scene::Fields& f, KernelPoints& points) {
  f.text("of", points.of, "Buffer whose elements are drawn.");
  f.text("position", points.position, "Member that holds an element's place (m).");
  f.text("velocity", points.velocity, "Member that holds its velocity (m/s).");
  f.text("mass", points.mass, "Member that holds its mass (kg).");
  f.text("alive", points.alive, "Member; elements in which it is not above 0 are not drawn.");
  f.leftOut("alive", "all are drawn");
  f.choice("shape", points.shape, {"sprite", "sphere", "mesh"},
           "Discs that face the camera, lit as balls or glowing; spheres; or a mesh.");
  f.asset("mesh", points.mesh, "OBJ, PLY or glTF file of shape \"mesh\".");
  scene::implyShape(f, points.shape, Instances::Shape::mesh, "mesh", points.mesh, "mesh", "sprite");
  f.text(
      "rotation", points.rotation,
      "Member that turns a mesh: a quaternion (four numbers: x, y, z, w), or the direction of the mesh's "
      "z axis (three).");
  f.leftOut("rotation", "no turn, unless \"alongVelocity\"");
  f.idleUnless(points.shape == Instances::Shape::mesh, "shape", {"rotation", "alongVelocity"},
               "shape \"mesh\"");
  f.boolean("alongVelocity", points.alongVelocity, "Turns a mesh's z axis along the velocity.");
  f.number("size", points.size, {1e-5, 1e5}, "m", "Diameter; for a mesh, a factor on its coordinates.");
  f.number("massExponent", points.massExponent, {0, 2}, "", "Size grows with mass to this power.");
  f.choice("colorBy", points.colorBy, {"material", "speed", "mass"},
           "The object's material, or a colour map of the speed or mass.");
  if (points.colorBy != Instances::ColorBy::material && f.version() > 1 && !f.given("colorFrom") &&
      !f.given("colorTo"))
    points.autoColors = {true, true};
  describeEnd(f, "colorFrom", points.colorRange.x, points.autoColors.low, "",
              "Speed (m/s) or mass (kg) at the start of the colour map; \"auto\": the lowest of the whole "
              "run.");
  describeEnd(f, "colorTo", points.colorRange.y, points.autoColors.high, "",
              "Speed (m/s) or mass (kg) at the end of the colour map; \"auto\": the highest of the whole "
              "run.");
  f.leftOut("colorFrom", "0, or \"auto\" in version 2");
  f.leftOut("colorTo", "1, or \"auto\" in version 2");
  describeMap(f, points.map);
  f.boolean("additive", points.additive, "Light that adds up and casts no shadow, for sparks and stars.");
  f.number("brightness", points.brightness, {0, 1e5}, "", "Factor on the colours of additive elements.");
  f.idleUnless(points.additive, "additive", {"brightness"}, "points that are \"additive\"");
  if (points.colorRange.x == points.colorRange.y && !points.autoColors.any())
    f.error("colorTo", "colorFrom and colorTo must differ");
}

void describe(scene::Fields& f, KernelTerrain& terrain) {
  f.text("of", terrain.of, "2D texture, or buffer of a grid, whose elements are the heights.");
  f.text("height", terrain.height, "Channel (r, g, b, a) or member that holds the height.");
  f.leftOut("height", "the first number");
  f.vector("position", terrain.position, scene::anyNumber, "m",
           "Middle of the ground, where the height is 0.");
  f.number("width", terrain.width, {1e-3, 1e5}, "m", "Width along x; y of the texture grows along z.");
  f.number("scale", terrain.scale, scene::anyNumber, "m", "Height of the value 1.");
  if (f.version() > 1 && !f.given("finer")) terrain.finer = 0;
  f.integer(
      "finer", terrain.finer, {0, 16}, "",
      "Steps of the drawn grid from one height to the next, on a smooth surface through the heights; 1: "
      "flat triangles join the heights; 0: as many as give about 256 along the longer side.");
  f.leftOut("finer", "1, or 0 in version 2");
  f.boolean("collides", terrain.collides, "Cloth and particles fall onto it.");
  f.number("grip", terrain.grip, {0, 1e6}, "1/s",
           "Rate at which sliding objects lose speed, if it collides.");
  f.idleUnless(terrain.collides, "collides", {"grip"}, "\"collides\": true");
}

void describe(scene::Fields& f, KernelVolume& volume) {
  f.text("of", volume.of, "3D texture, or buffer with a size of three numbers.");
  f.text("show", volume.show, "Channel (r, g, b, a) or member that has the level.");
  f.leftOut("show", "the first number");
  f.choice(
      "draw", volume.draw, {"isosurface", "cubes"},
      "isosurface: a smooth surface where the number passes \"level\"; cubes: a cube for every cell at "
      "that level or above.");
  f.number("level", volume.level, scene::anyNumber, "",
           "Number at the surface; inside it is at least this.");
  f.text("color", volume.color, "Channel or member whose numbers \"colors\" maps.");
  f.leftOut("color", "nothing: the surface has its material's colour");
  f.number("colorFrom", volume.colorRange.x, scene::anyNumber, "",
           "Number at the start of the colour map.");
  f.number("colorTo", volume.colorRange.y, scene::anyNumber, "", "Number at the end of the colour map.");
  describeMap(f, volume.map);
  f.idleUnless(!volume.color.empty(), "color", {"colors", "colorFrom", "colorTo"},
               "a volume with \"color\"");
  f.vector("position", volume.position, scene::anyNumber, "m", "Middle of the volume.");
  f.number("width", volume.width, {1e-3, 1e4}, "m", "Width along x; its cells are cubes.");
  f.boolean("closed", volume.closed, "Closes the surface where it reaches the border; else it ends there.");
  if (volume.colorRange.x == volume.colorRange.y) f.error("colorTo", "colorFrom and colorTo must differ");
}

void describe(scene::Fields& f, KernelWind& wind) {
  f.text("of", wind.of, "2D texture, or buffer of a grid, whose elements are velocities.");
  f.text("velocity", wind.velocity,
         "Member whose first two numbers are the velocity towards growing x and y.");
  f.leftOut("velocity", "r and g of a texture, or the element itself");
  f.number("scale", wind.scale, scene::anyNumber, "m/s", "Speed of the velocity 1.");
  f.number("speed", wind.speed, {1e-3, 1e6}, "m/s",
           "Greatest speed that is expected: a wildfire's \"strength\" of wind.");
  f.group("plane", "Rectangle in the world where the velocities are the wind of other objects.",
          [&](scene::Fields& p) { wind.plane.describe(p); });
}

}  // namespace

void KernelsParameters::describeDrawn(scene::Fields& f) {
  f.optionalGroup("surface", surface, "Draws a buffer as a surface.",
                  [](scene::Fields& g, KernelSurface& group) { sim::describe(g, group); });
  f.optionalGroup("points", points, "Draws the elements of a buffer.",
                  [](scene::Fields& g, KernelPoints& group) { sim::describe(g, group); });
  f.optionalGroup("field", field, "Lays a texture or buffer over the picture.",
                  [](scene::Fields& g, KernelField& group) {
                    g.text("of", group.of, "Texture, or buffer.");
                    g.text("show", group.show, "Channel (r, g, b, a) or member that is shown.");
                    g.leftOut("show", "the colour, if there are three or four numbers; else the number");
                    g.group("display", "Placement over the picture.",
                            [&](scene::Fields& d) { group.display.describe(d); });
                  });
  f.optionalGroup("terrain", terrain, "Draws heights as ground, onto which others may fall.",
                  [](scene::Fields& g, KernelTerrain& group) { sim::describe(g, group); });
  f.optionalGroup("volume", volume, "Draws a volume as the surface where its numbers reach a level.",
                  [](scene::Fields& g, KernelVolume& group) { sim::describe(g, group); });
  f.optionalGroup("wind", wind, "Makes velocities the wind of cloth, particles and wildfires.",
                  [](scene::Fields& g, KernelWind& group) { sim::describe(g, group); });
  f.named(
      "measures", measured, "Numbers of the state, for checks and charts.", "measure",
      [](scene::Fields& m, KernelMeasure& measure) {
        m.text("of", measure.of, "Buffer or texture.");
        m.text("member", measure.member, "Member or channel; of several components their length.");
        m.choice("what", measure.what, {"mean", "sum", "min", "max"}, "Statistic over all elements.");
      },
      32);
}

}  // namespace simreel::sim
