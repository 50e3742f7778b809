#pragma once
#include "draw/draw_state.hpp"
#include "draw/overlay/box_kernel.hpp"
#include "draw/rasterizer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// A number of a scale: where it lies between the scale's ends, 0 to 1, and how it is written.
struct Tick {
  double place;
  std::string label;
};
/// Round numbers between `first` and `last`, which may fall; about `most` of them at most.
[[nodiscard]] std::vector<Tick> ticksBetween(double first, double last, int max);

/// Draws the scales of fields (FieldDisplay::Axis) beside them, over the finished picture.
class AxesPass {
 public:
  explicit AxesPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}
  /// driver: into the bound framebuffer, the finished picture.
  void draw(const sim::Drawables& drawables, double seconds);
  /// exact: over the finished picture, RGBA8, its first row the top one.
  void draw(const sim::Drawables& drawables, double seconds, const gl::Texture& picture);

 private:
  /// Appends rectangles and their colours for one field.
  void append(const sim::Field& field, double seconds, std::vector<glm::vec4>& boxes) const;

  /// The rectangles of all fields.
  [[nodiscard]] std::vector<glm::vec4> boxesOf(const sim::Drawables& drawables, double seconds) const;

  glm::ivec2 picture_;
  bool exact_;
  BoxList list_;
  gl::Program program_;
  gl::Buffer buffer_;
  gl::Texture view_;
  std::vector<glm::vec4> present_;  ///< what the buffer holds
  VertexArray vertices_;
};

}  // namespace simreel::draw
