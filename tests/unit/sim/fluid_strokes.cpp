// Tests brushes of fluids that move and change by keyframes, and refused settings.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/fluid/plan.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <doctest/doctest.h>

using namespace simreel;

namespace {

template <class T>
scene::Animated<T> ramp(double from, T a, double to, T b) {
  return scene::Animated<T>({{from, a}, {to, b}}, scene::Ease::linear);
}

std::string refusedFluid(const std::string& fluid) {
  try {
    static_cast<void>(scene::parseScene(R"({"version": 1, "objects": {"it": {"fluid": {)" + fluid + "}}}}",
                                        "test.json", {}, sim::kinds()));
  } catch (const UserError& error) {
    return error.what();
  }
  return "none";
}

std::string refusedStroke(const std::string& stroke) {
  return refusedFluid(R"("strokes": [)" + stroke + "]");
}

}  // namespace

TEST_CASE("keyed strokes: a keyframed brush follows its path, linearly within a step") {
  sim::StrokeParameters brush;
  brush.at = 1;
  brush.until = 3;
  brush.path = scene::Animated<glm::vec3>(
      {{0.0, glm::vec3(0, 10, 0)}, {2.0, glm::vec3(20, 10, 0)}, {4.0, glm::vec3(20, 50, 0)}},
      scene::Ease::linear);
  const sim::Strokes strokes({brush}, 1, {{60, 60}, false, "test"});
  CHECK(strokes.into(0.9, 0.1, 0).empty());
  const auto at = strokes.into(1.5, 0.25, 6);
  REQUIRE(at.size() == 1);
  CHECK(at[0].from == glm::vec2(12.5, 10));
  CHECK(at[0].to == glm::vec2(15, 10));
  const auto later = strokes.into(2.5, 0.25, 10);
  CHECK(later.at(0).from == glm::vec2(20, 15));
  CHECK(later.at(0).to == glm::vec2(20, 20));
  CHECK(strokes.into(3.5, 0.25, 14).empty());
}

TEST_CASE("keyed strokes: values set by a brush follow their keys, scaled by its strength") {
  sim::FluidParameters p;
  p.size = {40, 30};
  p.substeps = 2;
  sim::FluidStroke s;
  s.until = 4;
  s.from = s.to = {20, 15, 0};
  s.setsVelocity = s.setsTemperature = s.setsDye = true;
  s.velocity = ramp(0, glm::vec3(0), 4, glm::vec3(80, -40, 0));
  s.temperature = ramp(0, 1.0F, 4, 3.0F);
  s.dye = ramp(0, glm::vec3(0), 4, glm::vec3(1, 2, 4));
  s.force = ramp(0, glm::vec3(0), 4, glm::vec3(0, 8, 0));
  s.value = 0.25;
  s.strength = ramp(0, 0.0F, 4, 2.0F);
  p.strokes = {s};
  const sim::FluidPlan plan(p, "it", 1, 0.5);
  const auto brushes = plan.brushesAt(1.5, 2).brushes;  // brushes at the time 2 s
  REQUIRE(brushes.size() == 1);
  CHECK(brushes[0].flow == glm::vec4(40, -20, 2, 0));
  CHECK(brushes[0].dye == glm::vec4(0.5, 1, 2, 0));
  CHECK(brushes[0].reach.z == 0.25F);                // The brush acts for a quarter of a second at strength
                                                     // 1.
  CHECK(brushes[0].force == glm::vec4(0, 1, 0, 0));  // A force of 4 cells/s^2 acts for a quarter of a
                                                     // second.
  CHECK(plan.brushesAt(2.5, 2).brushes.at(0).reach.z == 0.375F);
}

TEST_CASE("keyed strokes: options that do not work with a path are reported") {
  const std::string path = R"("path": {"keys": [[0, [5, 5, 0]], [2, [25, 5, 0]]]})";
  test::checkHas(refusedStroke(R"({"from": [1, 1, 0], )" + path + "}"), "leave out \"from\"");
  test::checkHas(refusedStroke(R"({"shape": "line", )" + path + "}"), "only a circle has a path");
}

TEST_CASE("a fluid's chart: a force chart without obstacles, or with an inverted range, is reported") {
  test::checkHas(refusedFluid(R"("chart": {})"), "lift and drag need \"obstacles\"");
  CHECK(refusedFluid(R"("chart": {}, "obstacles": [{"radius": 9}])") == "none");
  CHECK(refusedFluid(R"("chart": {"curves": [{"of": "speed"}]})") == "none");
  test::checkHas(refusedFluid(R"("chart": {"low": 2, "high": 1}, "obstacles": [{"radius": 9}])"),
                 "is not above");
}

TEST_CASE(
    "a fluid that flows faster than expected gets a speed to give; a default speed has 10% more room") {
  sim::FluidParameters p;
  CHECK(sim::FluidPlan(p, "bath", 1, 1.0 / 60).fastest() == doctest::Approx(495));
  p.ownSpeed = true;
  const sim::FluidPlan plan(p, "bath", 1, 1.0 / 60);
  CHECK(plan.fastest() == 450);
  test::checkHas(plan.speedRemark(465), "reaches 465 cells/s, above \"speed\" 450 (2.6 cells per substep)");
  test::checkHas(plan.speedRemark(465), "give objects.bath.fluid.speed 520");
}
