// Fuzzes the readers of OBJ, PLY, STL, glTF and GLB. The first bytes determine the format.
#include "base/error.hpp"
#include "base/file.hpp"
#include "fuzz/reader.hpp"
#include "fuzz/scratch.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <cmath>

namespace simreel::fuzz {
namespace {

/// True for a text that starts with "solid", and for bytes that have a zero where the triangle count of a
/// binary STL is.
bool isStl(std::string_view bytes) {
  return bytes.starts_with("solid") || (bytes.size() > 84 && bytes[83] == '\0');
}

const char* extensionOf(std::string_view bytes) {
  return bytes.starts_with("ply")    ? ".ply"
         : bytes.starts_with("glTF") ? ".glb"
         : bytes.starts_with("{")    ? ".gltf"
         : isStl(bytes)              ? ".stl"
                                     : ".obj";
}

void readMesh(std::string_view bytes) {
  const auto file = scratchFolder() / (std::string("fuzz") + extensionOf(bytes));
  writeFileAtomically(file, bytes);
  const sim::Mesh mesh = sim::importMesh(file);
  SIMREEL_CHECK(!mesh.indices.empty() && mesh.indices.size() % 3 == 0);
  SIMREEL_CHECK_EQ(mesh.normals.size(), mesh.positions.size());
  SIMREEL_CHECK(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
  for (const unsigned i : mesh.indices) SIMREEL_CHECK(i < mesh.positions.size());
  for (const glm::vec3& p : mesh.positions)
    SIMREEL_CHECK(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e9F);
}

const Reader meshReader("mesh", readMesh);

}  // namespace
}  // namespace simreel::fuzz
