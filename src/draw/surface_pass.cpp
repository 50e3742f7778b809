#include "draw/surface_pass.hpp"

#include <iterator>

namespace simreel::draw {

namespace {

constexpr const char* featureNames[] = {"GRID",        "DOUBLE_SIDED", "TEXTURED",
                                        "TRANSLUCENT", "REFLECTIVE",   "DEFORMED"};
enum Feature : unsigned {
  grid = 1,
  doubleSided = 2,
  textured = 4,
  translucent = 8,
  reflective = 16,
  deformed = 32
};

unsigned features(const scene::Material& material) {
  return (material.texture.empty() ? 0U : textured) | (material.translucency > 0 ? translucent : 0U) |
         (isReflective(material) ? reflective : 0U);
}

}  // namespace

bool isReflective(const scene::Material& material) {
  constexpr float mattRoughness = 0.6F;  // rougher dielectrics mirror too little
  return material.metallic > 0 || material.roughness < mattRoughness;
}

SurfacePass::SurfacePass(const scene::Scene& scene, const ShadowPass& shadow)
    : shadowDefines_(shadow.defines()) {
  for (const scene::Object& object : scene.objects) {
    textures_.load(object.material.texture);
    // Whether a simulation publishes a grid or a solid mesh is not known yet; both are common.
    program(features(object.material) | grid | doubleSided);
    program(features(object.material));
  }
}

const gl::Program& SurfacePass::program(unsigned wanted) {
  const auto found = programs_.find(wanted);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = shadowDefines_;
  for (unsigned i = 0; i < std::size(featureNames); ++i)
    if ((wanted >> i & 1U) != 0) defines.emplace_back(featureNames[i], "1");
  return programs_.emplace(wanted, gl::Program::graphics("draw/surface.vert", "draw/surface.frag", defines))
      .first->second;
}

void SurfacePass::draw(const sim::Drawables& drawables) {
  for (const sim::Surface& surface : drawables.surfaces) draw(surface);
}

void SurfacePass::draw(const sim::Surface& surface) {
  const scene::Material& material = *surface.material;
  const bool isGrid = surface.normals == nullptr;
  const gl::Program& shader =
      program(features(material) | (isGrid ? grid : 0U) | (surface.doubleSided ? doubleSided : 0U) |
              (surface.deform != nullptr ? deformed : 0U));
  DrawState{.depthTest = true, .cullBack = !surface.doubleSided, .depthOffset = false}.set();
  shader.use();
  shader.set("model", surface.model);
  shader.set("color", material.color);
  shader.set("roughness", material.roughness);
  shader.set("metallic", material.metallic);
  shader.set("translucency", material.translucency);
  shader.set("textureScale", glm::vec2(material.textureScale));
  surface.positions->bind(positionUnit);
  bindDeformation(surface);
  if (isGrid) {
    shader.set("grid", surface.grid);
  } else {
    surface.normals->bind(normalUnit);
    surface.uvs->bind(uvUnit);
  }
  if (const gl::Texture* albedo = textures_.load(material.texture)) {
    // A sheet that shows the picture once must not blend its border with the opposite one.
    const bool once = isGrid && glm::vec2(material.textureScale) == glm::vec2(1);
    albedo->wrap(once ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    albedo->bind(albedoUnit);
  }
  vertices_.bind(*surface.indices);
  glDrawElements(GL_TRIANGLES, surface.indexCount, GL_UNSIGNED_INT, nullptr);
}

}  // namespace simreel::draw
