#include "sim/body/parameters.hpp"

#include "sim/mesh/parameters.hpp"

namespace simreel::sim {

void BodyParameters::describe(scene::Fields& f) {
  f.asset("file", file, "glTF or GLB with a skin: a mesh whose vertices follow bones.");
  f.text("animation", animation,
         "Name of the file's motion that it goes through; without one it stands as the file has it.");
  f.number("speed", speed, {-100, 100}, "", "Of the motion; 2 is twice as fast, -1 backwards.");
  f.number("start", start, {-1e6, 1e6}, "s", "How far into the motion it is at time 0.");
  f.boolean("loop", loop,
            "Whether the motion begins anew when it has ended: one whose last pose is its first repeats "
            "without a jump. Otherwise the last pose stays.");
  f.list("bones", bones, "Bones that the scene moves, on top of the motion.",
         [](scene::Fields& b, KeyedBone& keyed) {
           b.text("bone", keyed.bone, "Its name in the file.");
           b.vector("rotate", keyed.rotate, scene::anyNumber, "degrees",
                    "About the bone's own x, then y, then z.");
           b.vector("move", keyed.move, scene::anyNumber, "m", "In the axes of its parent.");
           if (keyed.bone.empty()) b.error("bone", "say which \"bone\" is moved");
         });
  f.vector("position", position, scene::anyNumber, "m", "Where the file's origin is.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-3, 1e3}, "", "Factor on the file's coordinates.");
  f.boolean("doubleSided", doubleSided, "Whether both sides of its triangles are drawn.");
  f.boolean("visible", visible, "Whether it is drawn.");
  f.booleanOr(
      "collides", collides, byFaces, "faces",
      "true: cloth and particles touch capsules around its bones, from each to its child, as thick as the "
      "skin "
      "there (simreel render -v says where), of the 24 bones with the most skin; \"faces\": cloth with "
      "\"contact\" keeps off the triangles of its skin.");
  f.number("grip", grip, {0, 1e6}, "1/s",
           "Rate at which what slides over it loses speed; 25.3 keeps 0.9 at 240 Hz.");
  f.optionalNumber(
      "friction", friction, {0, 100}, "",
      "Coulomb's coefficient, instead of grip: what lies there holds on slopes up to its arc tangent. Of "
      "faces: with a cloth's the mean of both; left out the cloth's.");
  if (file.empty()) f.error("file", "a body needs \"file\": the glTF to read");
  for (const char* name : {"speed", "start", "loop"})
    if (animation.empty() && f.given(name))
      f.error(name, "give \"animation\", the name of the motion that it is of");
  if (friction && f.given("grip")) f.error("friction", "give \"grip\" or \"friction\", not both");
  for (const char* name : {"grip", "friction"})
    if (!collides && !byFaces && f.given(name)) f.error(name, "this is for a body with \"collides\": true");
  if (byFaces && f.given("grip")) f.error("grip", "faces have \"friction\" instead");
}

std::span<const scene::Quantity> BodyParameters::quantities() const {
  static const MeshParameters surface;
  return surface.quantities();
}

const std::shared_ptr<const Figure>& BodyParameters::figure() const {
  if (!figure_) figure_ = std::make_shared<const Figure>(loadFigure(file));
  return figure_;
}

}  // namespace simreel::sim
