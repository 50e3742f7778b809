#pragma once
#include "draw/surface/skin_maps.hpp"
#include "frame/mesh/gltf_parts.hpp"
#include "scene/scene.hpp"
#include "sim/core/simulation.hpp"
#include "sim/world/shown_mesh.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace simreel::frame {

/// Pictures of a material with a skin (scene::Skin).
struct SkinPictures {
  draw::SkinMaps maps;
  glm::vec3 glow{0};     ///< largest emitted radiance, linear RGB
  glm::vec2 repeats{1};  ///< repeats of the pictures along u and v
};
/// Returns the pictures of a material's skin, or nullopt if the material has no skin.
using SkinPicturesOf = std::function<std::optional<SkinPictures>(const scene::Material& material)>;

/// Writes materials into a glTF document (Khronos, "glTF 2.0 specification", 3.9 and 5.19): metallic and
/// roughness, maps, emission, opacity, and the extensions KHR_materials_clearcoat, _sheen, _transmission,
/// _ior, _volume, _emissive_strength and KHR_texture_transform. Images are embedded as PNG. An image that
/// several materials use is embedded once.
class GltfMaterials {
 public:
  GltfMaterials(nlohmann::ordered_json& document, GltfContents& contents, const SkinPicturesOf& skins)
      : document_(document), contents_(contents), skins_(skins) {}

  /// Adds the materials of a mesh's parts. Returns one material index per part, or null for a part without
  /// a material.
  [[nodiscard]] nlohmann::ordered_json add(const sim::MeshTable& mesh, const sim::MeshLooks& looks,
                                           const std::string& name);
  /// Adds a material that emits light. `color` is the emitted radiance, linear RGB.
  [[nodiscard]] std::size_t addGlow(const std::string& name, const glm::vec3& color);
  /// Adds the images, textures and samplers to the document; call after the last material.
  void finish();

 private:
  using Json = nlohmann::ordered_json;
  /// Meaning of an image's values: sRGB colours or linear numbers.
  enum class Holds { colors, numbers };

  /// `textured`: true if the mesh has texture coordinates. `white`: true if the base colour of the material
  /// must be white, because the vertices or copies hold the colour.
  Json described(const scene::Material& material, bool textured, bool white);
  void addFinish(Json& json, const scene::Material& material, bool textured);
  void addExtensions(Json& json, const scene::Finish& finish);
  void addEmission(Json& json, const glm::vec3& radiance);
  void addSkin(Json& json, const SkinPictures& skin);
  Json textureInfo(std::size_t image, scene::Wrap wrapU, scene::Wrap wrapV, const glm::vec2& repeats);
  Json textureInfo(const scene::Map& map, Holds holds);
  std::size_t image(const std::string& key, const std::string& name,
                    const std::function<std::vector<std::byte>()>& png);
  void extend(Json& json, const char* extension, const Json& values);

  Json& document_;
  GltfContents& contents_;
  const SkinPicturesOf& skins_;
  std::map<std::string, std::size_t> known_;  ///< image indices by the key of the image
  Json images_ = Json::array(), textures_ = Json::array(), samplers_ = Json::array();
};

/// Adds a mesh with the primitives that are not null to the document, and assigns the mesh to the last
/// node. `materials`: result of GltfMaterials::add().
void addMesh(nlohmann::ordered_json& document, const std::string& name,
             const std::vector<nlohmann::ordered_json>& primitives,
             const nlohmann::ordered_json& materials);

}  // namespace simreel::frame
