#include "sim/mesh/parameters.hpp"

#include "base/error.hpp"
#include "scene/value/implied_shape.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/moments.hpp"
#include "sim/mesh/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::int64_t maxVertices = 8'000'000;  // the same limit as for mesh files

/// Returns the minimum number of vertices along u and v for a valid shape.
glm::ivec2 minResolution(MeshShape shape) {
  switch (shape) {
    case MeshShape::sphere:
      return {4, 3};
    case MeshShape::torus:
      return {4, 4};
    default:
      return {2, 2};
  }
}

}  // namespace

void MeshParameters::describe(scene::Fields& f) {
  f.choice("shape", shape, {"plane", "sphere", "torus", "grass", "file", "box", "cylinder", "cone", "disc"},
           "Shape that is generated, or \"file\": read from a file.");
  f.asset("file", file, "OBJ, PLY, STL, glTF or GLB, in m, for the shape \"file\".");
  scene::implyShape(f, shape, MeshShape::file, "file", file, "file", "plane");
  if (f.version() > 1 && file.empty() && !f.given("shape") && (f.given("radius") || f.given("tube")))
    shape = MeshShape::torus;
  f.leftOut("shape",
            "\"plane\", or \"file\" where \"file\" is given; in version 2 \"torus\" with a radius");
  const bool flat = shape == MeshShape::plane || shape == MeshShape::grass;
  f.flatVector("size", size, {0, 1e4}, "m",
               "Width, height and depth of a box; width and depth of a plane or of a field of grass, as "
               "[x, z] or [x, 0, z].",
               flat ? scene::Flat{1, 0} : scene::Flat{});
  f.number(
      "radius", radius, {1e-4, 1e4}, "m",
      "Radius of a sphere, cylinder, cone or disc; of a torus, the distance to the middle of its tube.");
  f.number("tube", tube, {1e-4, 1e4}, "m", "Radius of a torus' tube.");
  f.number("height", height, {1e-4, 1e4}, "m", "Height of a cylinder or cone.");
  f.pair("resolution", resolution, {2, 16384}, "vertices",
         "Vertices along u and v: along x and z of a plane; around and from pole to pole of a sphere; "
         "along and around the tube of a torus.");
  f.integer("blades", blades, {1, 1'000'000}, "",
            "Blades of grass, scattered over its field by the scene's seed.");
  f.number("bladeHeight", bladeHeight, {1e-4, 1e3}, "m", "Height of the tallest blades of grass.");
  f.number("bladeWidth", bladeWidth, {1e-5, 1e2}, "m", "Width of a blade of grass at its root.");
  describePlace(f);
  if (f.version() > 1 && shape == MeshShape::plane && !f.given("shape") && !f.given("deform")) {
    deform.list.resize(1);
    deform.list.front().ripple.on = true;
    deform.list.front().ripple.wavelength = 1.2F;
    deform.list.front().ripple.amplitude = 0.12F;
    deform.list.front().ripple.decay = 0.4F;
  }
  deform.describe(f);
  f.leftOut("deform", "[]; in version 2, of a mesh without \"shape\" and \"file\", a ripple");
  describeCollision(f);
  remarkShape(f);
  if (shape == MeshShape::file && file.empty())
    f.error("shape", "the shape \"file\" needs \"file\": the mesh to read");
  const glm::ivec2 min = minResolution(shape);
  if (resolution.x < min.x || resolution.y < min.y)
    f.error("resolution", fmt::format("this shape needs at least [{}, {}] vertices", min.x, min.y));
  if (std::int64_t{resolution.x} * resolution.y > maxVertices)
    f.error("resolution",
            fmt::format("{}x{} are more than {} vertices", resolution.x, resolution.y, maxVertices));
  if (shape == MeshShape::torus && tube >= radius)
    f.error("tube", fmt::format("a tube of {} m closes the hole of a torus of {} m", tube, radius));
}

