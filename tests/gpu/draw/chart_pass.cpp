// Tests the charts over a picture: the positions of curves for any number of steps, and names in the
// colours of the curves.
#include "draw/overlay/chart_pass.hpp"

#include "draw/overlay/chart_labels.hpp"
#include "gpu/draw/draw_stage.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

struct ChartStage {
  ChartStage(int steps, int width, unsigned max, const std::function<glm::uvec4(int)>& at) {
    std::vector<glm::uvec4> counts;
    for (int i = 0; i < std::max(steps, 1); ++i) counts.push_back(at(i));
    buffer = gl::Buffer::of<glm::uvec4>("counts", counts);
    view = gl::Texture::view("counts", GL_RGBA32UI, buffer);
    chart.counts = &view;
    chart.steps = steps;
    chart.width = width;
    chart.max = max;
    chart.names = {"red", "green"};
    chart.colors = {{1, 0, 0}, {0, 1, 0}};
  }
  gl::Buffer buffer;
  gl::Texture view;
  sim::Chart chart;
};

/// Returns the first and last row, counted from the top of the plot, in which `channel` is the largest
/// channel in the plot's column `x`. Returns -1 for both if there is no such row.
glm::ivec2 span(const Picture& picture, const draw::ChartLayout& layout, int x, int channel) {
  glm::ivec2 rows(-1);
  for (int y = layout.plot.y; y < layout.plot.w; ++y) {
    const glm::ivec3 c = picture.at(layout.plot.x + x, y);
    if (c[channel] < 150 || c[channel] < 2 * c[1 - channel]) continue;
    if (rows.x < 0) rows.x = y - layout.plot.y;
    rows.y = y - layout.plot.y;
  }
  return rows;
}

}  // namespace

TEST_CASE("charts: a curve's height equals its counts for few and for many steps") {
  testContext();
  const glm::ivec2 size{641, 363};
  for (const int steps : {5, 300, 40001}) {
    CAPTURE(steps);
    const auto value = [&](int i) { return static_cast<unsigned>(i * (900.0 / (steps - 1))); };
    const ChartStage stage(steps, steps, 1000,
                           [&](int i) { return glm::uvec4(value(i), 1000 - value(i), 0, 0); });
    const Picture picture = drawn(darkScene(), {.charts = {stage.chart}}, size);
    const draw::ChartLayout layout = draw::chartLayout(stage.chart, size);
    const glm::ivec2 plot(layout.plot.z - layout.plot.x, layout.plot.w - layout.plot.y);
    for (const int x : {10, plot.x / 3, plot.x - 12}) {
      const double fraction = (x + 0.5) / plot.x * 0.9;
      const glm::ivec2 red = span(picture, layout, x, 0);
      const glm::ivec2 green = span(picture, layout, x, 1);
      REQUIRE(red.x >= 0);
      REQUIRE(green.x >= 0);
      CHECK(std::abs(0.5 * (red.x + red.y + 1) - (1 - fraction) * plot.y) < 1.5);
      CHECK(std::abs(0.5 * (green.x + green.y + 1) - fraction * plot.y) < 1.5);
      CHECK(red.y - red.x <= 4);
    }
  }
}

TEST_CASE(
    "charts: a one-step peak among thousands of steps is visible, and nothing is drawn after the last "
    "step") {
  testContext();
  const glm::ivec2 size{641, 363};
  const ChartStage stage(20000, 40000, 1000,
                         [](int i) { return glm::uvec4(i == 9000 ? 1000 : 100, 0, 0, 0); });
  const Picture picture = drawn(darkScene(), {.charts = {stage.chart}}, size);
  const draw::ChartLayout layout = draw::chartLayout(stage.chart, size);
  const int plot = layout.plot.z - layout.plot.x;
  CHECK(span(picture, layout, plot * 9 / 40, 0).x <= 2);
  CHECK(span(picture, layout, plot * 9 / 40 - 5, 0).x > 40);
  CHECK(span(picture, layout, plot / 2 + 10, 0).x == -1);
  CHECK(span(picture, layout, plot / 2 - 10, 0).x >= 0);
}

TEST_CASE("charts: names have the colours of their curves, and pixels outside the panel are unchanged") {
  testContext();
  for (const glm::ivec2 size : {glm::ivec2(640, 360), glm::ivec2(1919, 1081)}) {
    const ChartStage stage(0, 100, 10, [](int) { return glm::uvec4(0); });
    const Picture picture = drawn(darkScene(), {.charts = {stage.chart}}, size);
    const draw::ChartLayout layout = draw::chartLayout(stage.chart, size);
    double red = 0;
    double green = 0;
    int outside = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::ivec3 c = picture.at(x, y);
        red += std::max(c.r - std::max(c.g, c.b), 0) / 255.0;
        green += std::max(c.g - std::max(c.r, c.b), 0) / 255.0;
        const bool in =
            x >= layout.panel.x && x < layout.panel.z && y >= layout.panel.y && y < layout.panel.w;
        outside += !in && picture.brightness(x, y) > 0;
      }
    // The number of red pixels equals the area within the outlines of the name.
    draw::ChartLabels labels(size);  // contains the outlines to which `written` refers
    const std::vector<sim::Writing> written = labels.of({.charts = {stage.chart}});
    REQUIRE(written.size() == 4);  // two names and two axis labels
    double area = 0;
    for (const auto& polygon : *written[0].outlines)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a(polygon[i]), b(polygon[(i + 1) % polygon.size()]);
        area += 0.5 * (a.x * b.y - a.y * b.x);
      }
    const double wanted = std::abs(area) * std::pow(static_cast<double>(written[0].height) * size.y, 2);
    // the tolerance covers the chart's background, which is dark but not black
    CHECK(red == doctest::Approx(wanted).epsilon(0.12));
    CHECK(green > red);
    CHECK(outside == 0);
  }
}

TEST_CASE("charts: pictures of any size, down to 1x1, are drawn") {
  testContext();
  const ChartStage stage(7, 7, 10, [](int i) { return glm::uvec4(i, 10 - i, 0, 0); });
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(9, 7), glm::ivec2(65, 33)})
    CHECK(drawn(darkScene(), {.charts = {stage.chart}}, size).bytes.size() ==
          static_cast<std::size_t>(size.x * size.y * 4));
}
