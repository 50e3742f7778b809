#include "sim/mesh/file/gltf_materials.hpp"

#include "base/ieee.hpp"
#include "scene/finish.hpp"
#include "sim/mesh/file/texture_place.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

// Values of GL_REPEAT, GL_CLAMP_TO_EDGE and GL_MIRRORED_REPEAT.
constexpr std::uint64_t repeatWrap = 10497, clampWrap = 33071, mirrorWrap = 33648;
constexpr std::uint64_t nearestFilter = 9728, linearFilter = 9729;
constexpr std::size_t maxMaterials = 4096;
constexpr const char* transformName = "KHR_texture_transform";
constexpr MapNames gltfMapNames = {"baseColorTexture", "",  // opacity has no map, because it is the
                                                            // alpha channel of the colour
                                   "metallicRoughnessTexture", "normalTexture", "occlusionTexture",
                                   "emissiveTexture"};

std::optional<JsonValue> textureTransformOf(const JsonValue& textureInfo) {
  const auto extensions = textureInfo.find("extensions");
  return extensions ? extensions->find(transformName) : std::nullopt;
}

/// Returns the set number of the texture coordinates that a texture uses.
std::uint64_t uvSetIn(const JsonValue& textureInfo) {
  const std::uint64_t set = GltfDocument::number(textureInfo, "texCoord", 0);
  const auto transform = textureTransformOf(textureInfo);
  return transform ? GltfDocument::number(*transform, "texCoord", set) : set;
}

/// Returns the set number of the first texture that a material has.
std::uint64_t firstUvSet(const JsonValue& material) {
  const auto pbr = material.find("pbrMetallicRoughness");
  for (const char* name : gltfMapNames) {
    const auto inside = pbr ? pbr->find(name) : std::nullopt;
    const auto found = inside ? inside : material.find(name);
    if (found) return uvSetIn(*found);
  }
  return 0;
}

/// Returns the transform u' = T R S u (translation, rotation, scale), where R is counter-clockwise as the
/// image is displayed, with v pointing down.
TexturePlace transformedPlace(const JsonValue& transform) {
  constexpr float maximum = 1e6F;
  const auto pair = [&](const char* key, float otherwise) {
    const std::vector<float> v = GltfDocument::numbers(transform, key, 2);
    return v.empty() ? glm::vec2(otherwise) : glm::clamp(glm::vec2(v[0], v[1]), -maximum, maximum);
  };
  const glm::vec2 scale = pair("scale", 1);
  const auto rotation = transform.find("rotation");
  const double angle = rotation ? std::clamp(rotation->number(), -1e3, 1e3) : 0;
  const auto c = static_cast<float>(ieee::cos(angle)), s = static_cast<float>(ieee::sin(angle));
  return {{scale.x * c, -scale.x * s, scale.y * s, scale.y * c}, pair("offset", 0)};
}

/// Returns the name of the image format if it is an unsupported format of a glTF extension; otherwise null.
const char* unreadFormat(std::string_view bytes) {
  if (bytes.starts_with("RIFF") && bytes.substr(std::min<std::size_t>(8, bytes.size())).starts_with("WEBP"))
    return "WebP";
  if (bytes.starts_with("\xABKTX 20")) return "KTX2";
  return bytes.starts_with("DDS ") ? "DDS" : nullptr;
}

class MaterialReader {
 public:
  explicit MaterialReader(const GltfDocument& document) : document_(document) {}

  GltfMaterials read() {
    const std::size_t count = document_.size("materials");
    if (count > maxMaterials)
      document_.refuse(fmt::format("has {} materials, more than {}", count, maxMaterials));
    for (std::size_t i = 0; i < count; ++i) {
      const JsonValue material = document_.item("materials", i);
      const auto name = material.find("name");
      name_ = name ? fmt::format("\"{}\"", name->text()) : fmt::format("number {}", i);
      all_.materials.push_back(readOne(material));
    }
    ignoreElse();
    return std::move(all_);
  }

 private:
  void ignore(const std::string& key) {
    all_.ignored.push_back(fmt::format("{} of material {}", key, name_));
  }

  /// Reports unsupported features outside of materials: extensions in use that are neither supported nor
  /// reported elsewhere, and colours of unlit meshes.
  void ignoreElse() {
    if (const auto used = document_.root().find("extensionsUsed"))
      for (const std::string& extension : used->texts())
        if (extension == "KHR_materials_variants" ||
            (!extension.starts_with("KHR_materials_") && !extension.starts_with("KHR_texture_") &&
             !extension.starts_with("EXT_texture_") && extension != "KHR_mesh_quantization" &&
             extension != "KHR_lights_punctual"))
          all_.ignored.push_back(extension);
    bool tinted = false;
    for (std::size_t i = 0; i < document_.size("meshes"); ++i)
      document_.item("meshes", i).at("primitives").eachItem([&](const JsonValue& primitive) {
        const std::uint64_t material =
            GltfDocument::number(primitive, "material", document_.size("materials"));
        tinted = tinted ||
                 (material < document_.size("materials") && primitive.at("attributes").has("COLOR_0") &&
                  isUnlit(document_.item("materials", material)));
      });
    if (tinted) all_.ignored.emplace_back("COLOR_0 of what is unlit");
  }

