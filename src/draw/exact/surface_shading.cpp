#include "draw/exact/surface_shading.hpp"

#include "draw/draw_state.hpp"
#include "draw/surface/surface_pass.hpp"

#include <iterator>

namespace simreel::draw {

namespace {

constexpr const char* featureNames[] = {"DOUBLE_SIDED", "TRANSLUCENT", "REFLECTIVE", "PALETTE", "COUNTED"};

unsigned featuresOf(const sim::Surface& surface) {
  const scene::Material& material = *surface.material;
  const bool wanted[] = {surface.doubleSided, material.translucency > 0, isReflective(material),
                         surface.palette != nullptr, surface.arguments != nullptr};
  unsigned features = 0;
  for (std::size_t i = 0; i < std::size(wanted); ++i) features |= wanted[i] ? 1U << i : 0U;
  return features;
}

}  // namespace

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
  tiles.shade(thing, shader);
}

}  // namespace simreel::draw
