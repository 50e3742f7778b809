#include "frame/mesh/gltf_materials.hpp"

#include "base/file.hpp"
#include "base/srgb.hpp"
#include "frame/image.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr int largestPicture = 16384;

Json rgb(const glm::vec3& color) {
  const glm::vec3 within = glm::clamp(color, 0.0F, 1.0F);
  return {within.x, within.y, within.z};
}

/// Encodes RGBA rows as PNG. Leaves out alpha if all pixels are opaque.
std::vector<std::byte> pngOf(glm::ivec2 size, const std::vector<std::uint8_t>& rgba, bool linear) {
  bool opaque = true;
  for (std::size_t i = 3; i < rgba.size(); i += 4) opaque = opaque && rgba[i] == 255;
  if (!opaque) return encodePng(PackedPixels{size, 4, 8, rgba, linear}, {});
  std::vector<std::uint8_t> packed;
  packed.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    packed.insert(packed.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
  return encodePng(PackedPixels{size, 3, 8, packed, linear}, {});
}

sim::Picture pictureOf(const scene::Map& map) {
  if (map.image) return {map.image->size, map.image->rgba};
  return sim::decodePicture(readFile(map.file, "texture"), map.file.string(), "texture", largestPicture);
}

std::uint8_t texelByte(float fraction) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(fraction, 0.0F, 1.0F)));
}

/// Encodes texels as an opaque PNG. `colorOf` returns the colour of a texel.
template <class ColorOf>
std::vector<std::byte> skinPng(const std::vector<glm::vec4>& texels, glm::ivec2 size, bool linear,
                               ColorOf colorOf) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(4 * texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const glm::vec3 color = colorOf(i);
    for (int k = 0; k < 3; ++k) rgba.push_back(texelByte(color[k]));
    rgba.push_back(255);
  }
  return pngOf(size, rgba, linear);
}

glm::vec3 texelColor(const glm::vec3& linear) {
  const auto channel = [](float x) { return static_cast<float>(srgbOfLinear(std::clamp(x, 0.0F, 1.0F))); };
  return {channel(linear.x), channel(linear.y), channel(linear.z)};
}

}  // namespace

void GltfMaterials::extend(Json& json, const char* extension, const Json& values) {
  json["extensions"][extension] = values;
  useExtension(document_, extension);
}

std::size_t GltfMaterials::image(const std::string& key, const std::string& name,
                                 const std::function<std::vector<std::byte>()>& png) {
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  images_.push_back({{"name", name}, {"mimeType", "image/png"}, {"bufferView", contents_.file(png())}});
  return known_.emplace(key, images_.size() - 1).first->second;
}

Json GltfMaterials::textureInfo(std::size_t image, scene::Wrap wrapU, scene::Wrap wrapV,
                                const glm::vec2& repeats) {
  // values of GL_REPEAT, GL_CLAMP_TO_EDGE and GL_MIRRORED_REPEAT, in the order of scene::Wrap
  constexpr int wraps[] = {10497, 33071, 33648};
  constexpr int linear = 9729, linearMipmapLinear = 9987;
  const Json sampler = {{"magFilter", linear},
                        {"minFilter", linearMipmapLinear},
                        {"wrapS", wraps[static_cast<std::size_t>(wrapU)]},
                        {"wrapT", wraps[static_cast<std::size_t>(wrapV)]}};
  const auto number = [](Json& list, const Json& item) {
    const auto at = std::find(list.begin(), list.end(), item);
    const auto index = static_cast<std::size_t>(at - list.begin());
    if (at == list.end()) list.push_back(item);
    return index;
  };
  Json info = {{"index", number(textures_, {{"sampler", number(samplers_, sampler)}, {"source", image}})}};
  if (repeats != glm::vec2(1)) extend(info, "KHR_texture_transform", {{"scale", {repeats.x, repeats.y}}});
  return info;
}

Json GltfMaterials::textureInfo(const scene::Map& map, Holds holds) {
  const bool linear = holds == Holds::numbers;
  const std::string name = map.image ? map.image->name : map.file.filename().string();
  const std::string key =
      map.image ? fmt::format("{} {}", fmt::ptr(map.image.get()), linear) : map.file.string();
  const std::size_t number = image(key, name, [&] {
    const sim::Picture picture = pictureOf(map);
    return pngOf(picture.size, picture.rgba, linear);
  });
  return textureInfo(number, map.wrapU, map.wrapV, glm::vec2(1));
}

