// Tests the position of a field's cells in a picture.
#include "draw/overlay/field_view.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using Fit = sim::FieldDisplay::Fit;

TEST_CASE("a field fits into its rectangle of the picture") {
  sim::FieldDisplay display;
  display.fit = Fit::contain;
  draw::FieldView view = draw::fieldView(display, {100, 50}, {400, 400}, 0);
  CHECK(view.perPixel == glm::dvec2(0.25));
  CHECK(view.origin == glm::dvec2(0, -25));  // there is a border of 100 pixels above the field
  CHECK(view.part == glm::dvec4(0, 0, 400, 400));
  display.fit = Fit::cover;
  view = draw::fieldView(display, {100, 50}, {400, 400}, 0);
  CHECK(view.perPixel == glm::dvec2(0.125));
  CHECK(view.origin == glm::dvec2(25, 0));
  display.fit = Fit::stretch;
  view = draw::fieldView(display, {100, 50}, {400, 400}, 0);
  CHECK(view.perPixel == glm::dvec2(0.25, 0.125));
  CHECK(view.origin == glm::dvec2(0, 0));
}

TEST_CASE("zooming keeps the field's centre in the middle of the rectangle") {
  sim::FieldDisplay display;
  display.corner = {0.5F, 0.25F, 0};
  display.extent = {0.5F, 0.5F, 0};
  display.center = glm::vec3(0.25F, 0.75F, 0);
  display.zoom = scene::Animated<float>({{0.0, 1.0F}, {2.0, 9.0F}}, scene::Ease::linear);
  for (const double seconds : {0.0, 0.7, 2.0}) {
    const draw::FieldView view = draw::fieldView(display, {640, 360}, {641, 363}, seconds);
    const glm::dvec2 middle(0.5 * (view.part.x + view.part.z), 0.5 * (view.part.y + view.part.w));
    const glm::dvec2 cell = view.origin + view.perPixel * middle;
    CHECK(cell.x == doctest::Approx(160));
    CHECK(cell.y == doctest::Approx(270));
  }
  CHECK(draw::fieldView(display, {640, 360}, {641, 363}, 2).perPixel.x * 9 ==
        doctest::Approx(draw::fieldView(display, {640, 360}, {641, 363}, 0).perPixel.x));
}

TEST_CASE("at integer magnifications cells start at pixel borders, for any picture size") {
  sim::FieldDisplay display;
  display.fit = Fit::contain;
  const draw::FieldView view = draw::fieldView(display, {33, 20}, {101, 60}, 0);
  CHECK(view.perPixel == glm::dvec2(1.0 / 3));
  CHECK(view.origin.x * 3 == doctest::Approx(-1));
  CHECK(view.origin.y == doctest::Approx(0));
}
