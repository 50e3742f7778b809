#include "draw/exact/surface/surface_shading.hpp"

#include "draw/draw_state.hpp"
#include "draw/exact/shown.hpp"
#include "draw/surface/skin_look.hpp"
#include "draw/surface/surface_pass.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

constexpr unsigned triplanar = 1U << 7U;
constexpr unsigned skinned = 1U << 9U;
constexpr unsigned joinedOnes = 1U << 10U;
constexpr const char* featureNames[] = {
    "DOUBLE_SIDED",  "TRANSLUCENT", "REFLECTIVE",   "PALETTE", "COUNTED",  "TEXTURED",   "GRID",
    "TRIPLANAR",     "BUMPED",      "SKIN",         "JOINED",  "BASE_MAP", "NORMAL_MAP", "METAL_ROUGH_MAP",
    "OCCLUSION_MAP", "EMISSION",    "EMISSION_MAP", "COAT",    "SHEEN",    "BLENDED",    "VERTEX_COLORS"};
constexpr unsigned blendedLayer = 1U << 19U;
constexpr unsigned smooth = 1U << 21U;  // what mirrors the ground

unsigned featuresOf(const sim::Surface& surface, bool skin) {
  const scene::Material& material = *surface.material;
  scene::Material shown = material;
  if (skin) shown.roughness = lookOf(*material.skin).roughness;
  const scene::Finish& finish = material.finish;
  const bool finished = !skin && finish.used();
  const bool textured = !skin && !finished && !material.texture.empty();
  const bool colored = finished && !SurfaceShading::colorMapOf(material).empty();
  const bool emits = finished && finish.emits();
  const bool glowMap = emits && !finish.emissionMap.empty();
  const bool mapped = finished && (colored || !finish.normals.empty() || !finish.metalRough.empty() ||
                                   !finish.occlusion.empty() || glowMap);
  const bool grid = surface.normals == nullptr;
  const bool byUv = (grid || surface.uvs != nullptr) &&
                    !(skin && material.skin->projection != scene::Skin::Projection::uv);
  const bool laidOn = skin || textured || mapped;
  const bool wanted[] = {
      surface.doubleSided,
      material.translucency > 0,
      isReflective(shown) || (finished && (finish.coat > 0 || !finish.metalRough.empty())),
      !skin && surface.palette != nullptr,
      surface.arguments != nullptr,
      textured,
      laidOn && byUv && grid,
      laidOn && !byUv,
      textured && material.bump != 0,
      skin,
      false,
      colored,
      finished && !finish.normals.empty(),
      finished && !finish.metalRough.empty(),
      finished && !finish.occlusion.empty(),
      emits,
      glowMap,
      finished && finish.coat > 0,
      finished && finish.sheen != glm::vec3(0),
      finished && finish.alpha == scene::Alpha::blend,
      !skin && surface.colors != nullptr};
  unsigned features = 0;
  for (std::size_t i = 0; i < std::size(wanted); ++i) features |= wanted[i] ? 1U << i : 0U;
  return features;
}

/// What shaders that lay something over a surface read of it, and of how often it is repeated.
void setSeen(const sim::Surface& surface, glm::vec2 repeats, const gl::Program& shader) {
  shader.set("textureScale", repeats);
  shader.set("model", surface.model);
  shader.set("modelScale", std::sqrt(std::max(glm::dot(surface.model[0], surface.model[0]), 1e-30F)));
  if (surface.normals == nullptr) {
    shader.set("grid", surface.grid);
    shader.set("perGrid", 1.0F / glm::vec2(surface.grid - 1));
    shader.set("perRow", 1.0F / static_cast<float>(surface.grid.x));
  } else if (surface.uvs != nullptr) {
    surface.uvs->bind(uvUnit);
  }
}

}  // namespace

bool SurfaceShading::textureRepeats(const sim::Surface& surface) {
  return surface.normals != nullptr || glm::vec2(surface.material->textureScale) != glm::vec2(1);
}

scene::Map SurfaceShading::colorMapOf(const scene::Material& material) {
  if (!material.finish.color.empty()) return material.finish.color;
  return {material.texture, nullptr, true};
}