void GltfMaterials::addEmission(Json& json, const glm::vec3& radiance) {
  const float brightest = std::max({radiance.x, radiance.y, radiance.z, 1.0F});
  json["emissiveFactor"] = rgb(radiance / brightest);
  if (brightest > 1) extend(json, "KHR_materials_emissive_strength", {{"emissiveStrength", brightest}});
}

void GltfMaterials::addExtensions(Json& json, const scene::Finish& finish) {
  if (finish.coat > 0)
    extend(json, "KHR_materials_clearcoat",
           {{"clearcoatFactor", finish.coat}, {"clearcoatRoughnessFactor", finish.coatRoughness}});
  if (finish.sheen != glm::vec3(0))
    extend(json, "KHR_materials_sheen",
           {{"sheenColorFactor", rgb(finish.sheen)}, {"sheenRoughnessFactor", finish.sheenRoughness}});
  if (!(finish.transmission > 0)) return;
  extend(json, "KHR_materials_transmission", {{"transmissionFactor", finish.transmission}});
  extend(json, "KHR_materials_ior", {{"ior", finish.ior}});
  if (finish.thin) return;
  extend(json, "KHR_materials_volume",
         {{"thicknessFactor", 1},
          {"attenuationDistance", finish.attenuationDistance},
          {"attenuationColor", rgb(finish.attenuation)}});
}

void GltfMaterials::addFinish(Json& json, const scene::Material& material, bool textured) {
  const scene::Finish& finish = material.finish;
  Json& pbr = json["pbrMetallicRoughness"];
  if (textured) {
    if (!finish.color.empty()) pbr["baseColorTexture"] = textureInfo(finish.color, Holds::colors);
    if (!finish.metalRough.empty())
      pbr["metallicRoughnessTexture"] = textureInfo(finish.metalRough, Holds::numbers);
    if (!finish.normals.empty()) {
      json["normalTexture"] = textureInfo(finish.normals, Holds::numbers);
      json["normalTexture"]["scale"] = finish.normalStrength;
    }
    if (!finish.occlusion.empty()) {
      json["occlusionTexture"] = textureInfo(finish.occlusion, Holds::numbers);
      json["occlusionTexture"]["strength"] = finish.occlusionStrength;
    }
    if (finish.emits() && !finish.emissionMap.empty())
      json["emissiveTexture"] = textureInfo(finish.emissionMap, Holds::colors);
  }
  if (finish.emits()) addEmission(json, finish.emission * finish.emissionStrength);
  if (finish.alpha == scene::Alpha::blend) json["alphaMode"] = "BLEND";
  if (finish.alpha != scene::Alpha::cut) return;
  json["alphaMode"] = "MASK";
  json["alphaCutoff"] = finish.cutoff;
}

/// Adds the maps of a skin. The maps hold absolute colours, so the glTF factors become 1.
void GltfMaterials::addSkin(Json& json, const SkinPictures& skin) {
  const draw::SkinMaps& maps = skin.maps;
  Json& pbr = json["pbrMetallicRoughness"];
  const auto add = [&](const char* name, const std::vector<glm::vec4>& texels, bool linear, auto colorOf) {
    const std::size_t number = image(fmt::format("skin {} {}", images_.size(), name), name,
                                     [&] { return skinPng(texels, maps.size, linear, colorOf); });
    return textureInfo(number, scene::Wrap::repeat, scene::Wrap::repeat, skin.repeats);
  };
  pbr["baseColorFactor"] = {1, 1, 1, 1};
  pbr["baseColorTexture"] = add("albedo", maps.surface, false,
                                [&](std::size_t i) { return texelColor(glm::vec3(maps.surface[i])); });
  pbr["roughnessFactor"] = 1;
  pbr["metallicRoughnessTexture"] =
      add("occlusion, roughness, metallic", maps.surface, true,
          [&](std::size_t i) { return glm::vec3(maps.light[i].w, maps.surface[i].w, 1); });
  json["occlusionTexture"] = pbr["metallicRoughnessTexture"];
  json["normalTexture"] = add("normal", maps.relief, true,
                              [&](std::size_t i) { return 0.5F * glm::vec3(maps.relief[i]) + 0.5F; });
  const float brightest = std::max({skin.glow.x, skin.glow.y, skin.glow.z});
  if (!(brightest > 0)) return;
  json["emissiveTexture"] = add("emission", maps.light, false, [&](std::size_t i) {
    return texelColor(glm::vec3(maps.light[i]) / brightest);
  });
  addEmission(json, glm::vec3(brightest));
}

