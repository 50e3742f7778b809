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

/// How much of the surroundings' light gets to what a picture shows, by what the picture shows around it
/// (glsl/draw/exact/occlusion/horizons.glsl): at half its size.
class Occlusion {
 public:
  /// Slices a half pixel, and steps of each to either side.
  static constexpr int slices = 2, steps = 5;
  /// None.
  Occlusion() = default;
  /// Of pictures of which `visibility` holds all rows, or a band of them. `ground`: it is drawn.
  Occlusion(glm::ivec2 size, const Visibility& visibility, bool ground);

  [[nodiscard]] bool on() const { return static_cast<bool>(horizons_); }
  /// Takes over how near things are in the band that is visible, and the ground. The frame's uniform block
  /// and the view's are bound.
  void add(const Visibility& visibility, const shader::ExactView& view) const;
  /// Once all of the picture is there. `radius`: how far away what counts may be (m).
  void find(const shader::ExactView& view, float radius) const;
  /// Openness and nearness of half pixels, row by row.
  [[nodiscard]] const gl::Texture& openness() const { return openness_.view; }
  [[nodiscard]] glm::ivec2 size() const { return half_; }
  /// Of half pixels (1/m), row by row; 0 where nothing is.
  [[nodiscard]] const gl::Texture& nearness() const { return nearness_.view; }
  /// Waits for the device and copies out, row by row: openness, from 0 to 1, and nearness (1/m), 0 where
  /// nothing is, of each half pixel.
  [[nodiscard]] std::vector<GLuint> read() const { return openness_.buffer.readAll<GLuint>(); }

 private:
  /// Of each half pixel: kernels store it as a block, which software drivers do faster than into an image.
  struct Kept {
    Kept() = default;
    Kept(const std::string& label, GLenum format, std::size_t bytes, glm::ivec2 size);
    gl::Buffer buffer;
    gl::Texture view;
  };
  glm::ivec2 half_{0};
  gl::Kernel<HalfNearness> nearest_;
  gl::Kernel<Horizons> horizons_;
  gl::Kernel<SmoothArcs> across_, down_;
  Kept nearness_, arcs_, smooth_, openness_;
};

/// What Occlusion::find() tells the kernel: how far away what counts may be (m), at most (half pixels), and
/// half pixels a metre at depth 1.
[[nodiscard]] glm::vec3 reachOnPicture(const shader::ExactView& view, float radius);

}  // namespace simreel::draw
