#include "draw/exact/surface_shading.hpp"

#include "draw/draw_state.hpp"
#include "draw/surface/surface_pass.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

constexpr const char* featureNames[] = {"DOUBLE_SIDED", "TRANSLUCENT", "REFLECTIVE", "PALETTE", "COUNTED",
                                        "TEXTURED",     "GRID",        "TRIPLANAR",  "BUMPED"};

unsigned featuresOf(const sim::Surface& surface) {
  const scene::Material& material = *surface.material;
  const bool textured = !material.texture.empty();
  const bool grid = surface.normals == nullptr;
  const bool wanted[] = {surface.doubleSided,
                         material.translucency > 0,
                         isReflective(material),
                         surface.palette != nullptr,
                         surface.arguments != nullptr,
                         textured,
                         textured && grid,
                         textured && !grid && surface.uvs == nullptr,
                         textured && material.bump != 0};
  unsigned features = 0;
  for (std::size_t i = 0; i < std::size(wanted); ++i) features |= wanted[i] ? 1U << i : 0U;
  return features;
}

}  // namespace

SurfaceShading::SurfaceShading(const scene::Scene& scene, gl::Defines defines)
    : defines_(std::move(defines)) {
  for (const scene::Object& object : scene.objects) textures_.load(object.material.texture);
}

const gl::Program& SurfaceShading::program(const sim::Surface& surface) {
  const unsigned features = featuresOf(surface);
  const auto found = programs_.find(features);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = defines_;
  for (std::size_t i = 0; i < std::size(featureNames); ++i)
    if ((features >> i & 1U) != 0) defines.emplace_back(featureNames[i], "1");
  return programs_.emplace(features, gl::Program::compute("draw/exact/shade_surface.comp", defines))
      .first->second;
}

void SurfaceShading::shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn,
                           const ShadedTiles& tiles, int thing) {
  const sim::Surface& surface = *drawn.surface;
  const scene::Material& material = *surface.material;
  const gl::Program& shader = program(surface);
  raster.bind(drawn, shader);
  shader.set("color", material.color);
  shader.set("material", glm::vec3(material.roughness, material.metallic, material.translucency));
  surface.positions->bind(positionUnit);
  if (surface.palette != nullptr) surface.palette->bind(paletteUnit);
  if (const gl::Texture* albedo = textures_.load(material.texture)) setTexture(surface, *albedo, shader);
  tiles.shade(thing, shader);
}

void SurfaceShading::setTexture(const sim::Surface& surface, const gl::Texture& albedo,
                                const gl::Program& shader) {
  const scene::Material& material = *surface.material;
  const bool grid = surface.normals == nullptr;
  const glm::ivec2 size(albedo.width(), albedo.height());
  // A sheet that shows the picture once must not blend its border with the opposite one.
  const bool once = grid && glm::vec2(material.textureScale) == glm::vec2(1);
  shader.set("albedoSize", size);
  shader.set("albedoLevels",
             static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(size.x, size.y)))));
  shader.set("albedoRepeats", static_cast<int>(!once));
  shader.set("textureScale", glm::vec2(material.textureScale));
  shader.set("bump", material.bump);
  shader.set("model", surface.model);
  shader.set("modelScale", std::sqrt(std::max(glm::dot(surface.model[0], surface.model[0]), 1e-30F)));
  albedo.bind(albedoUnit);
  if (grid) {
    shader.set("grid", surface.grid);
    shader.set("perGrid", 1.0F / glm::vec2(surface.grid - 1));
  } else if (surface.uvs != nullptr) {
    surface.uvs->bind(uvUnit);
  }
}

}  // namespace simreel::draw
