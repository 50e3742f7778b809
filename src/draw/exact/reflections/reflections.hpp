#pragma once
#include "draw/exact/occlusion/occlusion.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <cstddef>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct LevelKernel;
struct SpreadKernel;
struct UnevenKernel;

/// Input of screen-space reflections (glsl/draw/exact/reflections/mirrored_way.glsl): mip pyramids of the
/// picture's light without reflections, and of the picture's nearness. Level 0 has half the picture's size.
/// Behind the pyramid of nearness, its buffer has the nearness of each pixel. The buffers take 12 bytes per
/// pixel of the picture.
class Reflections {
 public:
  /// `ground`: true if the pictures have a ground, which is excluded from nearness. `parallel`: true for
  /// orthographic views. Throws UserError(device) if the buffers exceed a device limit.
  explicit Reflections(glm::ivec2 size, bool ground = false, bool parallel = false);

  /// Builds the pyramids from the light of a whole picture and from Occlusion::nearness().
  void see(const gl::Texture& light, const gl::Texture& nearness) const;
  /// Returns the place for the nearness of each pixel.
  [[nodiscard]] Occlusion::PixelNearness pixelNearness() const;
  /// Return the pyramids of light and nearness, for kernels that include
  /// draw/exact/reflections/reflections_read.glsl.
  [[nodiscard]] const gl::Texture& light() const { return light_.view; }
  [[nodiscard]] const gl::Texture& nearest() const { return nearest_.view; }
  /// Returns the uniform mirrorReach. x: max length of reflected rays (m). y: assumed thickness of
  /// reflected objects (m). `away`: distance (m) from the camera to its target.
  [[nodiscard]] static glm::vec2 reachOf(float away) { return {64 * away, away / 24.0F}; }

 private:
  /// A mip pyramid. Level 0 has one texel per 2x2 pixels.
  struct Levels {
    Levels(const char* label, GLenum format, std::size_t bytes, glm::ivec2 half, std::size_t more);
    gl::Buffer buffer;
    gl::Texture view;
  };

  glm::ivec2 size_;
  Levels light_, nearest_;
  gl::Kernel<LevelKernel> first_, next_;
};

/// Change of each pixel's light by screen-space reflections. Reflections are traced once for 2x2 pixels,
/// and their changes are interpolated between them (glsl/draw/exact/reflections/spread.comp). Where the
/// changes of neighbouring blocks of 2x2 pixels differ visibly, reflections are traced again for each pixel
/// (uneven.comp). Takes 16 bytes per pixel.
class ReflectedChanges {
 public:
  explicit ReflectedChanges(glm::ivec2 size);

  /// Sets all changes to zero.
  void clear() const;
  /// Returns the picture to which kernels with REFLECTED add changes.
  [[nodiscard]] const gl::Texture& changes() const { return changes_; }
  /// Finds the uneven blocks: blocks of 2x2 pixels whose change differs visibly from a neighbour's. Sets
  /// their changes to zero. `light`: the picture's light without reflections.
  void findUneven(const gl::Texture& light) const;
  /// Returns the mask of the uneven blocks per tile, for kernels that include
  /// draw/exact/reflections/refined.glsl.
  [[nodiscard]] const gl::Texture& uneven() const { return uneven_; }
  /// Adds the changes to the light of the picture.
  void spread(const gl::Texture& light) const;

 private:
  gl::Texture changes_;
  gl::Buffer masks_;
  gl::Texture uneven_;
  gl::Kernel<SpreadKernel> kernel_;
  gl::Kernel<UnevenKernel> find_, clear_;
};

}  // namespace simreel::draw
