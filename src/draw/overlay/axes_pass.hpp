#pragma once
#include "draw/draw_state.hpp"
#include "draw/overlay/box_kernel.hpp"
#include "draw/overlay/chart_labels.hpp"
#include "draw/rasterizer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// A tick of an axis, with the position between the axis ends (0 to 1) and the label.
struct Tick {
  double place;
  std::string label;
};
/// Returns ticks at round numbers between `first` and `last`. Their number exceeds `max` only slightly, if
/// at all. `first` may be greater than `last`.
[[nodiscard]] std::vector<Tick> ticksBetween(double first, double last, int max);

/// Draws the axes of fields (FieldDisplay::Axis) next to the fields, over the finished picture. Draws the
/// background and the ticks. The renderer draws the letters together with other texts.
class AxesPass {
 public:
  explicit AxesPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}
  /// Draws into the bound framebuffer, over the finished picture. Only for the driver's rasterizer.
  void draw(const sim::Drawables& drawables, double seconds);
  /// Draws over the finished RGBA8 picture, whose first row is the top row. Only for the exact rasterizer.
  void draw(const sim::Drawables& drawables, double seconds, const gl::Texture& picture);
  /// Returns the letters of all axes, for TextPass. The result is valid until the next call.
  [[nodiscard]] std::vector<sim::Writing> letters(const sim::Drawables& drawables, double seconds);

 private:
  /// Returns the rectangles of all fields, each followed by its colour.
  [[nodiscard]] std::vector<glm::vec4> boxesOf(const sim::Drawables& drawables, double seconds) const;

  glm::ivec2 picture_;
  bool exact_;
  BoxList list_;
  gl::Program program_;
  gl::Buffer buffer_;
  gl::Texture view_;
  LabelWords words_;
  std::vector<glm::vec4> present_;  ///< rectangles that the buffer holds
  VertexArray vertices_;
};

}  // namespace simreel::draw
