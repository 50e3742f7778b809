#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "sim/core/simulation.hpp"
#include "sim/world/shown_mesh.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// Object of a scene in a glTF file.
struct GlbObject {
  std::string name;
  sim::MeshTable mesh = {};  ///< in world space; without triangles if the object shows only copies
  sim::MeshLooks looks = {};
  std::vector<sim::ShownCopies> copies = {};
};

/// Encodes objects as binary glTF 2.0 (Khronos, "glTF 2.0 specification", 4.4 and 5). Each object is a root
/// node of its name with one mesh: a primitive and a material for each part, positions, normals, texture
/// coordinates and linear colours if it has them, and 32-bit indices. Units are metres, y is up, v = 0 is
/// the top row of a texture. Drops vertices that no triangle uses. Each of an object's copies is a mesh
/// with the places of its copies (extension EXT_mesh_gpu_instancing; _COLOR_0 holds their linear colours),
/// in the object's node if that has no mesh yet, otherwise in a child node. `comments` go to asset.extras.
[[nodiscard]] std::vector<std::byte> encodeGlb(std::span<const GlbObject> objects,
                                               std::span<const std::string> comments,
                                               const SkinPicturesOf& skins = {});

}  // namespace simreel::frame
