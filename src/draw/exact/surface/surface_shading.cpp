#include "draw/exact/surface/surface_shading.hpp"

#include "base/ieee.hpp"
#include "draw/surface/skin_look.hpp"
#include "draw/surface/surface_pass.hpp"
#include "draw/surface_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::draw {

struct SurfaceVariant {
  gl::Flag<"DOUBLE_SIDED"> doubleSided;
  gl::Flag<"TRANSLUCENT"> translucent;
  gl::Flag<"REFLECTIVE"> reflective;
  gl::Flag<"PALETTE"> palette;
  gl::Flag<"COUNTED"> counted;
  gl::Flag<"TEXTURED"> textured;
  gl::Flag<"GRID"> grid;
  gl::Flag<"TRIPLANAR"> triplanar;
  gl::Flag<"BUMPED"> bumped;
  gl::Flag<"SKIN"> skin;
  gl::Flag<"JOINED"> joined;
  gl::Flag<"BASE_MAP"> baseMap;
  gl::Flag<"NORMAL_MAP"> normalMap;
  gl::Flag<"METAL_ROUGH_MAP"> metalRoughMap;
  gl::Flag<"OCCLUSION_MAP"> occlusionMap;
  gl::Flag<"EMISSION"> emission;
  gl::Flag<"EMISSION_MAP"> emissionMap;
  gl::Flag<"COAT"> coat;
  gl::Flag<"SHEEN"> sheen;
  gl::Flag<"BLENDED"> blended;
  gl::Flag<"GLASS"> glass;
  gl::Flag<"REFRACTED"> refracted;
  gl::Flag<"VERTEX_COLORS"> vertexColors;
  gl::Flag<"LOOK_LEATHER"> leather;
  gl::Flag<"LOOK_SPOTS"> spots;
  gl::Flag<"LOOK_CRACKS"> cracks;
  gl::Flag<"LOOK_MAP"> map;
  gl::Flag<"EDGES"> edges = {};
  gl::Flag<"BY_UV"> byUv = {};
};

/// Uniforms, buffers and textures that draw/exact/surface/surface_seen.glsl declares.
struct SurfaceSeen {
  VertexUv uv;
  gl::Uniform<"textureScale", glm::vec2> textureScale;
  gl::Uniform<"model", glm::mat4> model;
  gl::Uniform<"modelScale", float> modelScale;
};

/// Uniforms, buffers and textures that draw/exact/surface/surface_maps.glsl declares.
struct SurfaceMaps {
  gl::Uniform<"colorMap", glm::ivec4> color;
  gl::Uniform<"normalMap", glm::ivec4> normal;
  gl::Uniform<"metalRoughMap", glm::ivec4> metalRough;
  gl::Uniform<"occlusionMap", glm::ivec4> occlusion;
  gl::Uniform<"emissionMap", glm::ivec4> emission;
  gl::Uniform<"normalStrength", float> normalStrength;
  gl::Uniform<"occlusionStrength", float> occlusionStrength;
  gl::In<"texelsOfMaps"> texels;
};

/// Uniforms with the values of a scene::Finish.
struct FinishValues {
  gl::Uniform<"emission", glm::vec3> emission;
  gl::Uniform<"coat", glm::vec2> coat;
  gl::Uniform<"sheen", glm::vec3> sheen;
  gl::Uniform<"sheenRoughness", float> sheenRoughness;
  gl::Uniform<"opacity", float> opacity;
};

/// Uniforms, buffers and textures that draw/exact/surface/glass.glsl declares.
struct GlassSource {
  gl::Uniform<"glass", glm::vec2> glass;
  gl::Uniform<"absorbed", glm::vec3> absorbed;
  gl::Uniform<"glassLayer", glm::ivec4> layer;
  gl::In<"behindLight"> behind;
  gl::In<"layerKeys"> nextKeys;
  gl::In<"layerIds"> nextIds;
};

/// Uniforms, buffers and textures that draw/exact/surface/surface_texture.glsl declares.
struct SurfaceTexture {
  gl::In<"albedo"> albedo;
  gl::Uniform<"albedoSize", glm::ivec2> size;
  gl::Uniform<"albedoLevels", int> levels;
  gl::Uniform<"albedoRepeats", bool> repeats;
  gl::Uniform<"bump", float> bump;
};

