#include "sim/mesh/looks.hpp"

#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

constexpr int maxPictureSide = 16384;

using Images = std::vector<std::shared_ptr<const scene::Image>>;

Images decoded(const Mesh& mesh) {
  Images images;
  for (const MeshImage& image : mesh.images) {
    Picture picture = decodePicture(image.bytes, image.name, "texture", maxPictureSide);
    images.push_back(std::make_shared<const scene::Image>(
        scene::Image{image.name, picture.size, std::move(picture.rgba)}));
  }
  return images;
}

scene::Map mapOf(const MeshMap& map, const Images& images) {
  if (map.image < 0) return {};
  return {{}, images.at(static_cast<std::size_t>(map.image)), map.wrapU, map.wrapV};
}

/// Returns the colour map with its opacity replaced by another image's alpha channel, or by the brightness
/// if that image has no alpha channel.
scene::Map withOpacity(const scene::Map& color, const scene::Image& from) {
  const bool itsOwn =
      std::any_of(from.rgba.begin(), from.rgba.end(),
                  [&, at = 0](std::uint8_t byte) mutable { return at++ % 4 == 3 && byte < 255; });
  scene::Image image = color.image ? *color.image : scene::Image{from.name, from.size, {}};
  if (!color.image) image.rgba.assign(from.rgba.size(), 255);
  const Picture opacity{from.size, from.rgba};
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x; ++x) {
      const int fromX = static_cast<int>(std::int64_t{x} * from.size.x / image.size.x);
      const int fromY = static_cast<int>(std::int64_t{y} * from.size.y / image.size.y);
      const std::size_t texel =
          4 * (static_cast<std::size_t>(fromY) * static_cast<std::size_t>(from.size.x) +
               static_cast<std::size_t>(fromX));
      const std::size_t here = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
                                    static_cast<std::size_t>(x));
      image.rgba[here + 3] =
          itsOwn ? from.rgba[texel + 3] : static_cast<std::uint8_t>(opacity.level(fromX, fromY));
    }
  return {{}, std::make_shared<const scene::Image>(std::move(image)), color.wrapU, color.wrapV};
}

scene::Material materialOf(const MeshMaterial& from, const Images& images, bool castsShadow) {
  scene::Material material;
  material.castsShadow = castsShadow;
  material.color = from.color;
  material.roughness = from.roughness;
  material.metallic = from.metallic;
  scene::Finish& finish = material.finish;
  finish.color = mapOf(from.colorMap, images);
  if (from.opacityMap.image >= 0)
    finish.color = withOpacity(finish.color, *images.at(static_cast<std::size_t>(from.opacityMap.image)));
  finish.normals = mapOf(from.normals, images);
  finish.normalStrength = from.normalStrength;
  finish.metalRough = mapOf(from.metalRough, images);
  finish.occlusion = mapOf(from.occlusion, images);
  finish.occlusionStrength = from.occlusionStrength;
  finish.emission = from.emission;
  finish.emissionStrength = from.emissionStrength;
  finish.emissionMap = mapOf(from.emissionMap, images);
  finish.alpha = static_cast<scene::Alpha>(from.alpha);
  finish.opacity = from.opacity;
  finish.cutoff = from.cutoff;
  finish.doubleSided = from.doubleSided;
  finish.coat = from.coat;
  finish.coatRoughness = from.coatRoughness;
  finish.sheen = from.sheen;
  finish.sheenRoughness = from.sheenRoughness;
  finish.transmission = from.transmission;
  finish.ior = from.ior;
  finish.thin = from.thin;
  finish.attenuation = from.attenuation;
  finish.attenuationDistance = from.attenuationDistance;
  return material;
}

/// Returns a mesh of the triangles of one material and the vertices that they use.
Mesh partOf(const Mesh& mesh, int material) {
  constexpr unsigned unused = ~0U;
  Mesh part;
  std::vector<unsigned> numbers(mesh.positions.size(), unused);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (mesh.materialOf[i / 3] != material) continue;
    const unsigned vertex = mesh.indices[i];
    unsigned& number = numbers[vertex];
    if (number == unused) {
      number = static_cast<unsigned>(part.positions.size());
      part.positions.push_back(mesh.positions[vertex]);
      part.normals.push_back(mesh.normals[vertex]);
      if (!mesh.uvs.empty()) part.uvs.push_back(mesh.uvs[vertex]);
      if (!mesh.colors.empty()) part.colors.push_back(mesh.colors[vertex]);
    }
    part.indices.push_back(number);
  }
  return part;
}

/// Returns the material numbers that the mesh's triangles use, ascending.
std::vector<int> usedOf(const Mesh& mesh) {
  std::vector<int> used = mesh.materialOf;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

}  // namespace

scene::Material fallbackMaterial(const scene::Object& object, const Mesh& mesh) {
  scene::Material material = object.material;
  if (!mesh.colors.empty() && !object.materialKeys.contains("color")) material.color = glm::vec3(1);
  return material;
}

std::vector<MaterialPart> looksOf(const scene::Object& object, const Mesh& mesh) {
  if (object.hasMaterial() || mesh.materials.empty()) return {};
  const Images images = decoded(mesh);
  const std::vector<int> used = usedOf(mesh);
  std::vector<MaterialPart> looks;
  for (const int number : used) {
    MaterialPart look;
    look.material = number < 0 ? fallbackMaterial(object, mesh)
                               : materialOf(mesh.materials.at(static_cast<std::size_t>(number)), images,
                                            object.material.castsShadow);
    if (used.size() > 1) look.mesh = partOf(mesh, number);
    looks.push_back(std::move(look));
  }
  return looks;
}

MovingMeshMaterials::MovingMeshMaterials(const scene::Object& object, const Mesh& mesh) {
  std::vector<MaterialPart> looks = looksOf(object, mesh);
  if (looks.empty()) {
    parts_.push_back({fallbackMaterial(object, mesh), {}, 0});
    return;
  }
  const std::vector<int> used = usedOf(mesh);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    Part part{std::move(looks[i].material), {}, 0};
    if (used.size() > 1) {
      std::vector<unsigned> indices;
      for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
        if (mesh.materialOf[corner / 3] == used[i]) indices.push_back(mesh.indices[corner]);
      part.indices = gl::Buffer::of<unsigned>(object.name + " indices", indices);
      part.indexCount = static_cast<int>(indices.size());
    }
    parts_.push_back(std::move(part));
  }
}

void MovingMeshMaterials::publish(const Surface& surface, Drawables& drawables) const {
  for (const Part& part : parts_) {
    Surface shown = surface;
    if (part.indexCount > 0) {
      shown.indices = &part.indices;
      shown.indexCount = part.indexCount;
    }
    shown.material = &part.material;
    drawables.surfaces.push_back(shown);
  }
}

std::string ignoredLooks(const scene::Object& object, const Mesh& mesh) {
  std::vector<std::string> all = mesh.undrawn;
  if (!object.hasMaterial()) all.insert(all.end(), mesh.ignored.begin(), mesh.ignored.end());
  if (all.empty()) return {};
  constexpr std::size_t maximum = 8;
  const std::size_t said = std::min(maximum, all.size());
  std::string line =
      fmt::format("{}", fmt::join(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(said), "; "));
  if (said < all.size()) line += fmt::format("; and {} more", all.size() - said);
  return line;
}

}  // namespace simreel::sim
