#include "sim/body/parameters.hpp"

#include "base/file.hpp"
#include "sim/body/skinned_surface.hpp"
#include "sim/contact/solid.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/ports/markers.hpp"

namespace simreel::sim {

void BodyParameters::describe(scene::Fields& f) {
  f.asset("file", file,
          "glTF or GLB with a skin, whose vertices follow bones, or with an animation that moves meshes.");
  f.leftOut("file", "a figure that ships with simreel, which walks; required in version 1");
  f.text("animation", animation,
         "Name of the file's motion that it plays; without one it keeps the pose of the file.");
  if (f.version() > 1 && !f.given("file")) {
    file = assetFolder() / "meshes" / "walker.gltf";
    if (!f.given("animation")) animation = "walk";
  }
  f.number("speed", speed, {-100, 100}, "", "Speed of the motion; 2 is twice as fast, -1 backwards.");
  f.number("start", start, {-1e6, 1e6}, "s", "Time in the motion at time 0 of the scene.");
  f.boolean("loop", loop,
            "Starts the motion again when it has ended; it repeats without a jump if its last pose is its "
            "first. Otherwise the last pose stays.");
  f.list("bones", bones, "Bones that the scene moves, on top of the motion.",
         [](scene::Fields& b, KeyedBone& keyed) {
           b.text("bone", keyed.bone, "Name of the bone in the file.");
           b.vector("rotate", keyed.rotate, scene::anyNumber, "degrees",
                    "About the bone's own x, then y, then z.");
           b.vector("move", keyed.move, scene::anyNumber, "m", "Movement in the axes of its parent.");
           if (keyed.bone.empty()) b.error("bone", "say which \"bone\" is moved");
         });
  f.vector("position", position, scene::anyNumber, "m", "Place of the file's origin.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-3, 1e3}, "", "Factor on the file's coordinates.");
  f.boolean("doubleSided", doubleSided, "Draws both sides of its triangles.");
  f.boolean("visible", visible, "Draws it.");
  f.booleanOr(
      "collides", collides, byFaces, "faces",
      "true: cloth and particles touch capsules around its bones, from each to its child, as thick as the "
      "skin "
      "there (simreel render -v says where), of the 24 bones with the most skin; \"faces\": cloth with "
      "\"contact\" keeps off the triangles of its skin.");
  f.number("grip", grip, {0, 1e6}, "1/s",
           "Rate at which sliding objects lose speed; 25.3 keeps 0.9 of it in 1/240 s.");
  f.optionalNumber("friction", friction, {0, 100}, "",
                   "Coulomb's coefficient, instead of grip: objects hold on slopes up to its arc tangent. "
                   "With \"faces\": the mean with the cloth's coefficient; left out: the cloth's.");
  if (file.empty()) f.error("file", "a body needs \"file\": the glTF to read");
  for (const char* name : {"speed", "start", "loop"})
    if (animation.empty() && f.given(name))
      f.error(name, "give \"animation\", the name of the motion that this applies to");
  if (friction && f.given("grip")) f.error("friction", "give \"grip\" or \"friction\", not both");
  for (const char* name : {"grip", "friction"})
    if (!collides && !byFaces && f.given(name)) f.error(name, "this is for a body with \"collides\": true");
  if (byFaces && f.given("grip")) f.error("grip", "faces have \"friction\" instead");
}

void BodyParameters::ports(Ports& ports) const {
  ports.provide<SkinnedSurface>();
  ports.provide<Touchable>(collides);
  ports.provide<ContactSolid>(byFaces).path = {"collides"};
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