struct ShadeSurface {
  static constexpr auto file = "draw/exact/surface/shade_surface.comp";
  struct Variant {
    ThingVariant thing;
    SurfaceVariant surface;
  };
  TileFields tile = {};
  SceneLight light;
  TriangleSource triangles;
  gl::Uniform<"firstId", unsigned> firstId;
  gl::Uniform<"color", glm::vec3> color;
  gl::Uniform<"material", glm::vec3> material;  ///< material values: roughness, metallic, translucency
  VertexTexels texels;
  gl::In<"palette"> palette;
  gl::In<"vertexTints"> tints;
  gl::In<"owners"> owners = {};  ///< joined surfaces only: index of the owning surface per triangle
  gl::In<"looks"> looks = {};    ///< joined surfaces only: materials of the surfaces
  gl::Uniform<"owner", unsigned> owner = {};
  gl::Uniform<"clear", bool> clear = {};
  SurfaceSeen seen = {};
  SurfaceMaps maps = {};
  FinishValues finish = {};
  GlassSource glass = {};
  SurfaceTexture texture = {};
  SkinValues skin = {};
  gl::In<"skinTexels"> skinTexels = {};
};

namespace {

SurfaceVariant variantOf(const sim::Surface& surface, bool skin) {
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
  const auto looks = [&](scene::Skin::Look look) { return skin && material.skin->look == look; };
  return {
      .doubleSided = surface.doubleSided,
      .translucent = material.translucency > 0,
      .reflective = isReflective(shown) || (finished && (finish.coat > 0 || !finish.metalRough.empty())),
      .palette = !skin && surface.palette != nullptr,
      .counted = surface.arguments != nullptr,
      .textured = textured,
      .grid = laidOn && byUv && grid,
      .triplanar = laidOn && !byUv,
      .bumped = textured && material.bump != 0,
      .skin = skin,
      .joined = false,
      .baseMap = colored,
      .normalMap = finished && !finish.normals.empty(),
      .metalRoughMap = finished && !finish.metalRough.empty(),
      .occlusionMap = finished && !finish.occlusion.empty(),
      .emission = emits,
      .emissionMap = glowMap,
      .coat = finished && finish.coat > 0,
      .sheen = finished && finish.sheen != glm::vec3(0),
      .blended = finished && finish.alpha == scene::Alpha::blend,
      .glass = false,
      .refracted = false,
      .vertexColors = !skin && surface.colors != nullptr,
      .leather = looks(scene::Skin::Look::leather),
      .spots = looks(scene::Skin::Look::spots),
      .cracks = looks(scene::Skin::Look::cracks),
      .map = looks(scene::Skin::Look::map)};
}

/// Returns the variant that shows texture coordinates.
SurfaceVariant uvVariant(const sim::Surface& surface) {
  SurfaceVariant variant{};
  variant.counted = surface.arguments != nullptr;
  variant.grid = surface.normals == nullptr;
  variant.byUv = true;
  return variant;
}

VertexUv uvOf(const sim::Surface& surface) {
  // A surface without coordinates needs some array, which is not used.
  const gl::Texture* uvs = surface.uvs != nullptr ? surface.uvs : surface.normals;
  VertexUv uv{.grid = surface.grid, .perGrid = {}, .perRow = {}, .uvs = orNone(uvs)};
  if (surface.normals != nullptr) return uv;
  uv.perGrid = 1.0F / glm::vec2(surface.grid - 1);
  uv.perRow = 1.0F / static_cast<float>(surface.grid.x);
  return uv;
}

/// Returns the inputs of shaders that map a texture or skin with the given number of repeats.
SurfaceSeen seenOf(const sim::Surface& surface, glm::vec2 repeats) {
  return {.uv = uvOf(surface),
          .textureScale = repeats,
          .model = surface.model,
          .modelScale = std::sqrt(std::max(glm::dot(surface.model[0], surface.model[0]), 1e-30F))};
}

ShadeSurface inputsOf(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn,
                      const SceneLight& light) {
  const sim::Surface& surface = *drawn.surface;
  const scene::Material& material = *surface.material;
  return {.light = light,
          .triangles = raster.source(drawn),
          .firstId = drawn.firstId,
          .color = material.color,
          .material = glm::vec3(material.roughness, material.metallic, material.translucency),
          .texels = vertexTexels(surface),
          .palette = orNone(surface.palette),
          .tints = orNone(surface.colors)};
}

}  // namespace

