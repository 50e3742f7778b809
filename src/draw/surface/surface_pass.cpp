#include "draw/surface/surface_pass.hpp"

#include "draw/frame_values.hpp"
#include "draw/surface/skin_look.hpp"
#include "draw/surface_fields.hpp"
#include "gl/kernel/give.hpp"

#include <iterator>

namespace simreel::draw {

namespace {

constexpr const char* featureNames[] = {"GRID",       "DOUBLE_SIDED", "TEXTURED",     "TRANSLUCENT",
                                        "REFLECTIVE", "SKIN_UV",      "TRIPLANAR",    "DEFORMED",
                                        "PALETTE",    "BUMPED",       "VERTEX_COLORS"};
enum Feature : unsigned {
  grid = 1,
  doubleSided = 2,
  textured = 4,
  translucent = 8,
  reflective = 16,
  skinUv = 32,
  triplanar = 64,
  deformed = 128,
  palette = 256,
  bumped = 512,
  vertexColors = 1024,
  lookShift = 11  ///< bit offset of the skin's look
};

constexpr float mattRoughness = 0.6F;  // dielectrics rougher than this have no visible reflections

unsigned features(const scene::Material& material) {
  return (material.texture.empty() ? 0U : textured) | (material.translucency > 0 ? translucent : 0U) |
         (isReflective(material) ? reflective : 0U) |
         (!material.texture.empty() && material.bump != 0 ? bumped : 0U);
}

unsigned skinFeatures(const scene::Material& material, bool hasUvs) {
  const scene::Skin& skin = *material.skin;
  scene::Material skinned = material;
  skinned.texture.clear();
  skinned.roughness = lookOf(skin).roughness;
  const bool byUv = hasUvs && skin.projection == scene::Skin::Projection::uv;
  return features(skinned) | (byUv ? skinUv : triplanar) | static_cast<unsigned>(skin.look) << lookShift;
}

}  // namespace

bool isReflective(const scene::Material& material) {
  return material.metallic > 0 || material.roughness < mattRoughness;
}

bool isReflective(const scene::Ground& ground) {
  return ground.roughness < mattRoughness;
}

SurfacePass::SurfacePass(const scene::Scene& scene, const ShadowPass& shadow, const Lamps& lamps)
    : defines_(withFrame(shadow.defines())) {
  defines_.insert(defines_.end(), lamps.defines().begin(), lamps.defines().end());
  for (const scene::Object& object : scene.objects) {
    textures_.load(object.material.texture);
    // Compiles the variants for grids and for solid meshes, because the kind of surface is not known yet
    // and both are common.
    const unsigned wanted =
        object.material.skin ? skinFeatures(object.material, true) : features(object.material);
    program(wanted | grid | doubleSided);
    program(wanted);
  }
}

const gl::Program& SurfacePass::program(unsigned wanted) {
  const auto found = programs_.find(wanted);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = defines_;
  for (unsigned i = 0; i < std::size(featureNames); ++i)
    if ((wanted >> i & 1U) != 0) defines.emplace_back(featureNames[i], "1");
  if ((wanted & (skinUv | triplanar)) != 0 && (wanted & textured) == 0) {
    scene::Skin skin;
    skin.look = static_cast<scene::Skin::Look>(wanted >> lookShift);
    defines.emplace_back("SKIN", "1");
    defines.emplace_back(lookOf(skin).define, "1");
  }
  return programs_
      .emplace(wanted,
               gl::Program::graphics("draw/surface/surface.vert", "draw/surface/surface.frag", defines))
      .first->second;
}

void SurfacePass::draw(const sim::Drawables& drawables, const SkinTextures& skins) {
  for (const sim::Surface& surface : drawables.surfaces) draw(surface, skins);
}

void SurfacePass::draw(const sim::Surface& surface, const SkinTextures& skins) {
  const scene::Material& material = *surface.material;
  const bool isGrid = surface.normals == nullptr;
  const SkinTextures::Entry* skin = material.skin ? skins.find(*material.skin) : nullptr;
  const unsigned look =
      skin == nullptr ? features(material) : skinFeatures(material, isGrid || surface.uvs != nullptr);
  const bool hasUvs = isGrid || surface.uvs != nullptr;
  const gl::Program& shader =
      program(look | (!hasUvs && (look & textured) != 0 ? triplanar : 0U) | (isGrid ? grid : 0U) |
              (surface.doubleSided ? doubleSided : 0U) | (surface.deform != nullptr ? deformed : 0U) |
              (surface.palette != nullptr && skin == nullptr ? palette : 0U) |
              (surface.colors != nullptr && skin == nullptr ? vertexColors : 0U));
  DrawState{.depthTest = true, .cullBack = !surface.doubleSided, .depthOffset = false}.set();
  gl::give(shader, worldVertices(surface));
  gl::give(shader, materialFields(material));
  if (surface.palette != nullptr) surface.palette->bind(paletteUnit);
  if (surface.colors != nullptr) surface.colors->bind(paletteUnit);
  if (surface.uvs != nullptr) surface.uvs->bind(uvUnit);
  if (skin != nullptr)
    setSkin(*skin, *material.skin, shader);
  else
    setPlain(material, isGrid, shader);
  shader.use();
  vertices_.bind(*surface.indices);
  drawTriangles(surface);
}

void SurfacePass::setPlain(const scene::Material& material, bool isGrid, const gl::Program& shader) {
  shader.set("color", material.color);
  shader.set("textureScale", glm::vec2(material.textureScale));
  shader.set("perMetre", glm::vec2(material.textureScale));
  shader.set("bump", material.bump);
  if (const gl::Texture* albedo = textures_.load(material.texture)) {
    // On a sheet that shows an image exactly once, opposite borders must not blend.
    const bool once = isGrid && glm::vec2(material.textureScale) == glm::vec2(1);
    albedo->wrap(once ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    albedo->bind(albedoUnit);
  }
}

void SurfacePass::setSkin(const SkinTextures::Entry& entry, const scene::Skin& skin,
                          const gl::Program& shader) {
  SkinTextures::bind(entry, skin, shader);
  shader.set("textureScale", glm::vec2(skin.repeats));
  // Triplanar projection uses square cells for fields of any aspect ratio.
  const float shape = static_cast<float>(entry.cells.x) / static_cast<float>(entry.cells.y);
  shader.set("skinRepeats", glm::vec2(skin.repeats, skin.repeats * shape));
}

}  // namespace simreel::draw
