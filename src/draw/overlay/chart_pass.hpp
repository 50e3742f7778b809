#pragma once
#include "draw/draw_state.hpp"
#include "draw/overlay/box_kernel.hpp"
#include "draw/rasterizer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Position of the parts of a chart in a picture, in whole pixels from the top left.
struct ChartLayout {
  glm::ivec4 panel{0};      ///< edges of the panel: left, top, right, bottom
  glm::ivec4 plot{0};       ///< area of the curves; same order
  int unit = 1;             ///< width of thin lines (pixels); letters scale with it
  bool hasLetters = false;  ///< true if there is room for letters (ChartLabels)
};
[[nodiscard]] ChartLayout chartLayout(const sim::Chart& chart, glm::ivec2 picture);

struct CondenseChart;
struct DrawChart;

/// Draws curves of counts over the finished picture, without letters. A kernel reduces the steps to columns
/// of pixels, so a frame takes the same time after a million steps.
class ChartPass {
 public:
  explicit ChartPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}
  /// driver: draws into the bound framebuffer, over the finished picture.
  void draw(const sim::Drawables& drawables);
  /// exact: draws over the finished RGBA8 picture, whose first row is the top row.
  void draw(const sim::Drawables& drawables, const gl::Texture& picture);

 private:
  struct Kept {
    gl::Texture columns;
  };
  /// Returns false if there is nothing to draw.
  bool prepare(const sim::Drawables& drawables);
  void compile();
  void condense(const sim::Chart& chart, const ChartLayout& layout, Kept& kept) const;
  void drawCurves(const sim::Chart& chart, const ChartLayout& layout, const Kept& kept) const;

  void drawExactly(const sim::Chart& chart, const ChartLayout& layout, const Kept& kept,
                   const gl::Texture& picture) const;

  glm::ivec2 picture_;
  bool exact_;
  gl::Kernel<CondenseChart> columns_;
  gl::Kernel<DrawChart> exactCurves_;
  gl::Program curves_;
  std::vector<Kept> kept_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
