#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

/// Most vertices, and most triangles, of a mesh as a file has it; of a flat one's triangles each has three
/// vertices of its own.
constexpr std::size_t maxMeshItems = 8'000'000;
/// Most levels of nodes in one another.
constexpr int maxNodeDepth = 256;

/// Throws UserError(inputOutput): the mesh `file`, then `why`.
[[noreturn]] void refuseMesh(const std::filesystem::path& file, const std::string& why);

/// Linear light of what pictures and scanners write, IEC 61966-2-1.
[[nodiscard]] glm::vec3 linearColor(const glm::vec3& encoded);

/// Where a file lies that a mesh names, from the mesh's folder: with slashes for backslashes, none before
/// blanks, where there is none by the name as it is.
[[nodiscard]] std::filesystem::path besidePath(const std::filesystem::path& mesh, std::string_view name);

/// Whether a file named by a mesh lies in the mesh's folder or below, links followed.
[[nodiscard]] bool liesBeside(const std::filesystem::path& mesh, const std::filesystem::path& named);

/// While it lives, materials of this mesh that are read on this thread may name pictures in all folders
/// that the scenes may read which name the mesh.
class ReadableFolders {
 public:
  explicit ReadableFolders(const std::filesystem::path& mesh);
  ~ReadableFolders();
  ReadableFolders(const ReadableFolders&) = delete;
  ReadableFolders& operator=(const ReadableFolders&) = delete;
  ReadableFolders(ReadableFolders&&) = delete;
  ReadableFolders& operator=(ReadableFolders&&) = delete;
};

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
  /// Where normals are computed, the last vertex has that of an earlier one, by its number in the mesh:
  /// from the triangles around both.
  void shareNormal(std::size_t with) { sharing_.back() = static_cast<unsigned>(with); }
  /// So far.
  [[nodiscard]] std::size_t vertexCount() const { return mesh_.positions.size(); }
  /// Corners by number within the part.
  void triangle(const std::array<unsigned, 3>& corners);
  [[nodiscard]] Mesh finish();

 private:
  void fillNormals();

  const std::filesystem::path& file_;
  Mesh mesh_;
  std::vector<unsigned> sharing_;  ///< of each vertex: whose triangles make its normal, too
  glm::mat4 transform_{1};
  glm::mat3 turn_{1};  ///< of normals
  bool mirrored_ = false;
  bool hasUvs_ = false;
  int material_ = -1;
  std::size_t first_ = 0;  ///< vertex of the part
  std::size_t count_ = 0;  ///< vertices of the part
};

}  // namespace simreel::sim
