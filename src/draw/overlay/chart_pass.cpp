#include "draw/overlay/chart_pass.hpp"

#include "base/error.hpp"
#include "draw/overlay/text_boxes.hpp"
#include "draw/picture_code.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/give.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::draw {

namespace {

/// Uniforms, buffers and textures that draw/overlay/chart_inputs.glsl declares.
struct ChartFields {
  gl::In<"counts"> counts;
  gl::In<"columns"> columns;
  gl::Uniform<"steps", int> steps;
  gl::Uniform<"perTop", float> perTop;
  gl::Uniform<"panel", glm::vec4> panel;
  gl::Uniform<"plot", glm::vec4> plot;
  gl::Uniform<"unit", float> unit;
  gl::Uniform<"curves", int> curves;
  gl::Uniforms<"colors", glm::vec3, 4> colors;
  gl::Uniform<"zero", float> zero;
  gl::Uniform<"end", float> end;
};

}  // namespace

struct CondenseChart {
  static constexpr auto file = "draw/overlay/chart_columns.comp";
  gl::In<"counts"> counts;
  gl::Uniform<"steps", int> steps;
  gl::Uniform<"perTop", float> perTop;
  gl::Out<"condensed"> columns;
  gl::Uniform<"columnCount", int> columnCount;
  gl::Uniform<"perColumn", float> perColumn;
};

struct DrawChart {
  static constexpr auto file = "draw/overlay/chart.comp";
  ChartFields chart;
  gl::InOut<"target"> target;
  gl::Uniform<"part", glm::ivec4> part;
};

namespace {

int curveCount(const sim::Chart& chart) {
  return static_cast<int>(std::min<std::size_t>({chart.names.size(), chart.colors.size(), 4}));
}

float perTop(const sim::Chart& chart) {
  return 1.0F / static_cast<float>(std::max(chart.max, 1U));
}

ChartFields chartFields(const sim::Chart& chart, const ChartLayout& layout, const gl::Texture& columns) {
  const float fraction =
      static_cast<float>(std::max(chart.steps - 1, 0)) / static_cast<float>(std::max(chart.width - 1, 1));
  const int curves = curveCount(chart);
  std::vector<glm::vec3> colors(4, glm::vec3(0));
  // Encodes the colours as sRGB with the same approximation as the kernels.
  std::transform(chart.colors.begin(), chart.colors.begin() + curves, colors.begin(),
                 [](glm::vec3 linear) { return shader::encoded(glm::clamp(linear, 0.0F, 1.0F)); });
  return {.counts = *chart.counts,
          .columns = columns,
          .steps = chart.steps,
          .perTop = perTop(chart),
          .panel = glm::vec4(layout.panel),
          .plot = glm::vec4(layout.plot),
          .unit = static_cast<float>(layout.unit),
          .curves = curves,
          .colors = colors,
          .zero = chart.zero,
          .end = fraction * static_cast<float>(layout.plot.z - layout.plot.x)};
}

}  // namespace

ChartLayout chartLayout(const sim::Chart& chart, glm::ivec2 picture) {
  ChartLayout layout;
  layout.unit = letterUnit(picture);
  const int u = layout.unit;
  const glm::vec2 whole(picture);
  const glm::ivec2 from(glm::round(chart.corner * whole));
  const glm::ivec2 end(glm::round((chart.corner + chart.extent) * whole));
  layout.panel = {from, end};
  layout.plot = {from.x + 9 * u, from.y + 20 * u, end.x - 9 * u, end.y - 18 * u};
  // If the chart is too small for letters, it shows only curves. The curves are at least one pixel high.
  layout.hasLetters = layout.plot.w - layout.plot.y >= 12 * u && layout.plot.z - layout.plot.x >= 24 * u;
  if (!layout.hasLetters)
    layout.plot = {from.x + 2, from.y + 2, std::max(end.x - 2, from.x + 3),
                   std::max(end.y - 2, from.y + 3)};
  return layout;
}

void ChartPass::compile() {
  if (columns_) return;
  columns_ = gl::Kernel<CondenseChart>(gl::Defines());
  if (exact_)
    exactCurves_ = gl::Kernel<DrawChart>(gl::Defines());
  else
    curves_ = gl::Program::graphics("draw/overlay/chart.vert", "draw/overlay/chart.frag");
}

void ChartPass::draw(const sim::Drawables& drawables) {
  SIMREEL_CHECK(!exact_);
  if (!prepare(drawables)) return;
  DrawState{.depthTest = false}.set();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (std::size_t i = 0; i < cached_.size(); ++i) {
    const sim::Chart& chart = drawables.charts[i];
    const ChartLayout layout = chartLayout(chart, picture_);
    condense(chart, layout, cached_[i]);
    drawCurves(chart, layout, cached_[i]);
  }
}

void ChartPass::draw(const sim::Drawables& drawables, const gl::Texture& picture) {
  SIMREEL_CHECK(exact_);
  if (!prepare(drawables)) return;
  for (std::size_t i = 0; i < cached_.size(); ++i) {
    const sim::Chart& chart = drawables.charts[i];
    const ChartLayout layout = chartLayout(chart, picture_);
    condense(chart, layout, cached_[i]);
    drawExactly(chart, layout, cached_[i], picture);
  }
}

bool ChartPass::prepare(const sim::Drawables& drawables) {
  if (drawables.charts.empty()) return false;
  compile();
  if (cached_.size() != drawables.charts.size()) cached_ = std::vector<Cached>(drawables.charts.size());
  return true;
}

void ChartPass::drawExactly(const sim::Chart& chart, const ChartLayout& layout, const Cached& cached,
                            const gl::Texture& picture) const {
  const glm::ivec4 part = glm::clamp(layout.panel, glm::ivec4(0), glm::ivec4(picture_, picture_));
  exactCurves_.dispatch(
      glm::ivec2(part.z - part.x, part.w - part.y),
      {.chart = chartFields(chart, layout, cached.columns), .target = picture, .part = part});
  imageBarrier();
}

void ChartPass::condense(const sim::Chart& chart, const ChartLayout& layout, Cached& cached) const {
  const int width = layout.plot.z - layout.plot.x;
  if (cached.columns.width() != width)
    cached.columns = gl::Texture::image("chart columns", GL_RGBA32F, width, 4);
  if (chart.steps < 1) return;
  const float perColumn = static_cast<float>(std::max(chart.width - 1, 1)) / static_cast<float>(width);
  columns_.dispatch(width, {.counts = *chart.counts,
                            .steps = chart.steps,
                            .perTop = perTop(chart),
                            .columns = cached.columns,
                            .columnCount = width,
                            .perColumn = perColumn});
}

void ChartPass::drawCurves(const sim::Chart& chart, const ChartLayout& layout, const Cached& cached) const {
  gl::barrier();
  gl::give(curves_, chartFields(chart, layout, cached.columns));
  curves_.set("picture", glm::vec2(picture_));
  curves_.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace simreel::draw
