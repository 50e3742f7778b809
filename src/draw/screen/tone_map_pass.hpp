#pragma once
#include "draw/frame_values.hpp"
#include "draw/screen/screen_program.hpp"
#include "draw/screen/targets.hpp"
#include "scene/scene.hpp"

namespace simreel::draw {

/// Uniform block of the frame's values. Its size is the size of the C++ struct.
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

/// Averages the samples, composites them over the sky, applies exposure, vignette and film curve, and
/// encodes sRGB.
class ToneMapPass {
 public:
  /// `render`: settings for the conversion of light to pictures. `samples`: samples per pixel of the light
  /// given to draw().
  ToneMapPass(const scene::Render& render, int samples, bool bloom);
  /// Writes the picture. Adds `strength` times the bloom texture `glow`, or nothing if `glow` is null.
  void draw(const gl::Texture& light, const Picture& picture, const gl::Texture* glow,
            float strength) const;

 private:
  ScreenProgram<ToneMap> program_;
};

}  // namespace simreel::draw
