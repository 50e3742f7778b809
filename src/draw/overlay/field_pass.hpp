#pragma once
#include "draw/draw_state.hpp"
#include "draw/overlay/field_kernel.hpp"
#include "draw/overlay/field_view.hpp"
#include "draw/rasterizer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"
#include "sim/grid/field_display.hpp"

#include <map>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// A field and its place on the picture: fields of glsl/draw/overlay/field_view.glsl, too.
struct ShownField {
  FieldInputs field;
  gl::In<"reduced"> reduced;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"base", glm::ivec2> base;
  gl::Uniform<"start", glm::vec2> start;
  gl::Uniform<"perPixel", glm::vec2> perPixel;
  gl::Uniform<"slope", glm::vec2> slope;
  gl::Uniform<"border", glm::vec3> border;
  gl::Uniform<"opacity", float> opacity;
};
struct FieldDrawVariant {
  FieldVariant field;
  gl::Flag<"REDUCED"> reduced;
  gl::Flag<"OVER"> over;
  gl::Flag<"OPAQUE"> opaque;
  gl::Flag<"MAGNIFIED"> magnified;
  gl::Flag<"SMOOTH_COLORS"> smoothColors;
  gl::Flag<"TILED"> tiled;
  gl::Flag<"RELIEF"> relief;
  gl::Range<"ROWS", 1, 8> rows = {};  ///< of the exact rasterizer
};

struct DrawField;

/// Lays fields over the picture, or behind everything drawn. Cells are read straight from the simulation's
/// memory; where four or more lie under a pixel, a kernel averages blocks of them first.
class FieldPass {
 public:
  explicit FieldPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}

  /// Averages what is shown small. Call once a frame, before drawing.
  void prepare(const sim::Drawables& drawables, double seconds);
  /// driver: into the bound framebuffer, in the order of the scene. behind: linear light and coverage, the
  /// last row first; over: on the finished picture, encoded, the top row first.
  void draw(const sim::Drawables& drawables, sim::FieldDisplay::Layer layer, double seconds);
  /// exact: over the finished picture, RGBA8, its first row the top one.
  void drawOver(const sim::Drawables& drawables, double seconds, const gl::Texture& picture);
  /// exact: behind all that is drawn already. `light`: RGBA32F, light times coverage, and coverage; its
  /// last row is the picture's top one, or its first one (topFirst).
  void drawBehind(const sim::Drawables& drawables, double seconds, const gl::Texture& light,
                  bool topFirst = false);
  /// Cells averaged into a texel on a side: the picture shows two to three texels a pixel then.
  [[nodiscard]] static int reductionFor(glm::ivec2 cells, glm::dvec2 perPixel);
  /// Whether a field over the picture leaves nothing else of it to be seen.
  [[nodiscard]] bool hidesAll(const sim::Drawables& drawables, double seconds) const;

 private:
  /// What is kept of the field at one place of the drawables.
  struct Kept {
    FieldColors colors;
    gl::Texture reduced;
    glm::ivec2 cells{0, 0};
    int reduction = 1;
    bool colored = false;
  };
  void reduce(const sim::Field& field, Kept& kept, double seconds);
  void drawOne(const sim::Field& field, const Kept& kept, double seconds);
  void drawOneExactly(const sim::Field& field, const Kept& kept, double seconds, const gl::Texture& target,
                      int lastRow);
  /// What both rasterizers read.
  static ShownField shownAs(const sim::Field& field, const Kept& kept, const FieldView& view,
                            double seconds);
  [[nodiscard]] FieldDrawVariant variant(const sim::Field& field, const Kept& kept, double seconds) const;

  glm::ivec2 picture_;
  bool exact_;
  FieldKernel kernel_;
  std::vector<Kept> kept_;
  gl::Kernels<DrawField> kernels_;
  std::map<gl::Defines, gl::Program> programs_;  ///< driver: by variant
  VertexArray vertices_;
};

}  // namespace simreel::draw
