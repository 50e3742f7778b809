// Tests charts and axes drawn by kernels. Compares them with their CPU version bit by bit, with the
// driver's picture within its rounding, and with curves in double precision.
#include "draw/overlay/axes_pass.hpp"
#include "draw/overlay/chart_pass.hpp"
#include "gpu/draw/overlay_stage.hpp"

#include <cmath>
#include <functional>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

struct CountStage {
  CountStage(int steps, int width, unsigned max, const std::function<glm::uvec4(int)>& at) {
    for (int i = 0; i < std::max(steps, 1); ++i) counts.push_back(at(i));
    buffer = gl::Buffer::of<glm::uvec4>("counts", counts);
    view = gl::Texture::view("counts", GL_RGBA32UI, buffer);
    chart.counts = &view;
    chart.steps = steps;
    chart.width = width;
    chart.max = max;
    chart.names = {"susceptible", "infected", "recovered"};
    chart.colors = {{0.1F, 0.4F, 0.9F}, {0.9F, 0.05F, 0.02F}, {0.2F, 0.8F, 0.1F}};
  }
  /// Returns the inputs of the CPU version of the panel, without letters.
  [[nodiscard]] ChartInputs inputs(glm::ivec2 picture) const {
    const draw::ChartLayout layout = draw::chartLayout(chart, picture);
    const int wide = layout.plot.z - layout.plot.x;
    ChartInputs in;
    in.counts = counts;
    in.steps = chart.steps;
    in.perTop = 1.0F / static_cast<float>(std::max(chart.max, 1U));
    in.perColumn = static_cast<float>(std::max(chart.width - 1, 1)) / static_cast<float>(wide);
    in.panel = glm::vec4(layout.panel);
    in.plot = glm::vec4(layout.plot);
    in.unit = static_cast<float>(layout.unit);
    in.curves = static_cast<int>(chart.names.size());
    for (std::size_t i = 0; i < chart.colors.size(); ++i) in.colors.at(i) = chart.colors[i];
    in.zero = chart.zero;
    in.end = static_cast<float>(std::max(chart.steps - 1, 0)) /
             static_cast<float>(std::max(chart.width - 1, 1)) * static_cast<float>(wide);
    return in;
  }
  std::vector<glm::uvec4> counts;
  gl::Buffer buffer;
  gl::Texture view;
  sim::Chart chart;
};

OverlayPicture<OverlayBytes> charted(const sim::Chart& chart, const OverlayPicture<OverlayBytes>& below,
                                     draw::Rasterizer rasterizer) {
  draw::ChartPass pass(below.size, rasterizer);
  const gl::Texture image = imageOf(below);
  if (rasterizer == draw::Rasterizer::exact) {
    pass.draw({.charts = {chart}}, image);
  } else {
    const gl::Framebuffer target("picture", &image, nullptr);
    target.bind();
    pass.draw({.charts = {chart}});
  }
  return readBack<OverlayBytes>(image);
}

glm::uvec4 waves(int i) {
  const auto high = [](double x) { return static_cast<unsigned>(x); };
  return {high(30000 + 25000 * std::cos(0.01 * i)), high(20000 + 19000 * std::sin(0.3 * i)),
          i % 7 == 0 ? 60000U : 500U, 0};
}

}  // namespace

TEST_CASE(
    "exact charts: panel and curves have the bits of their twin, whatever the steps and the picture") {
  testContext();
  for (const glm::ivec2 size : {glm::ivec2(641, 363), glm::ivec2(1279, 719), glm::ivec2(65, 33)})
    for (const auto& [steps, all] :
         {std::pair(0, 3), {1, 3}, {7, 14}, {300, 600}, {20001, 40002}, {7, 7}, {300, 301}, {2000, 2000}}) {
      CAPTURE(steps);
      CAPTURE(all);
      CountStage stage(steps, all, 65536, waves);
      stage.chart.names = {"", "", ""};  // The chart has no letters, because another test below covers
                                         // them.
      if (steps == 300) stage.chart.zero = 0.37F;
      const auto below = someBytes(size);
      const auto exact = charted(stage.chart, below, draw::Rasterizer::exact);
      auto wanted = below;
      const draw::ChartLayout layout = draw::chartLayout(stage.chart, size);
      ChartTwin(stage.inputs(size)).over(wanted, layout.panel);
      // Ignores the rows below the plot, which contain letters.
      int wrong = 0;
      int changed = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          if (y >= layout.plot.w + 4 * layout.unit && y < layout.panel.w) continue;
          const auto i = static_cast<std::size_t>(y * size.x + x);
          wrong += exact.pixels[i] != wanted.pixels[i];
          changed += exact.pixels[i] != below.pixels[i];
        }
      CHECK(wrong == 0);
      CHECK(changed > 0);
    }
}

TEST_CASE("exact charts: with letters, the driver's picture within its rounding") {
  testContext();
  for (const glm::ivec2 size :
       {glm::ivec2(641, 363), glm::ivec2(1279, 719), glm::ivec2(1, 1), glm::ivec2(9, 7)})
    for (const int steps : {0, 7, 300}) {
      CountStage stage(steps, 600, 65536, waves);
      if (steps == 300) stage.chart.zero = 0.5F;
      const auto below = someBytes(size, true);
      const Distance pixelDifference = distance(charted(stage.chart, below, draw::Rasterizer::exact),
                                                charted(stage.chart, below, draw::Rasterizer::driver));
      // The tolerance is needed because the software driver blends with 8 bits.
      CHECK(pixelDifference.max <= 1);
      CHECK(pixelDifference.mean < 0.02);
    }
}