void MeshParameters::describePlace(scene::Fields& f) {
  f.vector("position", position, scene::anyNumber, "m", "Place of the mesh's origin.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on the mesh's coordinates.");
  f.choice("sides", sides, {"auto", "one", "both"},
           "Which sides of the triangles are drawn; \"auto\": both of a plane, a disc and grass, else the "
           "front.");
  f.boolean("visible", visible, "Draws it.");
}

void MeshParameters::remarkShape(scene::Fields& f) const {
  const char* const ruler = f.given("shape") ? "shape" : "file";
  const bool plane = shape == MeshShape::plane, grass = shape == MeshShape::grass;
  const bool sphere = shape == MeshShape::sphere, torus = shape == MeshShape::torus;
  const bool box = shape == MeshShape::box, disc = shape == MeshShape::disc;
  const bool upright = shape == MeshShape::cylinder || shape == MeshShape::cone;
  f.idleUnless(plane || grass || box, ruler, {"size"}, "a \"box\", a \"plane\" or \"grass\"");
  f.idleUnless(sphere || torus || disc || upright, ruler, {"radius"},
               "a \"sphere\", \"torus\", \"cylinder\", \"cone\" or \"disc\"");
  f.idleUnless(upright, ruler, {"height"}, "a \"cylinder\" or a \"cone\"");
  f.idleUnless(torus, ruler, {"tube"}, "a \"torus\"");
  f.idleUnless(plane || sphere || torus, ruler, {"resolution"}, "a \"plane\", \"sphere\" or \"torus\"");
  f.idleUnless(grass, ruler, {"blades", "bladeHeight", "bladeWidth"}, "\"grass\"");
}

void MeshParameters::describeCollision(scene::Fields& f) {
  f.booleanOr("collides", collides, byFaces, "faces",
              "true: cloth, and particles that collide, touch a closed mesh wherever it moves, or fall "
              "onto a deformed plane (one of a scene). \"faces\": cloth with \"contact\" keeps a distance "
              "from its triangles; the mesh may be open or closed, moved or deformed.");
  f.number("grip", grip, {0, 1e6}, "1/s", "Rate at which sliding objects lose speed, if it collides.");
  f.optionalNumber(
      "friction", friction, {0, 100}, "",
      "Coulomb's coefficient, instead of grip, for a closed mesh that collides: objects hold on slopes up "
      "to its arc tangent. With \"faces\": the mean with the cloth's coefficient; left out: the cloth's.");
  f.integer("distanceCells", distanceCells, {0, 1024}, "cells",
            "Cells of the distance field along the longest side of a closed mesh that collides; 0: 64, and "
            "up to 256 for thin meshes.");
  if (friction && f.given("grip")) f.error("friction", "give \"grip\" or \"friction\", not both");
  if (!collides && !byFaces && f.given("friction"))
    f.error("friction", "\"friction\" is for a mesh with \"collides\": true or \"faces\"");
  for (const char* name : {"grip", "distanceCells"})
    if (!collides && f.given(name))
      f.error(name, fmt::format("\"{}\" is for a mesh with \"collides\": true", name));
  if (byFaces && deform.technique == DeformTechnique::vertexShader && !deform.list.empty())
    f.error("technique", "\"vertex-shader\" keeps no positions to collide with; use \"compute\"");
  if (!collides) return;
  if (deform.list.empty())
    checkSolid(f);
  else
    checkHeights(f);
}

void MeshParameters::checkSolid(scene::Fields& f) const {
  if (shape == MeshShape::plane || shape == MeshShape::grass || shape == MeshShape::disc)
    f.error(
        "shape",
        "a mesh that collides must be closed, or a plane that \"deform\" moves; use a \"plane\" object");
  if (distanceCells > 0 && distanceCells < 8)
    f.error("distanceCells", "a mesh that collides needs at least 8 cells along its longest side");
  if (scale.moves())
    f.error("scale", "a mesh that collides cannot change its size; give one scale without keys");
}

