#include "base/error.hpp"
#include "sim/core/collider.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/parameters.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace simreel::sim {

void ReactionMesh::describe(scene::Fields& f) {
  f.choice("shape", shape, {"file", "plane", "sphere", "torus"}, "Read from \"file\", or generated.");
  f.asset("file", file, "OBJ, PLY, glTF or GLB, in m; open or closed.");
  f.vector("size", size, {0, 1e4}, "m", "Width and depth of a plane (x and z).");
  f.number("radius", radius, {1e-4, 1e4}, "m", "Of a sphere; of a torus to the middle of its tube.");
  f.number("tube", tube, {1e-4, 1e4}, "m", "Radius of a torus' tube.");
  f.pair("resolution", resolution, {4, 4096}, "vertices", "Of what is generated, along u and v.");
  f.integer("refine", refine, {0, 6}, "",
            "How often each face becomes four, all of it rounder (Loop's subdivision).");
  f.vector("position", position, scene::anyNumber, "m", "Where the mesh's origin is.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on the mesh's coordinates.");
  if (shape == Shape::file && file.empty())
    f.error("shape", "the shape \"file\" needs \"file\": the mesh to read");
  if (shape != Shape::file && f.given("file"))
    f.error("file", "a file is read only with \"shape\": \"file\"");
  if (shape == Shape::torus && tube >= radius)
    f.error("tube", fmt::format("a tube of {} m closes the hole of a torus of {} m", tube, radius));
}

Mesh ReactionMesh::make() const {
  constexpr std::int64_t maxFaces = 8'000'000;
  Mesh made = shape == Shape::plane    ? planeMesh(size, resolution)
              : shape == Shape::sphere ? sphereMesh(radius, resolution)
              : shape == Shape::torus  ? torusMesh(radius, tube, resolution)
                                       : loadMesh(file);
  for (int i = 0; i < refine; ++i) {
    if (const auto faces = static_cast<std::int64_t>(made.indices.size() / 3); 4 * faces > maxFaces)
      fail(ExitCode::usage, "the mesh {} has {} faces after {} times \"refine\"; at most {} are allowed",
           shape == Shape::file ? file.string() : "generated", faces, i, maxFaces);
    made = refined(made);
  }
  return made;
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
    for (const auto& key : position.keys()) {
      const glm::mat4 placed = model(key.time);
      for (const glm::vec3& at : mesh.positions) include(box, glm::vec3(placed * glm::vec4(at, 1)));
    }
  } catch (const UserError&) {
    return std::nullopt;  // whoever makes it says why
  }
  return box;
}

}  // namespace simreel::sim