TEST_CASE("exact charts: columns are what lies between the steps, in double precision") {
  testContext();
  const glm::ivec2 size(641, 363);
  for (const int steps : {2, 300, 20001}) {
    const CountStage stage(steps, steps + 50, 65536, waves);
    const ChartInputs in = stage.inputs(size);
    const auto columns = ChartTwin(in).columns();
    const auto count = static_cast<double>(columns.size());
    double worst = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double first = static_cast<double>(c) * (steps + 49) / count;
      if (first > steps - 1 + 1e-6) CHECK(columns[c][0].x == -1);
      if (first > steps - 1 - 1e-3) continue;
      const double end = std::min(static_cast<double>(c + 1) * (steps + 49) / count, steps - 1.0);
      for (int k = 0; k < 3; ++k) {
        const auto height = [&](int i) {
          return stage.counts[static_cast<std::size_t>(std::min(i, steps - 1))][k] / 65536.0;
        };
        const auto at = [&](double place) {
          const double below = std::floor(place);
          const int i = static_cast<int>(below);
          return height(i) + (height(i + 1) - height(i)) * (place - below);
        };
        double low = std::min(at(first), at(end));
        double high = std::max(at(first), at(end));
        for (int i = static_cast<int>(first) + 1; i < end; ++i) {
          low = std::min(low, height(i));
          high = std::max(high, height(i));
        }
        // The tolerance is larger for thousands of steps, because positions then have only 11 fractional
        // bits and a curve may rise over its full height in one step.
        const double allowed = steps > 1000 ? 4e-3 : 2e-4;
        worst = std::max({worst, std::abs(columns[c][0][k] - at(first)) / allowed,
                          std::abs(columns[c][1][k] - at(end)) / allowed,
                          std::abs(columns[c][2][k] - low) / allowed,
                          std::abs(columns[c][3][k] - high) / allowed});
      }
    }
    CHECK(worst < 1);
  }
}

TEST_CASE("exact charts: a level curve is a line of even thickness at its height") {
  testContext();
  const glm::ivec2 size(641, 363);
  CountStage stage(400, 400, 1000, [](int) { return glm::uvec4(640, 0, 0, 0); });
  stage.chart.names = {"level"};
  stage.chart.colors = {{1, 1, 1}};
  const draw::ChartLayout layout = draw::chartLayout(stage.chart, size);
  const auto picture = charted(stage.chart, {size, std::vector<OverlayBytes>(641 * 363, {0, 0, 0, 255})},
                               draw::Rasterizer::exact);
  const int x = layout.plot.x + (layout.plot.z - layout.plot.x) / 3;
  const double height = layout.plot.w - layout.plot.y;
  const double line = 0.36 * height;  // distance from the top of the plot
  for (int y = layout.plot.y + 2; y < layout.plot.w - 2; ++y) {
    const double p = y + 0.5 - layout.plot.y;
    // Blends the panel, its grid, the fill below the curve and the curve.
    double light = 0.05 * 0.78;
    const auto cover = [&](double alpha) { light += (1 - light) * std::clamp(alpha, 0.0, 1.0); };
    const double quarter = p / height * 4;
    cover(0.09 * std::clamp(1.0 - std::abs(quarter - std::round(quarter)) * height / 4, 0.0, 1.0));
    cover(0.10 * std::clamp(p - line + 0.5, 0.0, 1.0));
    cover(0.5 - (std::abs(p - line) - 0.8));
    CHECK(std::abs(picture.pixels[static_cast<std::size_t>(y * size.x + x)][0] - 255 * light) < 0.51);
  }
}

TEST_CASE("exact scales: the same pixels as the driver's, since all are whole") {
  testContext();
  FieldStage stage(sim::Field::Cells::floats, {160, 120}, [](int, int) { return 0.5; });
  stage.display.across = sim::FieldDisplay::Axis{"F, feed rate", 0.014F, 0.062F};
  stage.display.down = sim::FieldDisplay::Axis{"k, kill rate", 0.07F, 0.03F};
  FieldStage other(sim::Field::Cells::floats, {160, 120}, [](int, int) { return 0.5; });
  other.display = stage.display;
  stage.display.extent = {0.5F, 1, 0};
  other.display.extent = {0.6F, 0.9F, 0};
  other.display.corner = {0.31F, 0.07F, 0};  // the field overlaps the axes of the first field
  for (const glm::ivec2 size : {glm::ivec2(1279, 719), glm::ivec2(801, 603)}) {
    const sim::Drawables drawables{.fields = {stage.field, other.field}};
    const auto below = someBytes(size);
    const gl::Texture exact = imageOf(below);
    draw::AxesPass(size, draw::Rasterizer::exact).draw(drawables, 0, exact);
    const gl::Texture driver = imageOf(below);
    const gl::Framebuffer target("picture", &driver, nullptr);
    target.bind();
    draw::AxesPass(size).draw(drawables, 0);
    const auto found = readBack<OverlayBytes>(exact);
    CHECK(differing(found, readBack<OverlayBytes>(driver)) == 0);
    CHECK(differing(found, below) > 30000);
  }
}
