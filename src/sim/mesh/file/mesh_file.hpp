#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// A picture of a mesh's materials as its file has it: PNG or JPEG.
struct MeshImage {
  std::string name;  ///< what messages call it
  std::string bytes;

  template <class Archive>
  void pack(Archive& archive) {
    archive(name);
    archive(bytes);
  }
};

/// Where pictures lie on a mesh: at u and v of them are `turn` times those of the mesh plus `shift`.
struct TexturePlace {
  glm::mat2 turn{1};
  glm::vec2 shift{0};
};

/// One of a mesh's pictures laid over a material.
struct MeshMap {
  int image = -1;  ///< its number; -1: none
  bool repeats = true;
  TexturePlace place = {};
};

/// A material as a mesh's file has it: scene::Material and scene::Finish say what its values are.
struct MeshMaterial {
  glm::vec3 color{1};
  float opacity = 1, roughness = 1, metallic = 1;
  MeshMap colorMap, normals, metalRough, occlusion, emissionMap;
  MeshMap opacityMap;  ///< instead of the colour's map's own: its opacity, or its brightness
  float normalStrength = 1, occlusionStrength = 1;
  glm::vec3 emission{0};
  float emissionStrength = 1;
  int alpha = 0;  ///< a scene::Alpha
  float cutoff = 0.5F;
  bool doubleSided = false;
  float coat = 0, coatRoughness = 0;
  glm::vec3 sheen{0};
  float sheenRoughness = 0;
  float transmission = 0, ior = 1.5F;
  bool thin = true;  ///< without a volume of its own
  glm::vec3 attenuation{1};
  float attenuationDistance = 1;
};

/// Indexed triangles. Positions in m, unit normals, one of each per vertex; uvs are empty when the file has
/// none, v counts from a picture's first row. Where materials move their pictures, uvs have been moved.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  /// Linear RGB of each vertex, which multiplies the base colour; empty where the file has none.
  std::vector<glm::vec3> colors;
  std::vector<unsigned> indices;        ///< three a triangle, counter-clockwise seen from outside
  std::vector<MeshMaterial> materials;  ///< empty where the file has none
  std::vector<int> materialOf;          ///< of each triangle, -1: none; empty where there are no materials
  std::vector<MeshImage> images;
  std::vector<std::string> ignored;  ///< what looks have that is not drawn: a key and whose it is
  std::vector<std::string> undrawn;  ///< what else is not drawn, whatever the look: "lines (3)"

  template <class Archive>
  void pack(Archive& archive) {
    archive(positions);
    archive(normals);
    archive(uvs);
    archive(colors);
    archive(indices);
    archive(materials);
    archive(materialOf);
    archive(images);
    archive(ignored);
    archive(undrawn);
  }
};

/// What faces get whose file has no normals. `shown`: what the format says, flat ones with vertices of
/// their own. `shared`: a normal around each vertex of the file, for those who work with these vertices.
enum class MeshNormals { shown, shared };

/// Reads OBJ, PLY, glTF or GLB: every mesh of the file with its node's transform, polygons as triangles,
/// points and lines left out. Where a file has no normals, glTF is flat, OBJ by its smoothing groups, PLY
/// smooth around its vertices. Throws UserError: usage for another extension, what readFile says for a file
/// that cannot be read, inputOutput for one that is not what it says, promises more than its bytes can
/// hold, names a file outside its folder, holds no triangle, a vertex that is not finite or beyond 1e9 m, a
/// face of more than 10,000 corners, or more than 8 million vertices or triangles. All of it happens in a
/// process of its own with limits on memory and time; a crash there is one such error here.
[[nodiscard]] Mesh loadMesh(const std::filesystem::path& file, MeshNormals normals = MeshNormals::shown);

/// The same in this process, for those who look for such crashes.
[[nodiscard]] Mesh importMesh(const std::filesystem::path& file, MeshNormals normals = MeshNormals::shown);

/// Whether its name ends as those of glTF files do.
[[nodiscard]] bool isGltf(const std::filesystem::path& file);

/// What `read` returns, done in that process of its own: for other readers of the same files.
[[nodiscard]] std::string readApart(const std::filesystem::path& file,
                                    const std::function<std::string()>& read);

}  // namespace simreel::sim