  static float number(const JsonValue& object, const char* key, float otherwise) {
    const auto found = object.find(key);
    return found ? static_cast<float>(found->number()) : otherwise;
  }
  /// Returns a factor clamped to 0..1, the range that glTF defines.
  static float share(const JsonValue& object, const char* key, float otherwise) {
    return std::clamp(number(object, key, otherwise), 0.0F, 1.0F);
  }
  static glm::vec3 color(const JsonValue& object, const char* key, glm::vec3 otherwise) {
    const std::vector<float> v = GltfDocument::numbers(object, key, 3);
    return v.empty() ? otherwise : glm::clamp(glm::vec3(v[0], v[1], v[2]), 0.0F, 1e6F);
  }

  MeshMaterial readOne(const JsonValue& json) {
    MeshMaterial material;
    set_ = firstUvSet(json);
    if (const auto pbr = json.find("pbrMetallicRoughness")) {
      const std::vector<float> base = GltfDocument::numbers(*pbr, "baseColorFactor", 4);
      if (!base.empty()) {
        material.color = glm::clamp(glm::vec3(base[0], base[1], base[2]), 0.0F, 1.0F);
        material.opacity = std::clamp(base[3], 0.0F, 1.0F);
      }
      material.metallic = share(*pbr, "metallicFactor", 1);
      material.roughness = share(*pbr, "roughnessFactor", 1);
      material.colorMap = map(*pbr, "baseColorTexture");
      material.metalRough = map(*pbr, "metallicRoughnessTexture");
    }
    material.normals = map(json, "normalTexture");
    if (const auto normals = json.find("normalTexture"))
      material.normalStrength = std::clamp(number(*normals, "scale", 1), -10.0F, 10.0F);
    material.occlusion = map(json, "occlusionTexture");
    if (const auto occlusion = json.find("occlusionTexture"))
      material.occlusionStrength = share(*occlusion, "strength", 1);
    material.emission = color(json, "emissiveFactor", glm::vec3(0));
    material.emissionMap = map(json, "emissiveTexture");
    if (const auto sides = json.find("doubleSided")) material.doubleSided = sides->boolean();
    const auto mode = json.find("alphaMode");
    const std::string word = mode ? mode->text() : "OPAQUE";
    if (word == "MASK")
      material.alpha = static_cast<int>(scene::Alpha::cut);
    else if (word == "BLEND")
      material.alpha = static_cast<int>(scene::Alpha::blend);
    else if (word != "OPAQUE")
      ignore(fmt::format("alphaMode {}", word));
    material.cutoff = share(json, "alphaCutoff", 0.5F);
    if (const auto extensions = json.find("extensions")) {
      extensions->eachMember(
          [&](const std::string& key, const JsonValue& value) { extend(material, key, value); });
      for (const char* key : {"KHR_materials_ior", "KHR_materials_volume"})
        if (material.transmission <= 0 && extensions->has(key)) ignore(key);
    }
    if (isUnlit(json)) material = unlit(material);
    agreeOnPlace(material, gltfMapNames, [&](const char* key) {
      ignore(fmt::format("{} (its {} is not that of the others)", key, transformName));
    });
    return material;
  }

  static bool isUnlit(const JsonValue& material) {
    const auto extensions = material.find("extensions");
    return extensions && extensions->has("KHR_materials_unlit");
  }

  /// Converts an unlit material, whose colour does not depend on the light. The result is emissive and has
  /// no diffuse colour; its roughness is so high that it reflects only at grazing angles.
  static MeshMaterial unlit(const MeshMaterial& material) {
    MeshMaterial shining;
    shining.color = glm::vec3(0);
    shining.metallic = shining.roughness = 1;
    shining.emission = material.color;
    shining.emissionMap = material.colorMap;
    if (material.alpha != static_cast<int>(scene::Alpha::opaque)) shining.colorMap = material.colorMap;
    shining.alpha = material.alpha;
    shining.opacity = material.opacity;
    shining.cutoff = material.cutoff;
    shining.doubleSided = material.doubleSided;
    return shining;
  }

