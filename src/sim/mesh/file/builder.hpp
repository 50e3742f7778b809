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

/// Maximum number of vertices and maximum number of triangles in a mesh file. Flat shading can triple the
/// number of vertices, because each triangle then has three vertices that no other triangle uses.
constexpr std::size_t maxMeshItems = 8'000'000;
/// Maximum nesting depth of nodes.
constexpr int maxNodeDepth = 256;

/// Throws UserError(inputOutput) with the message "the mesh FILE WHY".
[[noreturn]] void refuseMesh(const std::filesystem::path& file, const std::string& why);

/// Converts an sRGB colour (IEC 61966-2-1), as stored by images and scanners, to linear light.
[[nodiscard]] glm::vec3 linearColor(const glm::vec3& encoded);

/// Returns the path of a file that a mesh refers to, relative to the mesh's folder. If no file has the
/// literal name, replaces backslashes by slashes and removes backslashes before blanks.
[[nodiscard]] std::filesystem::path resolveInMeshFolder(const std::filesystem::path& mesh,
                                                        std::string_view name);

/// Returns true if a file that a mesh refers to is in the mesh's folder or below it, after resolving links.
[[nodiscard]] bool liesBeside(const std::filesystem::path& mesh, const std::filesystem::path& named);

/// Scope guard for reading the materials of a mesh. While it exists, this thread may read images from all
/// folders that the scenes referring to the mesh may read.
class ReadableFolders {
 public:
  explicit ReadableFolders(const std::filesystem::path& mesh);
  ~ReadableFolders();
  ReadableFolders(const ReadableFolders&) = delete;
  ReadableFolders& operator=(const ReadableFolders&) = delete;
  ReadableFolders(ReadableFolders&&) = delete;
  ReadableFolders& operator=(ReadableFolders&&) = delete;
};

/// Returns the reason why a file referred to by a mesh's materials is not read (missing or not permitted);
/// empty if the file can be read.
[[nodiscard]] std::string whyUnread(const std::filesystem::path& mesh, const std::filesystem::path& named);

/// Assembles a mesh from parts, each with its own transform. Throws UserError for the errors of loadMesh()
/// that do not depend on the format.
class MeshBuilder {
 public:
  explicit MeshBuilder(const std::filesystem::path& file) : file_(file) {}

  /// Starts a part with the given numbers of vertices and triangles. `material` is a material index, or -1
  /// for none.
  void begin(std::size_t vertices, std::size_t triangles, const glm::mat4& transform, bool hasUvs,
             int material = -1);
  /// Adds the next vertex. A zero normal is replaced later by a normal computed from the surrounding
  /// triangles.
  void vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
  /// Adds the next vertex with a colour (linear RGB); vertices without a colour are white.
  void vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv,
              const glm::vec3& color);
  /// Makes the last vertex use the same computed normal as the earlier vertex `with` (index in the mesh):
  /// the triangles around both vertices contribute to the normal.
  void shareNormal(std::size_t with) { sharing_.back() = static_cast<unsigned>(with); }
  /// Returns the number of vertices added so far.
  [[nodiscard]] std::size_t vertexCount() const { return mesh_.positions.size(); }
  /// Adds a triangle; corners are vertex indices within the part.
  void triangle(const std::array<unsigned, 3>& corners);
  [[nodiscard]] Mesh finish();

 private:
  void fillNormals();

  const std::filesystem::path& file_;
  Mesh mesh_;
  std::vector<unsigned> sharing_;  ///< for each vertex: index of the vertex whose normal sum it uses
  glm::mat4 transform_{1};
  glm::mat3 turn_{1};  ///< matrix that transforms normals
  bool mirrored_ = false;
  bool hasUvs_ = false;
  int material_ = -1;
  std::size_t first_ = 0;  ///< index of the part's first vertex
  std::size_t count_ = 0;  ///< number of vertices in the part
};

}  // namespace simreel::sim