Json GltfMaterials::described(const scene::Material& material, bool textured, bool white) {
  const scene::Finish& finish = material.finish;
  const bool opaque = finish.alpha == scene::Alpha::opaque;
  Json color = rgb(white ? glm::vec3(1) : material.color);
  color.push_back(opaque ? 1.0F : std::clamp(finish.opacity, 0.0F, 1.0F));
  Json json;
  json["pbrMetallicRoughness"] = {{"baseColorFactor", color},
                                  {"metallicFactor", std::clamp(material.metallic, 0.0F, 1.0F)},
                                  {"roughnessFactor", std::clamp(material.roughness, 0.0F, 1.0F)}};
  if (textured && !material.texture.empty() && finish.color.empty())
    json["pbrMetallicRoughness"]["baseColorTexture"] = textureInfo(
        image(material.texture.string(), material.texture.filename().string(),
              [&] {
                const sim::Picture picture =
                    opaque ? sim::loadPicture(material.texture, "texture", largestPicture)
                           : sim::decodePicture(readFile(material.texture, "texture"),
                                                material.texture.string(), "texture", largestPicture);
                return pngOf(picture.size, picture.rgba, false);
              }),
        scene::Wrap::repeat, scene::Wrap::repeat, glm::vec2(material.textureScale));
  addFinish(json, material, textured);
  addExtensions(json, finish);
  if (textured && material.skin && skins_)
    if (const std::optional<SkinPictures> skin = skins_(material)) addSkin(json, *skin);
  return json;
}

Json GltfMaterials::add(const sim::MeshTable& mesh, const sim::MeshLooks& looks, const std::string& name) {
  Json numbers = Json::array();
  const auto keep = [&](const Json& json, bool doubleSided, const std::string& called) {
    Json whole = {{"name", called}};
    whole.update(json);
    if (doubleSided) whole["doubleSided"] = true;
    numbers.push_back(document_["materials"].size());
    document_["materials"].push_back(std::move(whole));
  };
  const bool doubleSided = mesh.doubleSided || looks.doubleSided;
  const std::size_t count = looks.materials.size();
  for (std::size_t i = 0; i < count; ++i) {
    const scene::Material& material = *looks.materials[i];
    const bool used = looks.partOf.empty()
                          ? i == 0
                          : std::find(looks.partOf.begin(), looks.partOf.end(), i) != looks.partOf.end();
    if (used)
      keep(described(material, !mesh.uvs.empty(), looks.ownColors), doubleSided,
           looks.partOf.empty() ? name : fmt::format("{} {}", name, i));
    else
      numbers.push_back(nullptr);
  }
  if (count == 0 && doubleSided) keep(Json::object(), true, name);
  return numbers;
}

std::size_t GltfMaterials::addGlow(const std::string& name, const glm::vec3& color) {
  Json json = {{"name", name}};
  json["pbrMetallicRoughness"] = {
      {"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
  addEmission(json, color);
  document_["materials"].push_back(std::move(json));
  return document_["materials"].size() - 1;
}

void GltfMaterials::finish() {
  if (images_.empty()) return;
  document_["images"] = images_;
  document_["textures"] = textures_;
  document_["samplers"] = samplers_;
}

void addMesh(Json& document, const std::string& name, const std::vector<Json>& primitives,
             const Json& materials) {
  document["nodes"].back()["mesh"] = document["meshes"].size();
  Json kept = Json::array();
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (primitives[i].is_null()) continue;
    kept.push_back(primitives[i]);
    if (i < materials.size() && !materials[i].is_null()) kept.back()["material"] = materials[i];
  }
  document["meshes"].push_back({{"name", name}, {"primitives", kept}});
}

}  // namespace simreel::frame
