#pragma once
#include "sim/mesh/file.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

/// Most vertices, and most triangles, of a mesh.
constexpr std::size_t maxMeshItems = 8'000'000;
/// Most levels of nodes in one another.
constexpr int maxNodeDepth = 256;

/// Throws UserError(inputOutput): the mesh `file`, then `why`.
[[noreturn]] void refuseMesh(const std::filesystem::path& file, const std::string& why);

/// Whether a file named by a mesh lies in the mesh's folder or below, links followed.
[[nodiscard]] bool liesBeside(const std::filesystem::path& mesh, const std::filesystem::path& named);

/// Why a file that a mesh's materials name is not read, for it is not there or not to be read; empty where
/// it is.
[[nodiscard]] std::string whyUnread(const std::filesystem::path& mesh, const std::filesystem::path& named);

/// Puts a mesh together from parts with a transform each. Throws UserError for what loadMesh() refuses of
/// any format.
class MeshBuilder {
 public:
  explicit MeshBuilder(const std::filesystem::path& file) : file_(file) {}

  /// A part of that many vertices and triangles follows; `material`: its number, -1: none.
  void begin(std::size_t vertices, std::size_t triangles, const glm::mat4& transform, bool hasUvs,
             int material = -1);
  /// The next vertex; a normal of 0 is computed from the triangles around it.
  void vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
  /// The next one, with a colour (linear RGB); of others it is white.
  void vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv,
              const glm::vec3& color);
  /// Corners by number within the part.
  void triangle(const std::array<unsigned, 3>& corners);
  [[nodiscard]] Mesh finish();

 private:
  void fillNormals();

  const std::filesystem::path& file_;
  Mesh mesh_;
  glm::mat4 transform_{1};
  glm::mat3 turn_{1};  ///< of normals
  bool mirrored_ = false;
  bool hasUvs_ = false;
  int material_ = -1;
  std::size_t first_ = 0;  ///< vertex of the part
  std::size_t count_ = 0;  ///< vertices of the part
};

}  // namespace simreel::sim
