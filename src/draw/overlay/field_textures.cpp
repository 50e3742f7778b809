#include "draw/overlay/field_textures.hpp"

#include "gl/limits.hpp"

#include <algorithm>
#include <bit>

namespace simreel::draw {

FieldTextures::FieldTextures(const scene::Scene& scene, Rasterizer rasterizer)
    : exact_(rasterizer == Rasterizer::exact) {
  for (const scene::Object& object : scene.objects)
    if (object.material.skin) wanted_.insert(object.material.skin->field);
  // The texture has four texels per pixel of the picture's longer side, so that skins are sharp in
  // close-ups.
  const glm::ivec2 picture = scene.render.size;
  const auto fine = std::bit_ceil(static_cast<unsigned>(4 * std::max({picture.x, picture.y, 1})));
  maxSide_ = std::min({static_cast<int>(fine), 4096, gl::limits().textureSize});
}

void FieldTextures::update(const sim::Drawables& drawables) {
  for (const sim::Field& field : drawables.fields) {
    if (field.name == nullptr || !wanted_.contains(*field.name)) continue;
    Entry& entry = entries_[*field.name];
    entry.update(*field.colors);
    entry.range = field.range;
    if (entry.cells != field.size || entry.colored != field.categories || !entry.texture) {
      const int side = std::max(field.size.x, field.size.y);
      entry.cells = field.size;
      entry.colored = field.categories;
      entry.reduction = std::clamp((side + maxSide_ - 1) / maxSide_, 1, FieldKernel::maxReduction);
      entry.texture = FieldKernel::texture(field, entry.reduction, entry.colored, exact_ ? 1 : 0);
    }
    kernel_.average(field, entry, entry.texture, entry.colored);
    if (!exact_) glGenerateTextureMipmap(entry.texture.name());
  }
}

const FieldTextures::Entry* FieldTextures::find(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

}  // namespace simreel::draw
