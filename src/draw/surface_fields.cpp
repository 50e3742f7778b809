#include "draw/surface_fields.hpp"

namespace simreel::draw {

VertexTexels vertexTexels(const sim::Surface& surface) {
  const sim::GridHeights* heights = surface.heights;
  const bool colored = heights != nullptr && heights->colors != nullptr;
  VertexTexels all{.positions = orNone(surface.positions),
                   .heightShape = glm::ivec4(0),
                   .heightGrid = glm::vec4(0),
                   .heightRim = 0.0F,
                   .colors = orNone(colored ? heights->colors : surface.positions),
                   .colorComponent = colored ? 0 : 3};
  if (heights == nullptr) return all;
  all.heightShape = glm::ivec4(surface.grid, heights->component, heights->walls);
  all.heightGrid = glm::vec4(heights->corner, heights->cell, heights->base);
  all.heightRim = heights->rim;
  return all;
}

PlacedSurface placed(const sim::Surface& surface) {
  return {.texels = vertexTexels(surface),
          .deform = orNone(surface.deform),
          .trail = orNone(surface.trail),
          .model = surface.model};
}

WorldVertices worldVertices(const sim::Surface& surface) {
  return {.placed = placed(surface), .grid = surface.grid, .normals = orNone(surface.normals)};
}

MaterialFields materialFields(const scene::Material& material) {
  return {.roughness = material.roughness,
          .metallic = material.metallic,
          .translucency = material.translucency};
}

WorldVariant worldVariant(const sim::Surface& surface) {
  return {.grid = surface.normals == nullptr, .deformed = surface.deform != nullptr};
}

}  // namespace simreel::draw