glm::vec3 absorptionOf(const scene::Finish& finish) {
  glm::vec3 absorbed(0);
  if (finish.thin) return absorbed;
  for (int i = 0; i < 3; ++i)
    absorbed[i] = static_cast<float>(-ieee::log(static_cast<double>(finish.attenuation[i])) /
                                     static_cast<double>(finish.attenuationDistance));
  return absorbed;
}

bool SurfaceShading::textureRepeats(const sim::Surface& surface) {
  return surface.normals != nullptr || glm::vec2(surface.material->textureScale) != glm::vec2(1);
}

scene::Map SurfaceShading::colorMapOf(const scene::Material& material) {
  if (!material.finish.color.empty()) return material.finish.color;
  return {material.texture, nullptr};
}

SurfaceShading::SurfaceShading(const scene::Scene& scene, Lighting lighting)
    : scene_(scene), lighting_(std::move(lighting)), kernels_(lighting_.lights) {
  for (const scene::Object& object : scene.objects)
    if (!object.material.finish.used()) textures_.load(object.material.texture);
}

const gl::Kernel<ShadeSurface>& SurfaceShading::kernel(const SurfaceVariant& surface, bool smooth) {
  ThingVariant thing = showing(lighting_.variant, shown_, smooth);
  if (surface.blended.on || surface.glass.on) {  // shading of layers ignores ambient occlusion and the
                                                 // layers in front (BEHIND)
    thing.shade.occlusion = false;
    thing.shade.behind = false;
  }
  return kernels_.of({.thing = thing, .surface = surface});
}

void SurfaceShading::prepare(const SkinTextures& skins) {
  for (const scene::Object& object : scene_.objects)
    if (object.material.skin)
      if (const SkinTextures::Entry* entry = skins.find(*object.material.skin)) skinTexels_.update(*entry);
}

void SurfaceShading::shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn,
                           const SkinTextures& skins, const ShadedTiles& tiles, int thing,
                           const SceneLight& light) {
  const sim::Surface& surface = *drawn.surface;
  const scene::Material& material = *surface.material;
  const bool smooth = mirrorsScene(surface, skins);
  if (shown_ == shownReflections && !smooth) return;
  const SkinTextures::Entry* skin = material.skin ? skins.find(*material.skin) : nullptr;
  const bool byUv = shown_ == shownUv || shown_ == shownOverlay(scene::Overlay::uv);
  ShadeSurface given = inputsOf(raster, drawn, light);
  if (owner_) {
    given.owner = owner_(material);
    given.clear = !material.skin && material.finish.transmission > 0;
  }
  if (byUv) {
    const bool has = surface.normals == nullptr || surface.uvs != nullptr;
    given.seen = seenOf(surface, glm::vec2(has ? 1 : 0));
    return tiles.shade(thing, kernel(uvVariant(surface), smooth), given);
  }
  if (skin != nullptr)
    laySkin(surface, *skin, given);
  else if (material.finish.used())
    layFinish(surface, given);
  else if (const TexelLists::List* albedo = textures_.load(material.texture))
    layTexture(surface, *albedo, given);
  SurfaceVariant variant = variantOf(surface, skin != nullptr);
  variant.edges = shown_ == shownOverlay(scene::Overlay::wireframe);
  tiles.shade(thing, kernel(variant, smooth), given);
}

