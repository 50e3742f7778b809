#pragma once
#include "draw/frame_values.hpp"
#include "draw/screen/screen_program.hpp"
#include "draw/screen/targets.hpp"
#include "scene/scene.hpp"

namespace simreel::draw {

/// The frame's values, as large as the C++ struct.
struct FrameBlock : gl::Ambient<"FrameBlock"> {
  static constexpr std::size_t blockBytes = sizeof(shader::Frame);
};

struct ToneMap {
  static constexpr auto file = "draw/screen/tone_map.glsl";
  struct Variant {
    ScreenVariant screen = {};
    gl::Range<"SAMPLES", 1, 64> samples;
    gl::Flag<"BLOOM"> bloom;
  };
  ScreenFields screen = {};
  FrameBlock frame = {};
  gl::In<"scene"> light;
  gl::In<"scattered"> scattered;
  gl::Uniform<"bloomStrength", float> bloomStrength;
};

/// Averages the samples, lays them over the sky, applies exposure, vignette and film curve, and encodes
/// sRGB.
class ToneMapPass {
 public:
  /// `render`: how light becomes a picture. `samples`: of the light that draw() gets.
  ToneMapPass(const scene::Render& render, int samples, bool bloom);
  /// Fills the picture. `glow` times `strength` is added to the light; null without bloom.
  void draw(const gl::Texture& light, const Picture& picture, const gl::Texture* glow,
            float strength) const;

 private:
  ScreenProgram<ToneMap> program_;
};

}  // namespace simreel::draw
