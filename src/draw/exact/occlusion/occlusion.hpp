#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

struct HalfNearness;
struct Horizons;
struct SmoothArcs;

/// Computes ambient occlusion in screen space (glsl/draw/exact/occlusion/horizons.glsl) at half resolution.
class Occlusion {
 public:
  /// Number of slices per half-resolution pixel, and of steps per slice on each side of the pixel.
  static constexpr int slices = 2, steps = 5;
  /// Creates an object that computes no occlusion.
  Occlusion() = default;
  /// Prepares for pictures of `size`. `visibility`: a buffer with the pictures' layout, for all rows or one
  /// band. `ground`: true if the ground is drawn.
  Occlusion(glm::ivec2 size, const Visibility& visibility, bool ground);

  [[nodiscard]] bool on() const { return static_cast<bool>(horizons_); }
  /// Nearness of the nearest object in each pixel of the picture, without the ground, row by row from
  /// element `first` of the buffer.
  struct PixelNearness {
    const gl::Buffer* buffer = nullptr;
    int first = 0;
  };
  /// Stores the nearness of a band's visible samples and ground. The uniform blocks of frame and view must
  /// be bound. `pixels`: also receives the nearness of the band's pixels, unless its buffer is null.
  void add(const Visibility& visibility, const shader::ExactView& view, const PixelNearness& pixels) const;
  /// Computes the occlusion after all bands have been added. `radius`: max distance of occluders (m).
  void find(const shader::ExactView& view, float radius) const;
  /// Returns two values per half-resolution pixel, row by row: openness and nearness.
  [[nodiscard]] const gl::Texture& openness() const { return openness_.view; }
  [[nodiscard]] glm::ivec2 size() const { return half_; }
  /// Returns the nearness (1/m) of each half-resolution pixel, row by row. Empty pixels have the value 0.
  [[nodiscard]] const gl::Texture& nearness() const { return nearness_.view; }
  /// Waits for the GPU and returns, row by row, two values per half-resolution pixel: openness from 0 to 1,
  /// and nearness (1/m; 0 if empty).
  [[nodiscard]] std::vector<GLuint> read() const { return openness_.buffer.readAll<GLuint>(); }

 private:
  /// Buffer with one value per half-resolution pixel. Kernels write it as a storage block, because software
  /// drivers write images more slowly.
  struct HalfResolutionBuffer {
    HalfResolutionBuffer() = default;
    HalfResolutionBuffer(const std::string& label, GLenum format, std::size_t bytes, glm::ivec2 size);
    gl::Buffer buffer;
    gl::Texture view;
  };
  glm::ivec2 half_{0};
  gl::Kernel<HalfNearness> nearest_, nearestOfPixels_;
  gl::Kernel<Horizons> horizons_;
  gl::Kernel<SmoothArcs> across_, down_;
  HalfResolutionBuffer nearness_, arcs_, smooth_, openness_;
};

/// Returns the uniforms of Occlusion::find(). x: max distance of occluders (m). y: max distance in the
/// picture (half-resolution pixels). z: half-resolution pixels per metre at depth 1.
[[nodiscard]] glm::vec3 searchLimits(const shader::ExactView& view, float radius);

}  // namespace simreel::draw
