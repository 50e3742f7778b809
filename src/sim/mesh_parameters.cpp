#include "sim/mesh_parameters.hpp"

#include "sim/collider.hpp"
#include "sim/mesh_shapes.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::int64_t mostVertices = 8'000'000;  // as of files

/// Vertices that a shape needs to be one.
glm::ivec2 leastResolution(MeshShape shape) {
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
  f.choice("shape", shape, {"plane", "sphere", "torus", "file"}, "Generated, or read from \"file\".");
  f.asset("file", file, "OBJ, PLY, glTF or GLB, in m, for the shape \"file\".");
  f.vector("size", size, {0, 1e4}, "m", "Width and depth of a plane (x and z).");
  f.number("radius", radius, {1e-4, 1e4}, "m", "Of a sphere; of a torus to the middle of its tube.");
  f.number("tube", tube, {1e-4, 1e4}, "m", "Radius of a torus' tube.");
  f.pair(
      "resolution", resolution, {2, 16384}, "vertices",
      "Along u and v: x and z of a plane; around and from pole to pole of a sphere; along and around the "
      "tube of a torus.");
  f.vector("position", position, scene::anyNumber, "m", "Where the mesh's origin is.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on the mesh's coordinates.");
  f.choice("sides", sides, {"auto", "one", "both"},
           "Which sides of the triangles are drawn; \"auto\": both of a plane, else the front.");
  f.boolean("visible", visible, "Whether it is drawn.");
  if (shape == MeshShape::file && file.empty())
    f.error("shape", "the shape \"file\" needs \"file\": the mesh to read");
  if (shape != MeshShape::file && f.given("file"))
    f.error("file", "a file is read only with \"shape\": \"file\"");
  const glm::ivec2 least = leastResolution(shape);
  if (resolution.x < least.x || resolution.y < least.y)
    f.error("resolution", fmt::format("this shape needs at least [{}, {}] vertices", least.x, least.y));
  if (std::int64_t{resolution.x} * resolution.y > mostVertices)
    f.error("resolution",
            fmt::format("{}x{} are more than {} vertices", resolution.x, resolution.y, mostVertices));
  if (shape == MeshShape::torus && tube >= radius)
    f.error("tube", fmt::format("a tube of {} m closes the hole of a torus of {} m", tube, radius));
}

bool MeshParameters::doubleSided() const {
  return sides == MeshSides::both || (sides == MeshSides::fitting && shape == MeshShape::plane);
}

glm::mat4 MeshParameters::model(double time) const {
  glm::mat4 m = rotationMatrix(rotation.at(time));
  const float factor = scale.at(time);
  for (int i = 0; i < 3; ++i) m[i] *= factor;
  m[3] = glm::vec4(position.at(time), 1.0F);
  return m;
}

Mesh MeshParameters::make() const {
  switch (shape) {
    case MeshShape::plane:
      return planeMesh(size, resolution);
    case MeshShape::sphere:
      return sphereMesh(radius, resolution);
    case MeshShape::torus:
      return torusMesh(radius, tube, resolution);
    case MeshShape::file:
      break;
  }
  return loadMesh(file);
}

}  // namespace simreel::sim
