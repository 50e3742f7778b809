// Tests obstacles that move through a fluid along keyframes, with slip and no-slip surfaces.
#include "gpu/context.hpp"
#include "reference/fluid_twin.hpp"
#include "sim/fluid/fluid.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double slidingFrame = 1.0 / 30;
using SlidingSide = sim::FluidSide::Kind;

scene::Animated<glm::vec3> slidingWay(glm::vec3 from, glm::vec3 to, double seconds) {
  return {{{0.0, from}, {seconds, to}}, scene::Ease::linear};
}

sim::FluidParameters stillBath(glm::ivec2 size, bool slip) {
  sim::FluidParameters p;
  p.size = size;
  p.speed = 60;
  p.strokes.clear();
  p.obstaclesSlip = slip;
  p.viscosity = 1.5F;
  p.cycles = 60;
  return p;
}

/// Returns a channel with a circle and a rotating box that move along keyframes.
sim::FluidParameters movingPair(glm::ivec2 size, bool slip) {
  auto p = stillBath(size, slip);
  const auto w = static_cast<float>(size.x), h = static_cast<float>(size.y);
  p.left.kind = SlidingSide::inflow;
  p.left.velocity = glm::vec3(12, 1, 0);
  p.right.kind = SlidingSide::open;
  p.top.kind = slip ? SlidingSide::slip : SlidingSide::wall;
  p.obstacles.resize(2);
  p.obstacles[0].center = slidingWay({0.3F * w, 0.3F * h, 0}, {0.3F * w + 9.5F, 0.3F * h + 3, 0}, 0.3);
  p.obstacles[0].radius = 4.3F;
  p.obstacles[1].shape = sim::FluidObstacle::Shape::box;
  p.obstacles[1].center = slidingWay({0.7F * w, 0.7F * h, 0}, {0.7F * w - 7, 0.7F * h, 0}, 0.4);
  p.obstacles[1].extent = {9.5F, 4.2F, 0};
  p.obstacles[1].turn = scene::Animated<float>({{0.0, 10.0F}, {1.0, 190.0F}}, scene::Ease::linear);
  return p;
}

int slidingDifferences(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  int different = 0;
  for (std::size_t i = 0; i < b.size(); ++i)
    for (int c = 0; c < 4; ++c)
      different += std::bit_cast<std::uint32_t>(a[i][c]) != std::bit_cast<std::uint32_t>(b[i][c]) ? 1 : 0;
  return different;
}

}  // namespace

TEST_CASE("fluid with a keyframed circle and box equals its CPU twin, slip and no-slip, on odd sizes") {
  testContext();
  for (const bool slip : {true, false}) {
    CAPTURE(slip);
    const auto p = movingPair(slip ? glm::ivec2(53, 37) : glm::ivec2(34, 43), slip);
    scene::Object object;
    object.name = "bath";
    object.kind = "fluid";
    object.parameters = std::make_unique<sim::FluidParameters>(p);
    const std::vector<sim::ColliderShape> none;
    const auto gpu = sim::fluidKind().make(object, {false, 5, slidingFrame, &none});
    FluidTwin twin(sim::FluidPlan(p, "bath", 5, slidingFrame));
    for (int frame = 0; frame < 3; ++frame) {
      gpu->step(frame * slidingFrame, {});
      twin.step(frame * slidingFrame);
    }
    CHECK(slidingDifferences(gpu->state()[0].readAll<glm::vec4>(), twin.flow) == 0);
    const auto measured = gpu->measure();
    CHECK(measured[0] <= sim::maxFluidDivergence);
    CHECK(std::abs(measured[8]) > 1);  // Quantity 8 is the drag.
  }
}
