#pragma once
#include "sim/core/simulation.hpp"
#include "sim/world/world.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Colours and materials of a mesh that an object exports (Simulation::mesh).
struct MeshLooks {
  /// Materials of the parts, valid until the object's next step; empty: the object shows no surface.
  std::vector<const scene::Material*> materials;
  std::vector<unsigned> partOf;   ///< index into `materials` of each triangle; empty: all are of part 0
  std::vector<glm::vec3> colors;  ///< linear RGB of each vertex; empty: none
  bool ownColors = false;         ///< true: `colors` replace the material's colour; false: factors on it
  bool doubleSided = false;       ///< true: the object shows the back faces of its surfaces
};

/// Returns the mesh that an object exports (Simulation::mesh), or else the triangles that it draws now, as
/// of a sphere or a plane; nothing if there are none. Waits for the GPU. Call after World::grow().
[[nodiscard]] std::optional<MeshTable> shownMesh(const World& world, std::size_t object);
/// Returns true if shownMesh() has a mesh.
[[nodiscard]] bool showsMesh(const World& world, std::size_t object);

/// Returns the looks of an object's mesh, from the surfaces that it draws: a triangle has the material of
/// the surface that has the same triangle. `mesh`: its present shownMesh(). Waits for the GPU. Call after
/// World::grow().
[[nodiscard]] MeshLooks looksOfMesh(const World& world, std::size_t object, const MeshTable& mesh);

/// Copies of a small mesh, as drawn now.
struct ShownCopies {
  MeshTable shape;                ///< the mesh of a copy of scale 1
  std::vector<glm::vec3> places;  ///< metres
  std::vector<glm::quat> turns;   ///< empty: none is turned
  std::vector<float> scales;      ///< factors on the shape's coordinates
  std::vector<glm::vec3> colors;  ///< linear RGB; empty: all have the material's colour
  const scene::Material* material = nullptr;
  float glow = 0;  ///< brightness of copies that emit light of their colour; 0: they are lit
};

/// Returns true if the object draws spheres, sprites or copies of a mesh and has no mesh() itself.
[[nodiscard]] bool showsCopies(const World& world, std::size_t object);

/// Returns what showsCopies() is about; empty if it is false. Sprites become spheres. Waits for the GPU.
[[nodiscard]] std::vector<ShownCopies> shownCopies(const World& world, std::size_t object);

}  // namespace simreel::sim
