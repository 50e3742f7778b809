// Tests how fields are drawn: all types of cells, geometry, averages and layers.
#include "gpu/draw/field_stage.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;
using Cells = sim::Field::Cells;
using Layer = sim::FieldDisplay::Layer;
using Fit = sim::FieldDisplay::Fit;

namespace {

Picture shown(std::vector<sim::Field> fields, glm::ivec2 size, const scene::Scene& scene = darkScene()) {
  sim::Drawables drawables;
  drawables.fields = std::move(fields);
  return drawn(scene, drawables, size);
}

/// True if the pixel has this linear colour. Each sRGB value may differ by `off` steps of 1/255. The
/// default covers half a step of rounding plus the error of the power function.
bool has(const Picture& picture, int x, int y, glm::dvec3 linear, double off = 0.7) {
  const glm::ivec3 c = picture.at(x, y);
  for (int i = 0; i < 3; ++i)
    if (std::abs(c[i] - srgbByte(linear[i])) > off) {
      MESSAGE("pixel ", x, ",", y, " channel ", i, " is ", c[i], ", wanted ", srgbByte(linear[i]));
      return false;
    }
  return true;
}

int bit(int x, int y) {
  return ((x * 7 + y * 13) ^ (x * y)) % 3 == 0 ? 1 : 0;
}

}  // namespace

TEST_CASE("fields: each cell of bits, bytes or floats covers its own square of pixels, at odd sizes") {
  testContext();
  const glm::ivec2 size{37, 21};
  const std::vector<glm::vec3> stops = {{0, 0.1F, 0.9F}, {1, 0.5F, 0}, {0.2F, 1, 0.3F}};
  const auto color = [&](double t) {
    const double at = std::clamp(t, 0.0, 1.0) * 2;
    const int i = std::min(static_cast<int>(at), 1);
    return glm::dvec3(stops[i]) + (glm::dvec3(stops[i + 1]) - glm::dvec3(stops[i])) * (at - i);
  };
  for (const Cells cells : {Cells::bits, Cells::bytes, Cells::floats}) {
    const double max = cells == Cells::bits ? 1 : cells == Cells::bytes ? 255 : 3.5;
    const auto value = [&](int x, int y) {
      return cells == Cells::bits ? bit(x, y) : std::floor(max * ((x * 5 + y * 3) % 11) / 10.0 * 4) / 4;
    };
    FieldStage stage(cells, size, value, {3, 5, 2}, stops);
    stage.field.range = {0, static_cast<float>(max)};
    const auto rounded = [&](int x, int y) {
      return cells == Cells::bytes ? std::floor(value(x, y)) : value(x, y);
    };
    const Picture picture = shown({stage.field}, {size.x * 3, size.y * 3});
    int wrong = 0;
    for (int y = 0; y < size.y * 3; ++y)
      for (int x = 0; x < size.x * 3; ++x)
        wrong += has(picture, x, y, color(rounded(x / 3, y / 3) / max)) ? 0 : 1;
    CHECK(wrong == 0);
  }
}

TEST_CASE("fields: category cells have the colour of their number") {
  testContext();
  const std::vector<glm::vec3> stops = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25F, 0.5F, 1}};
  for (const Cells cells : {Cells::bytes, Cells::floats}) {
    FieldStage stage(
        cells, {13, 9}, [](int x, int y) { return (x + y) % 5; }, {3, 5, 2}, stops);
    stage.field.categories = true;
    stage.display.smooth = true;  // This option has no effect for categories.
    const Picture picture = shown({stage.field}, {26, 18});
    for (int y = 0; y < 18; ++y)
      for (int x = 0; x < 26; ++x)
        CHECK(has(picture, x, y, stops[static_cast<std::size_t>(std::min((x / 2 + y / 2) % 5, 3))]));
  }
}

TEST_CASE("fields: a pixel is the area-weighted average of the light under it") {
  testContext();
  for (const glm::ivec2 pixels :
       {glm::ivec2(16, 12), glm::ivec2(7, 5), glm::ivec2(3, 2), glm::ivec2(45, 31)}) {
    const glm::ivec2 size{32, 24};
    FieldStage stage(Cells::bits, size, bit);
    stage.display.fit = Fit::stretch;
    const Picture picture = shown({stage.field}, pixels);
    // If a pixel covers at least four cells, blocks of cells are averaged first. A block on a pixel border
    // counts by its overlap with the pixel, so the tolerance is larger.
    const double under = std::min(double(size.x) / pixels.x, double(size.y) / pixels.y);
    const double allowed = under < 4 ? 0.004 : 0.12;
    for (int py = 0; py < pixels.y; ++py)
      for (int px = 0; px < pixels.x; ++px) {
        const double x0 = double(px) * size.x / pixels.x, x1 = double(px + 1) * size.x / pixels.x;
        const double y0 = double(py) * size.y / pixels.y, y1 = double(py + 1) * size.y / pixels.y;
        double sum = 0;
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x)
            sum += bit(x, y) * std::max(0.0, std::min(x1, x + 1.0) - std::max(x0, double(x))) *
                   std::max(0.0, std::min(y1, y + 1.0) - std::max(y0, double(y)));
        const double mean = sum / ((x1 - x0) * (y1 - y0));
        CHECK(picture.at(px, py).x >= srgbByte(mean - allowed) - 1);
        CHECK(picture.at(px, py).x <= srgbByte(mean + allowed) + 1);
      }
  }
}