SurfaceShading::SurfaceShading(const scene::Scene& scene, gl::Defines defines)
    : scene_(scene), defines_(std::move(defines)) {
  for (const scene::Object& object : scene.objects)
    if (!object.material.finish.used()) textures_.load(object.material.texture);
}

const gl::Program& SurfaceShading::program(unsigned features, int look) {
  const auto found = programs_.find({features, look, shown_});
  if (found != programs_.end()) return found->second;
  gl::Defines defines = showing(defines_, shown_);
  if ((features & blendedLayer) != 0)  // they are before what keeps light out, and nothing is behind them
    std::erase_if(defines, [](const auto& define) {
      return define.first == "OCCLUSION" || define.first == "BEHIND";
    });
  if ((features & smooth) == 0) withoutGround(defines);
  for (std::size_t i = 0; i < std::size(featureNames); ++i)
    if ((features >> i & 1U) != 0) defines.emplace_back(featureNames[i], "1");
  if (look >= 0) {
    scene::Skin skin;
    skin.look = static_cast<scene::Skin::Look>(look);
    defines.emplace_back(lookOf(skin).define, "1");
  }
  return programs_
      .emplace(std::tuple(features, look, shown_),
               gl::Program::compute("draw/exact/surface/shade_surface.comp", defines))
      .first->second;
}

void SurfaceShading::prepare(const SkinTextures& skins) {
  for (const scene::Object& object : scene_.objects)
    if (object.material.skin)
      if (const SkinTextures::Entry* entry = skins.find(*object.material.skin)) skinTexels_.update(*entry);
}

void SurfaceShading::shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn,
                           const SkinTextures& skins, const ShadedTiles& tiles, int thing) {
  const sim::Surface& surface = *drawn.surface;
  const scene::Material& material = *surface.material;
  if (shown_ == shownReflections && !mirrorsScene(surface, skins)) return;
  const SkinTextures::Entry* skin = material.skin ? skins.find(*material.skin) : nullptr;
  const unsigned ground = mirrorsGround(defines_) && mirrorsScene(surface, skins) ? smooth : 0U;
  const gl::Program& shader = program(featuresOf(surface, skin != nullptr) | ground,
                                      skin != nullptr ? static_cast<int>(material.skin->look) : -1);
  raster.bind(drawn, shader);
  shader.set("color", material.color);
  shader.set("material", glm::vec3(material.roughness, material.metallic, material.translucency));
  if (owner_) {
    shader.set("owner", owner_(material));
    shader.set("clear", static_cast<int>(!material.skin && material.finish.transmission > 0));
  }
  shader.set("mirrorReach", mirrorReach_);
  bindPositions(surface, shader);
  if (surface.palette != nullptr) surface.palette->bind(paletteUnit);
  if (surface.colors != nullptr) surface.colors->bind(paletteUnit);
  if (skin != nullptr)
    setSkin(surface, *skin, shader);
  else if (material.finish.used())
    setFinish(surface, shader);
  else if (const TexelLists::List* albedo = textures_.load(material.texture))
    setTexture(surface, *albedo, shader);
  tiles.shade(thing, shader);
}

bool SurfaceShading::mirrorsScene(const sim::Surface& surface, const SkinTextures& skins) {
  const scene::Material& material = *surface.material;
  const scene::Finish& finish = material.finish;
  if (material.skin && skins.find(*material.skin) != nullptr)
    return draw::mirrorsScene(lookOf(*material.skin).roughness);
  return draw::mirrorsScene(material.roughness) ||
         (finish.used() &&
          (!finish.metalRough.empty() || (finish.coat > 0 && draw::mirrorsScene(finish.coatRoughness))));
}

bool SurfaceShading::isPlain(const sim::Surface& surface, const SkinTextures& skins) {
  const scene::Material& material = *surface.material;
  return material.texture.empty() && surface.palette == nullptr && surface.colors == nullptr &&
         !material.finish.used() && !(material.skin && skins.find(*material.skin) != nullptr);
}

