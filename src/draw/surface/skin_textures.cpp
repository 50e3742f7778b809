#include "draw/surface/skin_textures.hpp"

#include "draw/draw_state.hpp"
#include "draw/surface/skin_look.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>

namespace simreel::draw {

namespace {

constexpr const char* reliefPath = "draw/surface/skin_relief.comp";
constexpr const char* colorsPath = "draw/surface/skin_colors.comp";

gl::Texture emptyTexture(const std::string& label, GLenum format, int width, int height) {
  gl::Texture texture = gl::Texture::image(label, format, width, height, 0);
  texture.wrap(GL_REPEAT);
  // As texture files are read: software drivers filter anisotropically at too high a price.
  const float anisotropy = std::min(gl::limits().anisotropy, gl::softwareDriver() ? 1.0F : 8.0F);
  if (anisotropy > 1.0F) glTextureParameterf(texture.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
  return texture;
}

}  // namespace

SkinTextures::SkinTextures(const scene::Scene& scene) : scene_(scene) {
  for (const scene::Object& object : scene.objects) {
    if (!object.material.skin) continue;
    kernel(reliefPath, false);
    if (object.material.skin->look == scene::Skin::Look::map) kernel(colorsPath, false);
  }
}

void SkinTextures::update(const FieldTextures& fields) {
  for (const scene::Object& object : scene_.objects) {
    if (!object.material.skin) continue;
    const scene::Skin& skin = *object.material.skin;
    if (const FieldTextures::Entry* field = fields.find(skin.field)) update(skin, *field);
  }
}

void SkinTextures::update(const scene::Skin& skin, const FieldTextures::Entry& field) {
  Entry& entry = entries_[keyOf(skin)];
  const int width = field.texture.width();
  const int height = field.texture.height();
  const bool own = skin.look == scene::Skin::Look::map;
  if (!entry.relief || entry.relief.width() != width || entry.relief.height() != height) {
    entry.relief = emptyTexture("relief of " + skin.field, GL_RGBA16F, width, height);
    entry.surroundings = emptyTexture("surroundings of " + skin.field, GL_R16F, width, height);
    if (own) entry.colors = emptyTexture("colours of " + skin.field, GL_RGBA16F, width, height);
  }
  entry.threshold = thresholdFraction(skin, field.range);
  entry.cells = field.cells;
  run(reliefPath, field, entry);
  if (own) run(colorsPath, field, entry);
}

void SkinTextures::run(const char* path, const FieldTextures::Entry& field, const Entry& entry) {
  const glm::vec2 range = field.colored ? glm::vec2(0, 1) : field.range;
  const bool ownColors = path == colorsPath;
  const gl::Texture& result = ownColors ? entry.colors : entry.relief;
  const gl::Program& program = kernel(path, field.colored);
  field.texture.bindImage(fieldImage, GL_READ_ONLY);
  result.bindImage(ownColors ? skinColorImage : reliefImage, GL_WRITE_ONLY);
  if (!ownColors) entry.surroundings.bindImage(surroundingsImage, GL_WRITE_ONLY);
  if (ownColors && !field.colored) field.stops.bind(stopUnit);
  program.set("texels", glm::ivec2(result.width(), result.height()));
  program.set("rangeLow", range.x);
  program.set("rangeFactor", 1.0F / (range.y == range.x ? 1.0F : range.y - range.x));
  program.set("threshold", entry.threshold);
  program.set("texelCells", static_cast<float>(std::max(field.reduction, 1)));
  program.set("stopCount", field.stopCount);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  program.dispatch(result.width(), result.height());
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_FRAMEBUFFER_BARRIER_BIT);
  mips_.make(result, GL_RGBA16F);
  if (!ownColors) mips_.make(entry.surroundings, GL_R16F);
}

int SkinTextures::Entry::levels() const {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(relief.width(), relief.height()))));
}

const SkinTextures::Entry* SkinTextures::find(const scene::Skin& skin) const {
  const auto found = entries_.find(keyOf(skin));
  return found == entries_.end() ? nullptr : &found->second;
}

void SkinTextures::bind(const Entry& entry, const scene::Skin& skin, const gl::Program& program) {
  entry.relief.bind(reliefUnit);
  entry.surroundings.bind(surroundingsUnit);
  if (entry.colors) entry.colors.bind(skinColorUnit);
  set(entry, skin, program);
}

void SkinTextures::set(const Entry& entry, const scene::Skin& skin, const gl::Program& program) {
  const SkinLook look = lookOf(skin);
  program.set("skinThreshold", entry.threshold);
  program.set("skinLow", look.low);
  program.set("skinHigh", look.high);
  program.set("skinRoughness", look.roughness);
  program.set("skinDepth", look.depth);
  const glm::ivec2 size(entry.relief.width(), entry.relief.height());
  program.set("reliefSize", size);
  program.set("reliefLevels", entry.levels());
  program.set("skinCells", glm::vec2(entry.cells));
}

const gl::Program& SkinTextures::kernel(const char* path, bool colored) {
  const std::pair<std::string, bool> key{path, colored};
  const auto found = kernels_.find(key);
  if (found != kernels_.end()) return found->second;
  gl::Defines defines;
  if (colored) defines.emplace_back("COLORED", "1");
  return kernels_.emplace(key, gl::Program::compute(path, defines)).first->second;
}

}  // namespace simreel::draw