TEST_CASE("fields: downscaled categories average colours, not category numbers") {
  testContext();
  // Cells are red and blue. The mean of the category numbers would give green. The mean of the light gives
  // purple.
  const std::vector<glm::vec3> stops = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  FieldStage stage(
      Cells::bytes, {120, 80}, [](int x, int y) { return 2 * ((x + y) % 2); }, {3, 5, 1}, stops);
  stage.field.categories = true;
  const Picture picture = shown({stage.field}, {12, 8});
  CHECK(has(picture, 5, 4, {0.5, 0, 0.5}, 1.5));
}

TEST_CASE("fields: smooth values that are linear stay linear between cells") {
  testContext();
  FieldStage stage(Cells::floats, {4, 3}, [](int x, int y) { return 0.1 * x + 0.2 * y; });
  stage.display.smooth = true;
  const Picture picture = shown({stage.field}, {32, 24});
  for (int y = 8; y < 16; ++y)
    for (int x = 8; x < 24; ++x)
      CHECK(has(picture, x, y, glm::dvec3(0.1 * ((x + 0.5) / 8 - 0.5) + 0.2 * ((y + 0.5) / 8 - 0.5))));
  // Beyond the centre of the last cell, the value of that cell is used.
  CHECK(has(picture, 31, 12, glm::dvec3(0.3 + 0.2 * (12.5 / 8 - 0.5))));
}

TEST_CASE("fields: fit, rectangle, border and opacity are applied") {
  testContext();
  FieldStage stage(Cells::bits, {10, 10}, [](int, int) { return 1; }, {1, 0, 1}, {{0, 0, 1}, {1, 0, 0}});
  stage.display.border = {0, 1, 0};
  stage.display.fit = Fit::contain;
  Picture picture = shown({stage.field}, {40, 20});
  CHECK(has(picture, 9, 10, {0, 1, 0}));
  CHECK(has(picture, 10, 10, {1, 0, 0}));
  CHECK(has(picture, 29, 10, {1, 0, 0}));
  CHECK(has(picture, 30, 10, {0, 1, 0}));
  stage.display.fit = Fit::cover;
  picture = shown({stage.field}, {40, 20});
  CHECK(has(picture, 0, 0, {1, 0, 0}));
  CHECK(has(picture, 39, 19, {1, 0, 0}));
  // The displayed rectangle is rounded to whole pixels.
  scene::Scene scene = darkScene();
  stage.display.corner = {0.25F + 0.25F / 40, 0.5F, 0};
  stage.display.extent = {0.5F, 0.25F, 0};
  picture = shown({stage.field}, {40, 20}, scene);
  CHECK(has(picture, 9, 12, {0, 0, 0}));
  CHECK(has(picture, 10, 12, {1, 0, 0}));
  CHECK(has(picture, 29, 12, {1, 0, 0}));
  CHECK(has(picture, 30, 12, {0, 0, 0}));
  CHECK(has(picture, 15, 9, {0, 0, 0}));
  CHECK(has(picture, 15, 10, {1, 0, 0}));
  CHECK(has(picture, 15, 14, {1, 0, 0}));
  CHECK(has(picture, 15, 15, {0, 0, 0}));
  stage.display.corner = {0, 0, 0};
  stage.display.extent = {1, 1, 0};
  stage.display.opacity = 0.4F;
  picture = shown({stage.field}, {40, 20}, scene);
  CHECK(picture.at(20, 10).x == doctest::Approx(255 * 0.4).epsilon(0.01));
  stage.display.layer = Layer::none;
  CHECK(shown({stage.field}, {40, 20}, scene).brightness(20, 10) == 0);
}

