#include "base/error.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/moments.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Returns the number of subdivisions per edge for which a geodesic sphere has at least `vertices`
/// vertices.
int geodesicParts(double vertices) {
  return static_cast<int>(std::ceil(std::sqrt(std::max(vertices - 2, 10.0) / 10)));
}

}  // namespace

void ReactionMesh::describe(scene::Fields& f) {
  f.choice("shape", shape, {"file", "plane", "sphere", "torus"}, "Read from \"file\", or generated.");
  f.asset("file", file, "OBJ, PLY, STL, glTF or GLB, in m; open or closed.");
  f.vector("size", size, {0, 1e4}, "m", "Width and depth of a plane (x and z).");
  f.number("radius", radius, {1e-4, 1e4}, "m",
           "Radius of a sphere; of a torus, the distance to the middle of its tube.");
  f.number("tube", tube, {1e-4, 1e4}, "m", "Radius of a torus' tube.");
  f.pair("resolution", resolution, {4, 4096}, "vertices",
         "Vertices of a generated mesh along u and v; a sphere has as many or more, evenly spread.");
  f.integer(
      "refine", refine, {0, 6}, "",
      "Times that each face is divided into four, which makes the mesh rounder (Loop's subdivision).");
  f.optionalValue("maps", maps, Maps::texture, [&](Maps& way) {
    f.choice("maps", way, {"texture", "front", "top"},
             "Placement of images and other objects' fields on the mesh: by texture coordinates (on a "
             "sphere longitude and latitude), or over its box as seen from the front or from above.");
  });
  f.leftOut("maps", "\"texture\" where there are such coordinates, else \"front\"");
  f.vector("position", position, scene::anyNumber, "m", "Place of the mesh's origin.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on the mesh's coordinates.");
  if (shape == Shape::file && file.empty())
    f.error("shape", "the shape \"file\" needs \"file\": the mesh to read");
  if (shape != Shape::file && f.given("file"))
    f.error("file", "\"file\" needs \"shape\": \"file\"; correct \"shape\" or leave it out");
  f.idleUnless(shape == Shape::plane, "shape", {"size"}, "a \"plane\"");
  f.idleUnless(shape == Shape::sphere || shape == Shape::torus, "shape", {"radius"},
               "a \"sphere\" or a \"torus\"");
  f.idleUnless(shape == Shape::torus, "shape", {"tube"}, "a \"torus\"");
  f.idleUnless(shape != Shape::file, "shape", {"resolution"}, "what is generated");
  if (shape == Shape::torus && tube >= radius)
    f.error("tube", fmt::format("a tube of {} m closes the hole of a torus of {} m", tube, radius));
}

// A sphere is generated as a geodesic mesh. A longitude-latitude mesh would have small cells at the poles,
// which allow only short stable steps.
Mesh ReactionMesh::make() const {
  constexpr std::int64_t maxFaces = 8'000'000;
  const auto check = [&](std::int64_t faces) {
    if (faces > maxFaces)
      fail(ExitCode::usage,
           "the mesh {} would have {} faces; at most {} are allowed: give it less \"refine\"{}",
           shape == Shape::file ? file.string() : "generated", faces, maxFaces,
           shape == Shape::file ? "" : " or \"resolution\"");
  };
  if (shape == Shape::sphere) {
    const int parts = geodesicParts(double(resolution.x) * resolution.y) << refine;
    check(std::int64_t{20} * parts * parts);
    return geodesicMesh(radius, parts);
  }
  Mesh made = shape == Shape::plane   ? planeMesh(size, resolution)
              : shape == Shape::torus ? torusMesh(radius, tube, resolution)
                                      : loadMesh(file, MeshNormals::shared);
  if (refine > 0) check(static_cast<std::int64_t>(made.indices.size() / 3) << (2 * refine));
  for (int i = 0; i < refine; ++i) made = refined(made);
  return made;
}

bool ReactionMesh::isMadeAs(const ReactionMesh& other) const {
  if (shape != other.shape || refine != other.refine) return false;
  switch (shape) {
    case Shape::file:
      return file == other.file;
    case Shape::plane:
      return size == other.size && resolution == other.resolution;
    case Shape::sphere:
      return radius == other.radius && resolution == other.resolution;
    case Shape::torus:
      break;
  }
  return radius == other.radius && tube == other.tube && resolution == other.resolution;
}

glm::mat4 ReactionMesh::model(double time) const {
  glm::mat4 m = rotationMatrix(rotation.at(time));
  for (int i = 0; i < 3; ++i) m[i] *= scale.at(time);
  m[3] = glm::vec4(position.at(time), 1.0F);
  return m;
}

std::optional<scene::Box> ReactionMesh::framed() const {
  std::optional<scene::Box> box;
  try {
    const Mesh mesh = make();
    for (const double seconds : momentsOf(position, rotation, scale)) {
      const glm::mat4 placed = model(seconds);
      for (const glm::vec3& at : mesh.positions) include(box, glm::vec3(placed * glm::vec4(at, 1)));
    }
  } catch (const UserError&) {
    return std::nullopt;  // The error is reported later, when the object is created.
  }
  return box;
}

}  // namespace simreel::sim