void SurfaceShading::shadeGlass(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn,
                                const ShadedTiles& tiles, int thing, const SceneLight& light,
                                const GlassLook& look) {
  const scene::Finish& finish = drawn.surface->material->finish;
  ShadeSurface given = inputsOf(raster, drawn, light);
  layFinish(*drawn.surface, given);
  given.glass = {.glass = glm::vec2(finish.transmission, finish.ior),
                 .absorbed = absorptionOf(finish),
                 .layer = glm::ivec4(finish.thin, look.nearest, !look.last, look.transparent),
                 .behind = look.behind,
                 .nextKeys = look.next->nearKeys(),
                 .nextIds = look.next->numbers()};
  SurfaceVariant variant = variantOf(*drawn.surface, false);
  variant.glass = true;
  variant.refracted = look.refracts && !finish.thin;
  variant.reflective = true;
  tiles.shade(thing, kernel(variant, true), given);
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
                                 int thing, const SceneLight& light) {
  const bool mirror = std::any_of(drawn.begin(), drawn.end(), [](const auto& one) {
    return draw::mirrorsScene(one.surface->material->roughness);
  });
  if (shown_ == shownReflections && !mirror) return;
  SurfaceVariant all = variantOf(*drawn.front().surface, false);
  int triangles = 0;
  for (const TriangleRaster::Drawn& one : drawn) {
    const SurfaceVariant own = variantOf(*one.surface, false);
    all.doubleSided = all.doubleSided.on || own.doubleSided.on;
    all.translucent = all.translucent.on || own.translucent.on;
    all.reflective = all.reflective.on || own.reflective.on;
    triangles += one.maxTriangles;
  }
  all.joined = true;
  all.edges = shown_ == shownOverlay(scene::Overlay::wireframe);
  ShadeSurface given{.light = light,
                     .triangles = raster.wholeSource(),
                     .firstId = drawn.front().firstId,
                     .color = {},
                     .material = {},
                     .texels = {},
                     .palette = {},
                     .tints = {},
                     .owners = joined.owners(),
                     .looks = joined.looks()};
  given.triangles.triangleCount = triangles;
  tiles.shade(thing, kernel(all, mirror), given);
}

void SurfaceShading::layFinish(const sim::Surface& surface, ShadeSurface& given) {
  using Holds = MapTexels::Holds;
  const scene::Material& material = *surface.material;
  const scene::Finish& finish = material.finish;
  given.seen = seenOf(surface, glm::vec2(material.textureScale));
  given.maps = {.color = maps_.place(colorMapOf(material), Holds::color),
                .normal = maps_.place(finish.normals, Holds::numbers),
                .metalRough = maps_.place(finish.metalRough, Holds::numbers),
                .occlusion = maps_.place(finish.occlusion, Holds::numbers),
                .emission = maps_.place(finish.emissionMap, Holds::color),
                .normalStrength = finish.normalStrength,
                .occlusionStrength = finish.occlusionStrength,
                .texels = maps_.texels()};
  given.finish = {.emission = finish.emission * finish.emissionStrength,
                  .coat = glm::vec2(finish.coat, finish.coatRoughness),
                  .sheen = finish.sheen,
                  .sheenRoughness = finish.sheenRoughness,
                  .opacity = finish.opacity};
}

bool SurfaceShading::hasHoles(const sim::Surface& surface) {
  return surface.material->finish.alpha != scene::Alpha::opaque && !colorMapOf(*surface.material).empty();
}

Cutout SurfaceShading::holes(const sim::Surface& surface, float minimum) {
  const scene::Material& material = *surface.material;
  const glm::ivec4 map = maps_.place(colorMapOf(material), MapTexels::Holds::color);
  return {.uv = uvOf(surface),
          .textureScale = glm::vec2(material.textureScale),
          .colorMap = map,
          .opacityLimit = glm::vec2(material.finish.opacity, minimum),
          .texels = maps_.texels()};
}

void SurfaceShading::laySkin(const sim::Surface& surface, const SkinTextures::Entry& entry,
                             ShadeSurface& given) const {
  const scene::Skin& skin = *surface.material->skin;
  const bool byUv = (surface.normals == nullptr || surface.uvs != nullptr) &&
                    skin.projection == scene::Skin::Projection::uv;
  // Triplanar projection uses square cells for fields of any aspect ratio.
  const float shape = static_cast<float>(entry.cells.x) / static_cast<float>(entry.cells.y);
  given.seen = seenOf(surface, {skin.repeats, byUv ? skin.repeats : skin.repeats * shape});
  given.skin = SkinTextures::values(entry, skin);
  given.skinTexels = skinTexels_.find(entry);
}

void SurfaceShading::layTexture(const sim::Surface& surface, const TexelLists::List& albedo,
                                ShadeSurface& given) {
  const scene::Material& material = *surface.material;
  given.seen = seenOf(surface, glm::vec2(material.textureScale));
  given.texture = {.albedo = albedo.view,
                   .size = albedo.size,
                   .levels = albedo.levels,
                   .repeats = textureRepeats(surface),
                   .bump = material.bump};
}

}  // namespace simreel::draw