TEST_CASE("fields: zoom, centre and tiling place cells at the expected pixels") {
  testContext();
  const auto value = [](int x, int y) { return (x + 8 * y) / 64.0; };
  FieldStage stage(Cells::floats, {8, 8}, value);
  stage.display.border = {0, 0, 1};
  stage.display.zoom = 2.0F;
  stage.display.center = glm::vec3(0.25F, 0.75F, 0);
  // A cell spans 8 pixels, and cell (2, 6) starts at the picture's centre.
  Picture picture = shown({stage.field}, {32, 32});
  CHECK(has(picture, 16, 16, glm::dvec3(value(2, 6))));
  CHECK(has(picture, 15, 15, glm::dvec3(value(1, 5))));
  CHECK(has(picture, 0, 0, glm::dvec3(value(0, 4))));
  CHECK(has(picture, 31, 31, glm::dvec3(value(3, 7))));
  stage.display.zoom = 0.5F;
  picture = shown({stage.field}, {32, 32});
  CHECK(has(picture, 31, 31, {0, 0, 1}));
  stage.display.tiled = true;
  picture = shown({stage.field}, {32, 32});
  // A cell spans 2 pixels, and the picture's centre is in cell (2, 6).
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      CHECK(has(picture, x, y,
                glm::dvec3(value(((x - 16) / 2 + 18 - (x < 16 && x % 2 ? 1 : 0)) % 8,
                                 ((y - 16) / 2 + 22 - (y < 16 && y % 2 ? 1 : 0)) % 8))));
}

TEST_CASE(
    "fields: fields behind are tone mapped, fields over are not, and later fields cover earlier ones") {
  testContext();
  FieldStage stage(Cells::floats, {5, 5}, [](int, int y) { return y < 2 ? 0.18 : 0.5; });
  stage.display.fit = Fit::stretch;
  stage.display.layer = Layer::behind;
  scene::Scene scene = darkScene();
  scene.sky.zenith = scene.sky.horizon = glm::vec3(5);
  GridStage sheet({5, 5}, {-0.5F, 0.5F, 0}, {1, 0, 0}, {0, -1, 0});
  sheet.material.color = glm::vec3(0.9F, 0, 0);
  const sim::Drawables both{.surfaces = {sheet.surface}, .fields = {stage.field}};
  const Picture behind = drawn(scene, both, {35, 35});
  // the field hides the sky
  CHECK(std::abs(behind.at(3, 3).y - filmByte({0.18, 0.18, 0.18})[1]) <= 2);
  CHECK(std::abs(behind.at(3, 31).y - filmByte({0.5, 0.5, 0.5})[1]) <= 2);
  CHECK(behind.at(17, 17).x >
        1.5 * behind.at(17, 17).y);  // the sheet, which reflects 4 % of the sky, hides the field
  stage.display.layer = Layer::over;
  const Picture over = drawn(scene, {.surfaces = {sheet.surface}, .fields = {stage.field}}, {35, 35});
  CHECK(has(over, 3, 3, glm::dvec3(0.18)));
  CHECK(has(over, 17, 17, glm::dvec3(0.5)));
  FieldStage later(Cells::bits, {3, 3}, [](int, int) { return 1; });
  later.display.extent = {0.5F, 1, 0};
  const Picture two = shown({stage.field, later.field}, {30, 30});
  CHECK(has(two, 10, 3, glm::dvec3(1)));
  CHECK(has(two, 20, 3, glm::dvec3(0.18)));
}

TEST_CASE("fields: relief brightens slopes towards the top left and keeps flat areas") {
  testContext();
  const auto hill = [](int x, int y) {
    return std::exp(-0.02 * ((x - 16) * (x - 16) + (y - 16) * (y - 16)));
  };
  FieldStage stage(Cells::floats, {33, 33}, hill, {3, 5, 2}, {glm::vec3(0.3F), glm::vec3(0.3F)});
  stage.display.smooth = true;
  stage.display.relief = 1;
  const Picture picture = shown({stage.field}, {99, 99});
  CHECK(picture.brightness(36, 36) > picture.brightness(62, 62) + 100);
  CHECK(has(picture, 2, 2, glm::dvec3(0.3), 2));
  CHECK(has(picture, 49, 49, glm::dvec3(0.3), 4));
  stage.display.relief = -1;
  const Picture dent = shown({stage.field}, {99, 99});
  CHECK(dent.brightness(36, 36) + 100 < dent.brightness(62, 62));
}

TEST_CASE("fields: a field tiled many times within a pixel is averaged") {
  testContext();
  FieldStage stage(Cells::bits, {5, 3}, [](int x, int) { return x < 2 ? 1 : 0; });
  stage.display.tiled = true;
  stage.display.zoom = 1e-3F;
  const Picture picture = shown({stage.field}, {33, 17});
  for (int x = 0; x < 33; ++x) CHECK(has(picture, x, x / 2, glm::dvec3(0.4), 3));
  stage.display.tiled = false;
  stage.display.border = {0.3F, 0, 0};
  CHECK(has(shown({stage.field}, {33, 17}), 1, 1, {0.3, 0, 0}));
}
