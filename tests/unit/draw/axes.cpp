// Tests the axes at the edges of a field.
#include "draw/overlay/axes_pass.hpp"
#include "draw/overlay/field_view.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::draw;

namespace {

std::string labels(const std::vector<Tick>& ticks) {
  std::string all;
  for (const Tick& tick : ticks) all += tick.label + " ";
  return all;
}

}  // namespace

TEST_CASE("axis ticks are round numbers within the axis range") {
  CHECK(labels(ticksBetween(0.014, 0.062, 6)) == "0.02 0.03 0.04 0.05 0.06 ");
  CHECK(labels(ticksBetween(0.05F, 0.06F, 5)) == "0.050 0.052 0.054 0.056 0.058 0.060 ");
  CHECK(labels(ticksBetween(0.06, 0.05, 2)) == "0.050 0.055 0.060 ");
  CHECK(labels(ticksBetween(-10, 30, 4)) == "-10 0 10 20 30 ");
  CHECK(labels(ticksBetween(0, 1000, 10)) == "0 100 200 300 400 500 600 700 800 900 1000 ");
  CHECK(labels(ticksBetween(0, 0.01, 10)) ==
        "0.000 0.001 0.002 0.003 0.004 0.005 0.006 0.007 0.008 0.009 0.010 ");
  CHECK(labels(ticksBetween(0, 0.0021, 2)) == "0.000 0.002 ");
  CHECK(labels(ticksBetween(0, 9e15, 2)) == "0 5000000000000000 ");
  const auto falling = ticksBetween(4, 0, 2);
  REQUIRE(falling.size() == 3);
  CHECK(falling[0].label == "0");
  CHECK(falling[0].place == doctest::Approx(1));
  CHECK(falling[1].place == doctest::Approx(0.5));
  CHECK(ticksBetween(1, 1, 5).empty());
  CHECK(ticksBetween(0, 1, 0).empty());
}

TEST_CASE("a field with axes leaves room for them") {
  sim::FieldDisplay display;
  CHECK(axesMargin(display, {1280, 720}) == glm::ivec2(0, 0));
  display.across = sim::FieldDisplay::Axis{"F", 0.0F, 1.0F};
  CHECK(axesMargin(display, {1280, 720}) == glm::ivec2(0, 64));
  CHECK(fieldView(display, {100, 50}, {1280, 720}, 0).part == glm::dvec4(0, 0, 1280, 656));
  display.down = sim::FieldDisplay::Axis{"k", 0.0F, 1.0F};
  CHECK(fieldView(display, {100, 50}, {1280, 720}, 0).part == glm::dvec4(92, 0, 1280, 656));
  CHECK(axesMargin(display, {120, 90}) == glm::ivec2(0, 0));  // There is no margin, because the picture is
                                                              // too small for legible text.
}
