#pragma once
#include "draw/screen/screen_program.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct BrightLight {
  static constexpr auto file = "draw/screen/bloom_first.glsl";
  struct Variant {
    ScreenVariant screen = {};
    gl::Range<"SAMPLES", 1, 64> samples;
  };
  ScreenFields screen = {};
  gl::In<"scene"> light;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"threshold", float> threshold;
};

struct BrightLightDown {
  static constexpr auto file = "draw/screen/bloom_down.glsl";
  struct Variant {
    ScreenVariant screen = {};
  };
  ScreenFields screen = {};
  gl::In<"source"> source;
  gl::Uniform<"texel", glm::vec2> texel;
};

struct BrightLightUp {
  static constexpr auto file = "draw/screen/bloom_up.glsl";
  struct Variant {
    ScreenVariant screen = {};
  };
  ScreenFields screen = {};
  gl::In<"coarse"> coarse;
  gl::In<"fine"> fine;
  gl::Uniform<"coarseTexel", glm::vec2> coarseTexel;
  gl::Uniform<"fraction", glm::vec2> fraction;
};

/// Draws bloom, light that lenses scatter around bright areas. Light above a threshold is downsampled
/// through a chain of smaller textures and upsampled again. If the scene has no bloom, nothing is allocated
/// or run.
class BloomPass {
 public:
  /// `samples`: samples per pixel of the light given to draw().
  BloomPass(const scene::Bloom& bloom, glm::ivec2 size, int samples);
  [[nodiscard]] bool on() const { return on_; }
  /// Returns the scattered light at half the size of `light`, with the same total light. May be called only
  /// if on() is true.
  const gl::Texture& draw(const gl::Texture& light) const;

 private:
  struct Level {
    ScreenTarget down, up;
  };
  bool on_;
  float threshold_;
  float reach_;  ///< number of levels that receive light; the fractional part is the weight of the last
                 ///< level
  ScreenProgram<BrightLight> first_;
  ScreenProgram<BrightLightDown> down_;
  ScreenProgram<BrightLightUp> up_;
  std::vector<Level> levels_;
};

}  // namespace simreel::draw