void SurfaceShading::shadeJoined(const JoinedSurfaces& joined, const TriangleRaster& raster,
                                 std::span<const TriangleRaster::Drawn> drawn, const ShadedTiles& tiles,
                                 int thing) {
  const bool mirror = std::any_of(drawn.begin(), drawn.end(), [](const auto& one) {
    return draw::mirrorsScene(one.surface->material->roughness);
  });
  if (shown_ == shownReflections && !mirror) return;
  unsigned features = joinedOnes | (mirror && mirrorsGround(defines_) ? smooth : 0U);
  int triangles = 0;
  for (const TriangleRaster::Drawn& one : drawn) {
    features |= featuresOf(*one.surface, false);
    triangles += one.maxTriangles;
  }
  const gl::Program& shader = program(features, -1);
  raster.bindWhole(shader);
  joined.bind();
  shader.set("mirrorReach", mirrorReach_);
  shader.set("firstId", drawn.front().firstId);
  shader.set("triangleCount", triangles);
  tiles.shade(thing, shader);
}

void SurfaceShading::setFinish(const sim::Surface& surface, const gl::Program& shader) {
  using Holds = MapTexels::Holds;
  const scene::Material& material = *surface.material;
  const scene::Finish& finish = material.finish;
  setSeen(surface, glm::vec2(material.textureScale), shader);
  shader.set("colorMap", maps_.place(colorMapOf(material), Holds::color));
  shader.set("normalMap", maps_.place(finish.normals, Holds::numbers));
  shader.set("normalStrength", finish.normalStrength);
  shader.set("metalRoughMap", maps_.place(finish.metalRough, Holds::numbers));
  shader.set("occlusionMap", maps_.place(finish.occlusion, Holds::numbers));
  shader.set("occlusionStrength", finish.occlusionStrength);
  shader.set("emission", finish.emission * finish.emissionStrength);
  shader.set("emissionMap", maps_.place(finish.emissionMap, Holds::color));
  shader.set("coat", glm::vec2(finish.coat, finish.coatRoughness));
  shader.set("sheen", finish.sheen);
  shader.set("sheenRoughness", finish.sheenRoughness);
  shader.set("opacity", finish.opacity);
  maps_.bind();
}

bool SurfaceShading::hasHoles(const sim::Surface& surface) {
  return surface.material->finish.alpha != scene::Alpha::opaque && !colorMapOf(*surface.material).empty();
}

void SurfaceShading::setHoles(const sim::Surface& surface, float least, const gl::Program& kernel) {
  const scene::Material& material = *surface.material;
  setSeen(surface, glm::vec2(material.textureScale), kernel);
  kernel.set("colorMap", maps_.place(colorMapOf(material), MapTexels::Holds::color));
  kernel.set("opacityLimit", glm::vec2(material.finish.opacity, least));
  maps_.bind();
}

void SurfaceShading::setSkin(const sim::Surface& surface, const SkinTextures::Entry& entry,
                             const gl::Program& shader) const {
  const scene::Skin& skin = *surface.material->skin;
  const bool byUv = (surface.normals == nullptr || surface.uvs != nullptr) &&
                    skin.projection == scene::Skin::Projection::uv;
  // From three sides, cells are squares whatever the field's shape.
  const float shape = static_cast<float>(entry.cells.x) / static_cast<float>(entry.cells.y);
  setSeen(surface, {skin.repeats, byUv ? skin.repeats : skin.repeats * shape}, shader);
  SkinTextures::set(entry, skin, shader);
  skinTexels_.find(entry).bind(reliefUnit);
}

void SurfaceShading::setTexture(const sim::Surface& surface, const TexelLists::List& albedo,
                                const gl::Program& shader) {
  const scene::Material& material = *surface.material;
  setSeen(surface, glm::vec2(material.textureScale), shader);
  shader.set("albedoSize", albedo.size);
  shader.set("albedoLevels", albedo.levels);
  shader.set("albedoRepeats", static_cast<int>(textureRepeats(surface)));
  shader.set("bump", material.bump);
  albedo.view.bind(albedoUnit);
}

}  // namespace simreel::draw
