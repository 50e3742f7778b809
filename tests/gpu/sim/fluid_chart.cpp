// Tests the chart of a fluid's drag and lift. The chart must have one value for each frame, including
// frames that are not drawn.
#include "gpu/context.hpp"
#include "sim/fluid/chart.hpp"
#include "sim/fluid/fluid.hpp"
#include "sim/fluid/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double chartFrame = 1.0 / 30;

sim::FluidParameters chartedChannel() {
  sim::FluidParameters p;
  p.size = {41, 27};
  p.speed = 60;
  p.viscosity = 4.0F;
  p.left.kind = sim::FluidSide::Kind::inflow;
  p.left.velocity = glm::vec3(25, 5, 0);
  p.right.kind = sim::FluidSide::Kind::open;
  p.flow = {25, 0, 0};
  p.strokes.clear();
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(15, 13, 0);
  p.obstacles[0].radius = 4;
  p.chart.emplace();
  p.chart->curves.resize(2);
  p.chart->curves[1].of = sim::FluidChartParameters::Quantity::drag;
  for (auto& curve : p.chart->curves) curve.per = 2500;
  p.chart->low = -3;
  p.chart->high = 5;
  p.chart->seconds = 2;
  return p;
}

std::unique_ptr<sim::Simulation> chartedFluid() {
  scene::Object object;
  object.name = "channel";
  object.kind = "fluid";
  object.parameters = std::make_unique<sim::FluidParameters>(chartedChannel());
  const std::vector<sim::ColliderShape> none;
  return sim::fluidKind().make(object, {false, 1, chartFrame, &none});
}

struct ChartKeeper : sim::CarryOver {
  void array(const char* /*name*/, gl::Buffer& buffer) override {
    if (takes)
      buffer.write(0, std::as_bytes(std::span(rows)));
    else
      rows = buffer.readAll<glm::uvec4>();
  }
  void word(const char* /*name*/, std::int64_t& bits) override {
    if (takes)
      bits = words[next++];
    else
      words.push_back(bits);
  }
  bool takes = false;
  std::size_t next = 0;
  std::vector<glm::uvec4> rows;
  std::vector<std::int64_t> words;
};

}  // namespace

TEST_CASE("fluid chart: drag and lift are recorded for each frame, also for frames that are not drawn") {
  testContext();
  const auto seen = chartedFluid(), passed = chartedFluid();
  std::vector<std::vector<double>> measured = {seen->measure()};
  for (int frame = 0; frame < 5; ++frame) {
    seen->step(frame * chartFrame, {});
    passed->pass(frame * chartFrame);
    measured.push_back(seen->measure());
  }
  sim::Drawables drawn, unseen;
  seen->publish(0, drawn);
  passed->publish(0, unseen);
  REQUIRE(drawn.charts.size() == 1);
  const sim::Chart& chart = drawn.charts[0];
  CHECK(chart.steps == 6);
  CHECK(chart.width == 61);
  CHECK(chart.length == "2 s");
  CHECK(chart.range == "-3 to 5");
  CHECK(chart.zero == doctest::Approx(0.375));
  CHECK(chart.names == std::vector<std::string>{"lift", "drag"});
  const auto rowsOf = [](const sim::Chart& c) {
    GLint buffer = 0;
    glGetTextureLevelParameteriv(c.counts->name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
    std::vector<glm::uvec4> rows(static_cast<std::size_t>(c.steps));
    glGetNamedBufferSubData(static_cast<GLuint>(buffer), 0, static_cast<GLsizeiptr>(rows.size() * 16),
                            rows.data());
    return rows;
  };
  const auto rows = rowsOf(chart);
  CHECK(rows == rowsOf(unseen.charts[0]));
  double maximum = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto shown = [&](int curve) { return rows[i][curve] / 16777216.0 * 8 - 3; };
    // The inflow goes down, so the lift, which is positive upwards, is negative. The drag, to the right, is
    // positive.
    CHECK(shown(0) == doctest::Approx(std::clamp(measured[i][9] / 2500, -3.0, 5.0)).epsilon(1e-5));
    CHECK(shown(1) == doctest::Approx(std::clamp(measured[i][8] / 2500, -3.0, 5.0)).epsilon(1e-5));
    if (i > 0) CHECK(shown(1) > 0.1);
    maximum = std::max(maximum, std::abs(shown(0)));
  }
  CHECK(maximum > 0.05);
  CHECK(maximum < 3);
}

TEST_CASE("fluid chart: it grows during a run and continues from a checkpoint") {
  testContext();
  sim::FluidChartParameters p;
  p.low = 0;
  p.high = 2000;
  sim::FluidChart chart("a", p, 0.1);
  std::vector<double> measured(10);
  for (int i = 0; i < 1500; ++i) {
    measured[9] = i;  // Quantity 9 is the lift.
    chart.add(measured);
  }
  ChartKeeper keeper;
  chart.visitCheckpointData(keeper);
  keeper.takes = true;
  sim::FluidChart other("b", p, 0.1);
  other.visitCheckpointData(keeper);
  other.add(measured);
  CHECK(other.frames() == 1501);
  const auto rows = other.rows().readAll<glm::uvec4>();
  int wrong = 0;
  for (int i = 0; i < 1501; ++i)
    wrong += rows[static_cast<std::size_t>(i)].x !=
                     static_cast<unsigned>(std::floor(std::min(i, 1499) / 2000.0 * 16777216 + 0.5))
                 ? 1
                 : 0;
  CHECK(wrong == 0);
}
