#include "sim/gray_scott/gray_scott.hpp"

#include "gpu/context.hpp"
#include "reference/gray_scott_twin.hpp"
#include "sim/gray_scott/kernels.hpp"

#include <bit>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double dishFrame = 1.0 / 30;

sim::GrayScottParameters field(int width, int height) {
  sim::GrayScottParameters p;
  p.size = {width, height};
  p.preset = sim::GrayScottPreset::stripes;
  p.seedCount = 5;
  return p;
}

void checkSame(const std::vector<glm::vec4>& got, const std::vector<glm::vec4>& want, int width) {
  REQUIRE(got.size() == want.size());
  std::size_t different = 0;
  std::size_t first = 0;
  double min = 1, max = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    bool same = true;
    for (int c = 0; c < 4; ++c)
      same = same && std::bit_cast<std::uint32_t>(got[i][c]) == std::bit_cast<std::uint32_t>(want[i][c]);
    if (!same && different++ == 0) first = i;
    min = std::min<double>(min, want[i].y);
    max = std::max<double>(max, want[i].y);
  }
  const std::size_t columns = static_cast<std::size_t>(width + 1) / 2;
  CHECK_MESSAGE(different == 0, different, " of ", got.size(), " pairs of cells differ, first at column ",
                first % columns * 2, ", row ", first / columns);
  CHECK(max - min > 0.05);  // The range of values shows that a pattern has formed.
}

/// Steps the GPU simulation and its CPU twin and compares every word of the state.
void compare(const sim::GrayScottParameters& parameters, int frames, double start = 0) {
  testContext();
  scene::Object object;
  object.name = "dish";
  object.kind = "grayScott";
  object.parameters = std::make_unique<sim::GrayScottParameters>(parameters);
  const std::vector<sim::ColliderShape> none;
  const auto gpu = sim::grayScottKind().make(object, {false, 5, dishFrame, &none});
  GrayScottTwin twin(sim::GrayScottPlan(parameters, "dish", 5, dishFrame));
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(start + frame * dishFrame, {});
    twin.step(start + frame * dishFrame);
  }
  checkSame(gpu->state()[0].buffer->readAll<glm::vec4>(), twin.cells(), parameters.size.x);
}

}  // namespace

TEST_CASE("grayScott equals its CPU twin after 10,000 steps on 67x45") {
  auto p = field(67, 45);
  p.steps = 100;
  compare(p, 100);
}

TEST_CASE("grayScott equals its CPU twin on sizes down to 4x5") {
  for (const glm::ivec2 size :
       {glm::ivec2(4, 5), glm::ivec2(5, 4), glm::ivec2(7, 9), glm::ivec2(130, 6), glm::ivec2(131, 97)}) {
    CAPTURE(size.x);
    CAPTURE(size.y);
    auto p = field(size.x, size.y);
    p.seedCount = 1;
    p.seedRadius = 1.5;
    p.steps = 7;
    compare(p, 5);
  }
}

TEST_CASE("grayScott with rates that vary in space and time equals its CPU twin") {
  auto p = field(73, 41);
  p.feed = scene::Animated<float>({{0.0, 0.01F}, {0.5, 0.03F}}, scene::Ease::smooth);
  p.feedAcross = 0.09;
  p.killDown = 0.045;
  p.dt = 0.9;
  compare(p, 20);
}

TEST_CASE("grayScott with health, strokes and presteps equals its CPU twin") {
  auto p = field(73, 41);
  p.health.emplace().level = scene::Animated<float>({{0.0, 1.0F}, {0.4, 0.0F}}, scene::Ease::linear);
  p.presteps = 37;
  sim::StrokeParameters stroke;
  stroke.at = 0.1;
  stroke.until = 0.3;
  stroke.from = {0, 10, 0};  // The stroke crosses the seam of the torus, whose width is odd.
  stroke.to = {72, 30, 0};
  stroke.radius = 4.5F;
  stroke.value = 0.4;
  stroke.fraction = 0.6F;
  p.strokes.push_back(stroke);
  compare(p, 15);
}

TEST_CASE("grayScott: every cut of the work into workgroups gives the same bits") {
  testContext();
  const auto p = field(147, 83);
  const sim::GrayScottPlan plan(p, "dish", 5, dishFrame);
  GrayScottTwin twin(plan);
  twin.advance(plan.ratesAt(0), 61);
  using Cut = sim::GrayScottKernels::Cut;
  // On the texel memory path, a strip without adjacent strips must include the border cells at its sides.
  const int sides = gl::memoryPath() == gl::MemoryPath::texel ? 8 : 0;
  for (const Cut cut :
       {Cut{1, 1, 8, 8}, Cut{1, 8, 32, 4}, Cut{2, 4, 8, 8}, Cut{3, 5, 4, 4}, Cut{1, 8, 32, 4, 16},
        Cut{1, 4, 8, 8, 9}, Cut{1, 1, 32, 4, 41}, Cut{1, 4, 8, 8, -1, 2, sides + 1, 20},
        Cut{1, 4, 8, 8, -1, 3, sides + 1, 9}, Cut{1, 4, 8, 8, -1, 6, sides + 1, 16},
        Cut{1, 4, 8, 8, -1, 8, sides + 1, 31}, Cut{1, 4, 8, 8, -1, 3, sides + 2, 50},
        Cut{1, 4, 8, 8, 34, 4, sides + 2, 7}, sim::GrayScottKernels::bestCut(p.size)}) {
    CAPTURE(cut.across);
    CAPTURE(cut.rows);
    CAPTURE(cut.stepsPerPass);
    CAPTURE(cut.bandRows);
    CAPTURE(cut.stripElements);
    sim::GrayScottKernels kernels("dish", plan, false, cut);
    kernels.setRates(plan.ratesAt(0));
    kernels.advance(61);
    gl::barrier();
    checkSame(kernels.cells().buffer().readAll<glm::vec4>(), twin.cells(), p.size.x);
  }
}
