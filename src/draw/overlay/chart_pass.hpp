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

/// Positions of the parts of a chart in the picture, in whole pixels from the top left corner.
struct ChartLayout {
  glm::ivec4 panel{0};      ///< edges of the panel: left, top, right, bottom
  glm::ivec4 plot{0};       ///< edges of the area of the curves: left, top, right, bottom
  int unit = 1;             ///< width of thin lines (pixels); the size of letters is proportional to it
  bool hasLetters = false;  ///< true if there is room for letters (ChartLabels)
};
[[nodiscard]] ChartLayout chartLayout(const sim::Chart& chart, glm::ivec2 picture);

struct CondenseChart;
struct DrawChart;

/// Draws the curves of charts over the finished picture. ChartLabels draws the letters. A kernel reduces
/// the simulation steps to one value range per pixel column, so a frame takes the same time after a million
/// steps.
class ChartPass {
 public:
  explicit ChartPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}
  /// Draws into the bound framebuffer, over the finished picture. Only for the driver's rasterizer.
  void draw(const sim::Drawables& drawables);
  /// Draws over the finished RGBA8 picture, whose first row is the top row. Only for the exact rasterizer.
  void draw(const sim::Drawables& drawables, const gl::Texture& picture);

 private:
  struct Cached {
    gl::Texture columns;
  };
  /// Prepares the curves. Returns false if there is nothing to draw.
  bool prepare(const sim::Drawables& drawables);
  void compile();
  void condense(const sim::Chart& chart, const ChartLayout& layout, Cached& cached) const;
  void drawCurves(const sim::Chart& chart, const ChartLayout& layout, const Cached& cached) const;

  void drawExactly(const sim::Chart& chart, const ChartLayout& layout, const Cached& cached,
                   const gl::Texture& picture) const;

  glm::ivec2 picture_;
  bool exact_;
  gl::Kernel<CondenseChart> columns_;
  gl::Kernel<DrawChart> exactCurves_;
  gl::Program curves_;
  std::vector<Cached> cached_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
