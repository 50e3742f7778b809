#pragma once
#include "draw/overlay/field_textures.hpp"
#include "draw/surface/number_mips.hpp"
#include "gl/kernel/give.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"

#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace simreel::draw {

struct SkinRelief;
struct SkinColors;

/// Uniforms of glsl/draw/surface/skin_values.glsl, and uniforms of a skin's relief.
struct SkinValues {
  gl::Uniform<"skinThreshold", float> threshold;
  gl::Uniform<"skinLow", glm::vec3> low;
  gl::Uniform<"skinHigh", glm::vec3> high;
  gl::Uniform<"skinRoughness", float> roughness;
  gl::Uniform<"skinDepth", float> depth;
  gl::Uniform<"reliefSize", glm::ivec2> reliefSize;
  gl::Uniform<"reliefLevels", int> reliefLevels;
  gl::Uniform<"skinCells", glm::vec2> cells;
};

/// Textures that skins compute from their fields. All surfaces with the same field, look and threshold
/// share one set.
class SkinTextures {
 public:
  struct Entry {
    gl::Texture relief;                ///< RGBA16F, mip-mapped, repeating;
                                       ///< glsl/draw/surface/skin_relief.comp describes the content
    gl::Texture surroundings;          ///< R16F, mip-mapped, repeating: mean of the values around each
                                       ///< texel
    gl::Texture colors;                ///< RGBA16F, mip-mapped, repeating; only for the look "map"
    float threshold = 0.5F;            ///< threshold as a fraction of the field's range
    glm::ivec2 cells{1, 1};            ///< size of the field in cells
    [[nodiscard]] int levels() const;  ///< returns the number of mip levels of each texture
  };

  /// Compiles the kernels if any material of the scene has a skin. The scene must outlive this object.
  explicit SkinTextures(const scene::Scene& scene);
  /// Updates the textures of all skins of the scene from their fields.
  void update(const FieldTextures& fields);
  /// Updates the textures of one skin.
  void update(const scene::Skin& skin, const FieldTextures::Entry& field);
  /// Returns the textures of a skin, or null if its field was never published.
  [[nodiscard]] const Entry* find(const scene::Skin& skin) const;

  /// Binds the textures and sets the uniforms of glsl/draw/surface/skin.glsl.
  static void bind(const Entry& entry, const scene::Skin& skin, const gl::Program& program);
  [[nodiscard]] static SkinValues values(const Entry& entry, const scene::Skin& skin);

 private:
  using Key = std::tuple<std::string, scene::Skin::Look, std::optional<double>>;
  static Key keyOf(const scene::Skin& skin) { return {skin.field, skin.look, skin.threshold}; }

  const scene::Scene& scene_;
  gl::Kernels<SkinRelief> relief_;
  gl::Kernels<SkinColors> colors_;
  std::map<Key, Entry> entries_;
  NumberMips mips_;
};

}  // namespace simreel::draw
