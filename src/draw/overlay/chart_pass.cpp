#include "draw/overlay/chart_pass.hpp"

#include "base/error.hpp"
#include "draw/overlay/text_boxes.hpp"
#include "draw/picture_code.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::draw {

namespace {

int curveCount(const sim::Chart& chart) {
  return static_cast<int>(std::min<std::size_t>({chart.names.size(), chart.colors.size(), 4}));
}

float perTop(const sim::Chart& chart) {
  return 1.0F / static_cast<float>(std::max(chart.max, 1U));
}

/// As the picture has it: the kernels' own approximation.
glm::vec3 encoded(glm::vec3 linear) {
  return shader::encoded(glm::clamp(linear, 0.0F, 1.0F));
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
  // Too small for letters: curves alone, at least a pixel.
  layout.hasLetters = layout.plot.w - layout.plot.y >= 12 * u && layout.plot.z - layout.plot.x >= 24 * u;
  if (!layout.hasLetters)
    layout.plot = {from.x + 2, from.y + 2, std::max(end.x - 2, from.x + 3),
                   std::max(end.y - 2, from.y + 3)};
  return layout;
}

void ChartPass::compile() {
  if (columns_) return;
  columns_ = gl::Program::compute("draw/overlay/chart_columns.comp");
  curves_ = exact_ ? gl::Program::compute("draw/overlay/chart.comp")
                   : gl::Program::graphics("draw/overlay/chart.vert", "draw/overlay/chart.frag");
}

void ChartPass::draw(const sim::Drawables& drawables) {
  SIMREEL_CHECK(!exact_);
  if (!prepare(drawables)) return;
  DrawState{.depthTest = false}.set();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const sim::Chart& chart = drawables.charts[i];
    const ChartLayout layout = chartLayout(chart, picture_);
    condense(chart, layout, kept_[i]);
    drawCurves(chart, layout, kept_[i]);
  }
}

void ChartPass::draw(const sim::Drawables& drawables, const gl::Texture& picture) {
  SIMREEL_CHECK(exact_);
  if (!prepare(drawables)) return;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const sim::Chart& chart = drawables.charts[i];
    const ChartLayout layout = chartLayout(chart, picture_);
    condense(chart, layout, kept_[i]);
    drawExactly(chart, layout, kept_[i], picture);
  }
}

bool ChartPass::prepare(const sim::Drawables& drawables) {
  if (drawables.charts.empty()) return false;
  compile();
  if (kept_.size() != drawables.charts.size()) kept_ = std::vector<Kept>(drawables.charts.size());
  return true;
}

void ChartPass::drawExactly(const sim::Chart& chart, const ChartLayout& layout, const Kept& kept,
                            const gl::Texture& picture) const {
  const glm::ivec4 part = glm::clamp(layout.panel, glm::ivec4(0), glm::ivec4(picture_, picture_));
  // Nor is an image bound that no kernel uses: NVIDIA's driver 580 crashes when it reads the texture then.
  if (part.z <= part.x || part.w <= part.y) return;
  setChart(chart, layout, kept);
  curves_.set("part", part);
  picture.bindImage(targetImage, GL_READ_WRITE);
  imageBarrier();
  curves_.dispatch(part.z - part.x, part.w - part.y);
  imageBarrier();
}

void ChartPass::condense(const sim::Chart& chart, const ChartLayout& layout, Kept& kept) const {
  const int width = layout.plot.z - layout.plot.x;
  if (kept.columns.width() != width)
    kept.columns = gl::Texture::image("chart columns", GL_RGBA32F, width, 4);
  if (chart.steps < 1) return;
  columns_.set("columnCount", width);
  columns_.set("steps", chart.steps);
  columns_.set("perColumn", static_cast<float>(std::max(chart.width - 1, 1)) / static_cast<float>(width));
  columns_.set("perTop", perTop(chart));
  chart.counts->bind(countUnit);
  kept.columns.bindImage(targetImage, GL_WRITE_ONLY);
  columns_.dispatch(width);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ChartPass::setChart(const sim::Chart& chart, const ChartLayout& layout, const Kept& kept) const {
  constexpr const char* colorNames[] = {"colors[0]", "colors[1]", "colors[2]", "colors[3]"};
  const float fraction =
      static_cast<float>(std::max(chart.steps - 1, 0)) / static_cast<float>(std::max(chart.width - 1, 1));
  curves_.set("panel", glm::vec4(layout.panel));
  curves_.set("plot", glm::vec4(layout.plot));
  curves_.set("unit", static_cast<float>(layout.unit));
  curves_.set("curves", curveCount(chart));
  for (int i = 0; i < curveCount(chart); ++i)
    curves_.set(colorNames[i], encoded(chart.colors[static_cast<std::size_t>(i)]));
  curves_.set("steps", chart.steps);
  curves_.set("end", fraction * static_cast<float>(layout.plot.z - layout.plot.x));
  curves_.set("perTop", perTop(chart));
  curves_.set("zero", chart.zero);
  chart.counts->bind(countUnit);
  kept.columns.bind(columnUnit);
}

void ChartPass::drawCurves(const sim::Chart& chart, const ChartLayout& layout, const Kept& kept) const {
  setChart(chart, layout, kept);
  curves_.set("picture", glm::vec2(picture_));
  curves_.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace simreel::draw