  void extend(MeshMaterial& material, const std::string& key, const JsonValue& value) {
    if (key == "KHR_materials_emissive_strength") {
      material.emissionStrength = std::clamp(number(value, "emissiveStrength", 1), 0.0F, 1e6F);
    } else if (key == "KHR_materials_clearcoat") {
      material.coat = share(value, "clearcoatFactor", 0);
      material.coatRoughness = share(value, "clearcoatRoughnessFactor", 0);
      for (const char* map : {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"})
        if (value.has(map)) ignore(map);
    } else if (key == "KHR_materials_sheen") {
      material.sheen = glm::min(color(value, "sheenColorFactor", glm::vec3(0)), glm::vec3(1));
      material.sheenRoughness = std::max(share(value, "sheenRoughnessFactor", 0), 0.07F);
      for (const char* map : {"sheenColorTexture", "sheenRoughnessTexture"})
        if (value.has(map)) ignore(map);
    } else if (key == "KHR_materials_transmission") {
      material.transmission = share(value, "transmissionFactor", 0);
      if (value.has("transmissionTexture")) ignore("transmissionTexture");
    } else if (key == "KHR_materials_ior") {
      material.ior = std::clamp(number(value, "ior", 1.5F), 1.0F, 4.0F);
    } else if (key == "KHR_materials_volume") {
      takeVolume(material, value);
    } else if (key != "KHR_materials_unlit") {
      ignore(key);
    }
  }

  /// A thickness above 0 means that the mesh is the surface of a solid. The value itself is not used,
  /// because rays measure the thickness.
  void takeVolume(MeshMaterial& material, const JsonValue& value) {
    material.thin = number(value, "thicknessFactor", 0) <= 0;
    const float distance = number(value, "attenuationDistance", 0);
    if (!(distance > 0)) return;
    material.attenuation = glm::clamp(color(value, "attenuationColor", glm::vec3(1)), 1e-6F, 1.0F);
    material.attenuationDistance = distance;
  }

  static scene::Wrap wrapOf(const JsonValue& sampler, const char* key) {
    const std::uint64_t wrap = GltfDocument::number(sampler, key, repeatWrap);
    if (wrap == mirrorWrap) return scene::Wrap::mirror;
    return wrap == clampWrap ? scene::Wrap::clamp : scene::Wrap::repeat;
  }

  /// Returns the texture that an object refers to, and adds its image to the list of images.
  MeshMap map(const JsonValue& object, const char* key) {
    const auto found = object.find(key);
    if (!found) return {};
    if (uvSetIn(*found) != set_) {
      ignore(fmt::format("{} (its texCoord differs from that of the other textures)", key));
      return {};
    }
    if (const auto extensions = found->find("extensions"))
      extensions->eachMember([&](const std::string& name, const JsonValue&) {
        if (name != transformName) ignore(fmt::format("{} of {}", name, key));
      });
    const JsonValue texture = document_.item("textures", GltfDocument::number(*found, "index"));
    const auto source = texture.find("source");
    if (!source) {
      ignore(fmt::format("{} (its picture is given only by an extension)", key));
      return {};
    }
    MeshMap map;
    if (const auto transform = textureTransformOf(*found)) map.place = transformedPlace(*transform);
    map.image = imageNumber(GltfDocument::number(texture, "source"));
    if (!texture.has("sampler")) return map;
    const JsonValue sampler = document_.item("samplers", GltfDocument::number(texture, "sampler"));
    map.wrapU = wrapOf(sampler, "wrapS");
    map.wrapV = wrapOf(sampler, "wrapT");
    if (GltfDocument::number(sampler, "magFilter", linearFilter) == nearestFilter)
      ignore(fmt::format("magFilter NEAREST of {}", key));
    return map;
  }

  int imageNumber(std::uint64_t image) {
    const auto known = numbers_.find(image);
    if (known != numbers_.end()) return known->second;
    const JsonValue described = document_.item("images", image);
    MeshImage kept;
    if (const auto uri = described.find("uri")) {
      const std::string text = uri->text();
      if (!text.starts_with("data:")) {
        const std::string why = document_.whyUnreadAt(text);
        if (!why.empty()) {
          all_.ignored.push_back(fmt::format("{} ({})", text, why));
          numbers_.emplace(image, -1);
          return -1;
        }
      }
      kept.name = text.starts_with("data:") ? fmt::format("image {}", image) : decodePercent(text);
      kept.bytes = document_.bytesAt(text);
    } else {
      const auto name = described.find("name");
      kept.name = name ? name->text() : fmt::format("image {}", image);
      kept.bytes = document_.bytesOfView(GltfDocument::number(described, "bufferView"));
    }
    if (const char* format = unreadFormat(kept.bytes)) {
      all_.ignored.push_back(fmt::format("{} (a picture of the format {})", kept.name, format));
      numbers_.emplace(image, -1);
      return -1;
    }
    const int number = static_cast<int>(all_.images.size());
    all_.images.push_back(std::move(kept));
    numbers_.emplace(image, number);
    return number;
  }

  const GltfDocument& document_;
  std::string name_;       ///< name of the material that is being read
  std::uint64_t set_ = 0;  ///< set number of the texture coordinates that the current material's textures
                           ///< use
  std::map<std::uint64_t, int> numbers_;
  GltfMaterials all_;
};

}  // namespace

GltfMaterials readMaterials(const GltfDocument& document) {
  return MaterialReader(document).read();
}

std::uint64_t uvSetOf(const GltfDocument& document, std::size_t material) {
  return firstUvSet(document.item("materials", material));
}

}  // namespace simreel::sim
