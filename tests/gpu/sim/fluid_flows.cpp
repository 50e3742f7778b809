// Tests a coarse version of a flow that bench_fluid measures at full resolution.
#include "reference/fluid_flows.hpp"

#include "gpu/context.hpp"
#include "sim/fluid/fluid.hpp"

#include <memory>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

// At 40 cells per diameter, the reference values are Strouhal number 0.30, drag 3.23 and lift 1.0 (Schaefer
// and Turek 1996).
TEST_CASE("fluid: a cylinder ten cells wide has roughly the published shedding frequency and drag") {
  testContext();
  const flows::Cylinder cylinder = flows::schaeferTurek(10);
  scene::Object object;
  object.name = "channel";
  object.parameters = std::make_unique<sim::FluidParameters>(cylinder.parameters);
  const std::vector<sim::ColliderShape> none;
  const auto fluid = sim::fluidKind().make(object, {false, 1, cylinder.frame, &none});
  flows::Wake wake;
  double divergence = 0;
  for (int frame = 0; frame < 320; ++frame) {
    fluid->pass(frame * cylinder.frame);
    if (frame < 200) continue;
    const auto measured = fluid->measure();
    divergence = measured[0];
    flows::note(wake, cylinder, frame * cylinder.frame, measured);
  }
  CHECK(divergence <= sim::maxFluidDivergence);
  CHECK(wake.frequency(1.2) * 0.1 == doctest::Approx(0.30).epsilon(0.08));
  CHECK(wake.maxDrag(1.2) == doctest::Approx(3.23).epsilon(0.17));
  CHECK(wake.maxLift(1.2) == doctest::Approx(1.1).epsilon(0.2));
}
