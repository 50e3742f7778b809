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

/// Shader inputs for a field and its position in the picture (glsl/draw/overlay/field_view.glsl).
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
  gl::Flag<"SPLINED"> splined;
  gl::Flag<"FINE"> fine;
  gl::Flag<"TILED"> tiled;
  gl::Flag<"RELIEF"> relief;
  gl::Range<"ROWS", 1, 8> rows = {};  ///< number of pixels per invocation of the exact rasterizer
};

struct DrawField;

/// Draws fields over the picture or behind the scene. Reads the cells directly from the simulation's
/// memory. If a pixel covers four or more cells, a kernel first averages blocks of cells.
class FieldPass {
 public:
  explicit FieldPass(glm::ivec2 picture, Rasterizer rasterizer = Rasterizer::driver)
      : picture_(picture), exact_(rasterizer == Rasterizer::exact) {}

  /// Averages the fields that are drawn at reduced resolution. Call once per frame, before drawing.
  void prepare(const sim::Drawables& drawables, double seconds);
  /// Draws into the bound framebuffer, in scene order. For the layer `behind`, writes linear light and
  /// coverage, with the bottom row first. For the layer `over`, writes encoded colours over the finished
  /// picture, with the top row first. Only for the driver's rasterizer.
  void draw(const sim::Drawables& drawables, sim::FieldDisplay::Layer layer, double seconds);
  /// Draws over the finished RGBA8 picture, whose first row is the top row. Only for the exact rasterizer.
  void drawOver(const sim::Drawables& drawables, double seconds, const gl::Texture& picture);
  /// Draws behind everything in `light` (RGBA32F: premultiplied light and coverage). `topFirst`: true if
  /// the first row of `light` is the top row of the picture, false if it is the bottom row. Only for the
  /// exact rasterizer.
  void drawBehind(const sim::Drawables& drawables, double seconds, const gl::Texture& light,
                  bool topFirst = false);
  /// Returns the number of cells along each axis that are averaged into one texel. With this number, the
  /// reduced field has two to three texels per pixel.
  [[nodiscard]] static int reductionFor(glm::ivec2 cells, glm::dvec2 perPixel);
  /// True if an opaque field covers the whole picture.
  [[nodiscard]] bool hidesAll(const sim::Drawables& drawables, double seconds) const;

 private:
  /// Data that is stored for one field of the drawables.
  struct Cached {
    FieldColors colors;
    gl::Texture reduced;
    glm::ivec2 cells{0, 0};
    int reduction = 1;
    bool colored = false;
  };
  void reduce(const sim::Field& field, Cached& cached, double seconds);
  void drawOne(const sim::Field& field, const Cached& cached, double seconds);
  void drawOneExactly(const sim::Field& field, const Cached& cached, double seconds,
                      const gl::Texture& target, int lastRow);
  /// Returns the shader inputs that both rasterizers use.
  static ShownField shownAs(const sim::Field& field, const Cached& cached, const FieldView& view,
                            double seconds);
  [[nodiscard]] FieldDrawVariant variant(const sim::Field& field, const Cached& cached,
                                         double seconds) const;

  glm::ivec2 picture_;
  bool exact_;
  FieldKernel kernel_;
  std::vector<Cached> cached_;
  gl::Kernels<DrawField> kernels_;
  std::map<gl::Defines, gl::Program> programs_;  ///< programs for the driver's rasterizer, by variant
  VertexArray vertices_;
};

}  // namespace simreel::draw
