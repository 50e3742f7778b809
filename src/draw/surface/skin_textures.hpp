#pragma once
#include "draw/overlay/field_textures.hpp"
#include "draw/surface/number_mips.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"

#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace simreel::draw {

/// What skins read of their fields, one set for all surfaces with the same field, look and threshold.
class SkinTextures {
 public:
  struct Entry {
    gl::Texture relief;  ///< RGBA16F, mip-mapped, repeating: what glsl/draw/surface/skin_relief.comp says
    gl::Texture surroundings;          ///< R16F of the same kind: mean around
    gl::Texture colors;                ///< RGBA16F, mip-mapped, repeating; of the look "map" only
    float threshold = 0.5F;            ///< fraction of the field's range
    glm::ivec2 cells{1, 1};            ///< of the field
    [[nodiscard]] int levels() const;  ///< of each texture
  };

  /// Compiles the kernels if any material of the scene has a skin. The scene must outlive it.
  explicit SkinTextures(const scene::Scene& scene);
  /// Brings the textures of all skins of the scene up to date with their fields.
  void update(const FieldTextures& fields);
  /// The same for one skin.
  void update(const scene::Skin& skin, const FieldTextures::Entry& field);
  /// Null when the skin's field was never published.
  [[nodiscard]] const Entry* find(const scene::Skin& skin) const;

  /// Binds what glsl/draw/surface/skin.glsl reads and sets its uniforms.
  static void bind(const Entry& entry, const scene::Skin& skin, const gl::Program& program);
  /// Sets its uniforms only.
  static void set(const Entry& entry, const scene::Skin& skin, const gl::Program& program);

 private:
  using Key = std::tuple<std::string, scene::Skin::Look, std::optional<double>>;
  static Key keyOf(const scene::Skin& skin) { return {skin.field, skin.look, skin.threshold}; }
  const gl::Program& kernel(const char* path, bool colored);
  void run(const char* path, const FieldTextures::Entry& field, const Entry& entry);

  const scene::Scene& scene_;
  std::map<std::pair<std::string, bool>, gl::Program> kernels_;
  std::map<Key, Entry> entries_;
  NumberMips mips_;
};

}  // namespace simreel::draw