void MeshParameters::checkHeights(scene::Fields& f) const {
  if (shape != MeshShape::plane)
    f.error("shape", "a deformed mesh that collides must be a \"plane\", onto whose heights others fall");
  for (const char* name : {"friction", "distanceCells"})
    if (f.given(name))
      f.error(name, fmt::format("\"{}\" is for a mesh that collides and is not deformed", name));
  if (deform.technique == DeformTechnique::vertexShader)
    f.error("technique", "\"vertex-shader\" keeps no positions to collide with; use \"compute\"");
  if (size.x < 1e-3F || size.z < 1e-3F)
    f.error("size", "a mesh that collides must be at least 0.001 m wide and deep");
  if (position.moves())
    f.error("position", "a deformed mesh that collides cannot move; give one position without keys");
  if (rotation.moves() || rotation.at(0) != glm::vec3(0))
    f.error("rotation", "a deformed mesh that collides cannot be turned; leave out \"rotation\"");
  if (scale.moves() || scale.at(0) != 1.0F)
    f.error("scale", "a deformed mesh that collides cannot be scaled; give it another \"size\"");
}

bool MeshParameters::doubleSided() const {
  return sides == MeshSides::both ||
         (sides == MeshSides::fitting &&
          (shape == MeshShape::plane || shape == MeshShape::disc || shape == MeshShape::grass));
}

glm::mat4 MeshParameters::model(double time) const {
  glm::mat4 m = rotationMatrix(rotation.at(time));
  const float factor = scale.at(time);
  for (int i = 0; i < 3; ++i) m[i] *= factor;
  m[3] = glm::vec4(position.at(time), 1.0F);
  return m;
}

double MeshParameters::jumpedBy(double time) const {
  return lastJump(time, position, rotation, scale);
}

float MeshParameters::swell() const {
  float swell = 0;
  for (const DisplacementParameters& one : deform.list) {
    if (one.ripple.on) swell += std::abs(one.ripple.amplitude);
    for (const Wave& wave : one.waves) swell += std::abs(wave.amplitude);
  }
  return swell;
}

std::vector<glm::vec3> MeshParameters::placesAtRest() const {
  std::vector<glm::vec3> places;
  try {
    const Mesh mesh = make(0);
    for (const double seconds : momentsOf(position, rotation, scale)) {
      const glm::mat4 placed = model(seconds);
      for (const glm::vec3& at : mesh.positions) places.emplace_back(placed * glm::vec4(at, 1));
    }
  } catch (const UserError&) {
    return {};  // The constructor of the simulation reports this error.
  }
  return places;
}

std::optional<scene::Box> MeshParameters::framed() const {
  if (!visible) return std::nullopt;
  std::optional<scene::Box> box;
  for (const glm::vec3& at : placesAtRest()) include(box, at);
  if (!box) return box;
  box->min.y -= swell();
  box->max.y += swell();
  box->round = (shape == MeshShape::sphere || shape == MeshShape::torus) && !position.moves();
  return box;
}

std::vector<glm::vec3> MeshParameters::outline() const {
  if (!visible || shape != MeshShape::file) return {};
  std::vector<glm::vec3> outer = scene::outermost(placesAtRest());
  const float up = swell();
  if (up == 0) return outer;
  for (std::size_t i = outer.size(); i-- > 0;) {
    outer.push_back(outer[i] + glm::vec3(0, up, 0));
    outer[i].y -= up;
  }
  return outer;
}

Mesh MeshParameters::make(int seed) const {
  switch (shape) {
    case MeshShape::plane:
      return planeMesh(size, resolution);
    case MeshShape::sphere:
      return sphereMesh(radius, resolution);
    case MeshShape::torus:
      return torusMesh(radius, tube, resolution);
    case MeshShape::grass:
      return grassMesh(size, blades, bladeHeight, bladeWidth, seed);
    case MeshShape::box:
      return boxMesh(size);
    case MeshShape::cylinder:
      return cylinderMesh(radius, radius, height);
    case MeshShape::cone:
      return cylinderMesh(0, radius, height);
    case MeshShape::disc:
      return discMesh(radius);
    case MeshShape::file:
      break;
  }
  return loadMesh(file);
}

}  // namespace simreel::sim
