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
  /// Materials of the parts, valid until the object's next step. Empty if the object shows no surface.
  std::vector<const scene::Material*> materials;
  std::vector<unsigned> partOf;   ///< index into `materials` for each triangle; if empty, all triangles
                                  ///< have materials[0]
  std::vector<glm::vec3> colors;  ///< linear RGB colour of each vertex; empty if the vertices have no
                                  ///< colours
  bool ownColors = false;         ///< true if `colors` replace the material's colour, false if they
                                  ///< multiply it
  bool doubleSided = false;       ///< true if the object shows the back faces of its surfaces
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

/// Copies of a small mesh as they are drawn in the current frame.
struct ShownCopies {
  MeshTable shape;                ///< mesh of a copy whose scale is 1
  std::vector<glm::vec3> places;  ///< positions in metres
  std::vector<glm::quat> turns;   ///< rotations; empty if no copy is rotated
  std::vector<float> scales;      ///< factors on the shape's coordinates
  std::vector<glm::vec3> colors;  ///< linear RGB colour of each copy; if empty, all copies have the
                                  ///< material's colour
  const scene::Material* material = nullptr;
  float glow = 0;  ///< brightness of copies that emit light of their colour; 0 for copies that are lit
};

/// Returns true if the object draws spheres, sprites or copies of a mesh, and its mesh() returns nothing.
[[nodiscard]] bool showsCopies(const World& world, std::size_t object);

/// Returns the spheres, sprites and copies that the object draws, as copies of a mesh. Sprites become
/// spheres. Empty if showsCopies() returns false. Waits for the GPU.
[[nodiscard]] std::vector<ShownCopies> shownCopies(const World& world, std::size_t object);

}  // namespace simreel::sim
