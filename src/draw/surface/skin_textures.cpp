#include "draw/surface/skin_textures.hpp"

#include "draw/draw_state.hpp"
#include "draw/surface/skin_look.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>

namespace simreel::draw {

struct SkinRelief {
  static constexpr auto file = "draw/surface/skin_relief.comp";
  struct Variant {
    gl::Flag<"COLORED"> colored;
  };
  gl::In<"field"> field;
  gl::Out<"relief"> relief;
  gl::Out<"around"> around;
  gl::Uniform<"texels", glm::ivec2> texels;
  gl::Uniform<"rangeLow", float> rangeLow;
  gl::Uniform<"rangeFactor", float> rangeFactor;
  gl::Uniform<"threshold", float> threshold;
  gl::Uniform<"texelCells", float> texelCells;
};

struct SkinColors {
  static constexpr auto file = "draw/surface/skin_colors.comp";
  using Variant = SkinRelief::Variant;
  gl::In<"field"> field;
  gl::In<"stops"> stops;
  gl::Uniform<"stopCount", int> stopCount;
  gl::Out<"colors"> colors;
  gl::Uniform<"texels", glm::ivec2> texels;
  gl::Uniform<"rangeLow", float> rangeLow;
  gl::Uniform<"rangeFactor", float> rangeFactor;
};

namespace {

gl::Texture emptyTexture(const std::string& label, GLenum format, int width, int height) {
  gl::Texture texture = gl::Texture::image(label, format, width, height, 0);
  texture.wrap(GL_REPEAT);
  // As for texture files, software drivers use no anisotropic filtering, because it is too slow there.
  const float anisotropy = std::min(gl::limits().anisotropy, gl::softwareDriver() ? 1.0F : 8.0F);
  if (anisotropy > 1.0F) glTextureParameterf(texture.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
  return texture;
}

}  // namespace

SkinTextures::SkinTextures(const scene::Scene& scene) : scene_(scene) {}

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
  const glm::vec2 range = field.colored ? glm::vec2(0, 1) : field.range;
  const float factor = 1.0F / (range.y == range.x ? 1.0F : range.y - range.x);
  const glm::ivec2 texels(width, height);
  gl::barrier();  // waits until kernels have written the field
  relief_.of({.colored = field.colored})
      .dispatch(texels, {.field = field.texture,
                         .relief = entry.relief,
                         .around = entry.surroundings,
                         .texels = texels,
                         .rangeLow = range.x,
                         .rangeFactor = factor,
                         .threshold = entry.threshold,
                         .texelCells = static_cast<float>(std::max(field.reduction, 1))});
  mips_.make(entry.relief, GL_RGBA16F);
  mips_.make(entry.surroundings, GL_R16F);
  if (own) {
    colors_.of({.colored = field.colored})
        .dispatch(texels, {.field = field.texture,
                           .stops = field.stops,
                           .stopCount = field.stopCount,
                           .colors = entry.colors,
                           .texels = texels,
                           .rangeLow = range.x,
                           .rangeFactor = factor});
    mips_.make(entry.colors, GL_RGBA16F);
  }
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
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
  gl::give(program, values(entry, skin));
}

SkinValues SkinTextures::values(const Entry& entry, const scene::Skin& skin) {
  const SkinLook look = lookOf(skin);
  return {.threshold = entry.threshold,
          .low = look.low,
          .high = look.high,
          .roughness = look.roughness,
          .depth = look.depth,
          .reliefSize = glm::ivec2(entry.relief.width(), entry.relief.height()),
          .reliefLevels = entry.levels(),
          .cells = glm::vec2(entry.cells)};
}

}  // namespace simreel::draw
