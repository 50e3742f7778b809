#pragma once
#include "scene/finish.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Encoded image used by a mesh's materials, as stored in its file: PNG or JPEG.
struct MeshImage {
  std::string name;  ///< name of the image in messages
  std::string bytes;

  template <class Archive>
  void pack(Archive& archive) {
    archive(name);
    archive(bytes);
  }
};

/// Transform of texture coordinates: the texture's uv is `turn` times the mesh's uv, plus `shift`.
struct TexturePlace {
  glm::mat2 turn{1};
  glm::vec2 shift{0};
};

/// Texture map of a material.
struct MeshMap {
  int image = -1;  ///< index into the mesh's images, or -1 for none
  scene::Wrap wrapU = scene::Wrap::repeat, wrapV = scene::Wrap::repeat;
  TexturePlace place = {};
};

/// Material as stored in a mesh's file; for the meaning of its values see scene::Material and
/// scene::Finish.
struct MeshMaterial {
  glm::vec3 color{1};
  float opacity = 1, roughness = 1, metallic = 1;
  MeshMap colorMap, normals, metalRough, occlusion, emissionMap;
  MeshMap opacityMap;  ///< map whose opacity replaces the colour map's opacity; its brightness is used if
                       ///< it has no opacity
  float normalStrength = 1, occlusionStrength = 1;
  glm::vec3 emission{0};
  float emissionStrength = 1;
  int alpha = 0;  ///< a value of scene::Alpha
  float cutoff = 0.5F;
  bool doubleSided = false;
  float coat = 0, coatRoughness = 0;
  glm::vec3 sheen{0};
  float sheenRoughness = 0;
  float transmission = 0, ior = 1.5F;
  bool thin = true;  ///< true for a thin surface that encloses no volume
  glm::vec3 attenuation{1};
  float attenuationDistance = 1;
};

/// Indexed triangle mesh with one position (metres) and one unit normal per vertex. `uvs` is empty if the
/// file has none; v is 0 at an image's first row. Texture transforms of materials are already applied to
/// `uvs`.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  /// Linear RGB factor on the base colour, per vertex; empty if the file has none.
  std::vector<glm::vec3> colors;
  std::vector<unsigned> indices;        ///< vertex indices, three per triangle, counter-clockwise as seen
                                        ///< from outside
  std::vector<MeshMaterial> materials;  ///< materials; empty if the file has none
  std::vector<int> materialOf;          ///< material index per triangle, or -1 for none; empty if there are
                                        ///< no materials
  std::vector<MeshImage> images;
  std::vector<std::string> ignored;  ///< material features that are not drawn, each with its key and
                                     ///< material
  std::vector<std::string> undrawn;  ///< other content that is not drawn, for example "lines (3)"

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

/// Normals for faces of a file without normals. `shown`: normals as the format specifies; flat faces get
/// separate vertices. `shared`: one smooth normal per vertex of the file, for simulations that use the
/// file's vertices.
enum class MeshNormals { shown, shared };

/// File name extensions of the supported mesh formats, for messages.
inline constexpr const char* meshEndings = ".obj, .ply, .stl, .gltf and .glb";

/// Returns true if the file name has the extension of a supported mesh format.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& file);

/// Reads OBJ, PLY, STL, glTF or GLB: every mesh of the file with its node's transform, and polygons as
/// triangles. Ignores points and lines. If the file has no normals, glTF is flat, OBJ follows its smoothing
/// groups, PLY is smooth, and STL is smooth up to an angle of 30 degrees. Throws UserError:
/// - usage for another extension
/// - the errors of readFile() for an unreadable file
/// - inputOutput for content that is malformed, announces more data than it holds, names a file outside its
///   folder, has no triangle, a vertex that is not finite or beyond 1e9 m, a face of more than 10,000
///   corners, or more than 8 million vertices or triangles
///
/// The file is parsed in a separate process with limits on memory and time; a crash of that process also
/// gives inputOutput.
[[nodiscard]] Mesh loadMesh(const std::filesystem::path& file, MeshNormals normals = MeshNormals::shown);

/// Reads a mesh as loadMesh() does, but in the calling process instead of a separate one. Used for fuzzing.
[[nodiscard]] Mesh importMesh(const std::filesystem::path& file, MeshNormals normals = MeshNormals::shown);

/// Returns true if the file name has the extension of a glTF file.
[[nodiscard]] bool isGltf(const std::filesystem::path& file);

/// Runs `read` in a separate process, as loadMesh() does, and returns its result. Serves other readers of
/// mesh files.
[[nodiscard]] std::string readInSeparateProcess(const std::filesystem::path& file,
                                                const std::function<std::string()>& read);

}  // namespace simreel::sim
