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

/// Where the parts of a chart lie in a picture: whole pixels from the top left.
struct ChartLayout {
  glm::ivec4 panel{0};      ///< left, top, right, bottom
  glm::ivec4 plot{0};       ///< the same, of the curves
  int unit = 1;             ///< thickness of thin lines (pixels), which letters grow with
  bool hasLetters = false;  ///< whether there is room for them (ChartLabels)
};
[[nodiscard]] ChartLayout chartLayout(const sim::Chart& chart, glm::ivec2 picture);

struct CondenseChart;
struct DrawChart;

/// Draws curves of counts over the finished picture, without letters. A kernel condenses the steps to
/// columns of pixels, so a frame costs the same after a million steps.
class ChartPass {
 public:
  explicit ChartPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}
  /// driver: into the bound framebuffer, the finished picture.
  void draw(const sim::Drawables& drawables);
  /// exact: over the finished picture, RGBA8, its first row the top one.
  void draw(const sim::Drawables& drawables, const gl::Texture& picture);

 private:
  struct Kept {
    gl::Texture columns;
  };
  /// False: nothing to draw.
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
