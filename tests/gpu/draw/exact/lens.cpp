// Tests depth of field through the coverage of pixels by a sheet in front of the sky, seen through a lens.
#include "draw/lens.hpp"

#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"

#include <bit>
#include <cmath>
#include <optional>

#include <doctest/doctest.h>

using namespace simreel;  // NOLINT

namespace {

struct Covered {
  double area = 0;                  ///< covered area in pixels
  glm::dvec2 middle{0}, spread{0};  ///< mean and variance of the covered positions (pixels)
  std::vector<float> light;
};

Covered coveredBy(const scene::Scene& scene, const sim::Drawables& drawables, glm::ivec2 size, int rows,
                  const char* part) {
  draw::Renderer renderer(scene, size, 4,
                          {.rasterizer = scene::Rasterizer::exact,
                           .visibilityBytes = static_cast<std::size_t>(8 * 4 * size.x * rows)});
  draw::PassPicture kept;
  renderer.keepPasses(&kept);
  renderer.draw(0, drawables);
  Covered covered;
  for (const draw::PassArray& array : kept.arrays) {
    if (array.pass != "light" || array.part != part) continue;
    glm::dvec2 squares(0);
    for (std::size_t i = 0; i < array.words.size(); ++i) {
      covered.light.push_back(std::bit_cast<float>(array.words[i]));
      if (i % 4 != 3) continue;
      const auto share = static_cast<double>(covered.light.back());
      const auto pixel = static_cast<int>(i / 4);
      const glm::dvec2 at(pixel % size.x, pixel / size.x);
      covered.area += share;
      covered.middle += share * at;
      squares += share * at * at;
    }
    covered.middle /= covered.area;
    covered.spread = squares / covered.area - covered.middle * covered.middle;
  }
  return covered;
}

}  // namespace

TEST_CASE("exact: a lens spreads what is out of focus as its opening, and keeps what it covers") {
  testContext();
  const TriangleStage sheet(
      {{-0.2F, -0.15F, -1}, {0.2F, -0.15F, -1}, {-0.2F, 0.15F, -1}, {0.2F, 0.15F, -1}}, {0, 1, 2, 2, 1, 3},
      std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  sim::Drawables drawables;
  drawables.surfaces = {sheet.surface};
  scene::Scene scene;
  scene.sun.shadow = false;
  scene.camera.position = glm::vec3(0, 0, 3);  // The camera is 4 m from the sheet.
  scene.camera.target = glm::vec3(0, 0, -1);
  const glm::ivec2 size(191, 143);
  scene.camera.lens.emplace();
  scene.camera.lens->fNumber = 0.06F;
  scene.camera.lens->samples = 37;
  for (const int blades : {0, 5})
    for (const float focus : {2.5F, 4.0F, 7.0F}) {
      CAPTURE(blades);
      CAPTURE(focus);
      scene.camera.lens->blades = blades;
      scene.camera.lens->focus = focus;
      const Covered seen = coveredBy(scene, drawables, size, size.y, "lens");
      const draw::View view = draw::viewAt(scene.camera, 0, size, {});
      // Variance of a box of the sheet's size in the picture, plus the variance of a pixel, which is
      // another box.
      const glm::dvec2 sides =
          glm::dvec2(0.4, 0.3) * (0.5 * size.y / (4 * static_cast<double>(view.reach.y)));
      CHECK(seen.area == doctest::Approx(sides.x * sides.y).epsilon(focus == 4 ? 0.04 : 0.01));
      // Displacement of the picture (pixels) per metre on the lens. It is half the picture's height,
      // divided by the tangent of half the angle of view, times the difference of the inverse distances of
      // focal plane and sheet.
      const double by = std::abs(1 / static_cast<double>(focus) - 0.25) * 0.5 * size.y /
                        static_cast<double>(view.reach.y);
      glm::dvec2 mean(0), squares(0);
      for (const draw::LensPoint& point : draw::lensPoints(scene.camera, view, 0)) {
        const glm::dvec2 at(point.aside.x, -point.aside.y);
        mean += by * at / 37.0;
        squares += by * by * at * at / 37.0;
      }
      if (focus > 4) mean = -mean;
      // Each pixel looks through its own points of squares around the lens points.
      const glm::dvec3 shift(draw::lensShift(scene.camera, view, size, focus, 0));
      const double radius =
          shift.x * static_cast<double>(focus) / (0.5 * size.y / static_cast<double>(view.reach.y));
      squares += by * by * radius * radius * shift.z * shift.z / 12.0;
      CHECK(seen.middle.x - 0.5 * (size.x - 1) ==
            doctest::Approx(mean.x).epsilon(0.02).scale(focus == 4 ? 30 : 10));
      CHECK(seen.middle.y - 0.5 * (size.y - 1) ==
            doctest::Approx(mean.y).epsilon(0.02).scale(focus == 4 ? 30 : 10));
      const glm::dvec2 more = seen.spread - (sides * sides + 1.0) / 12.0, expected = squares - mean * mean;
      CHECK(more.x == doctest::Approx(expected.x).epsilon(0.02).scale(focus == 4 ? 30 : 10));
      CHECK(more.y == doctest::Approx(expected.y).epsilon(0.02).scale(focus == 4 ? 30 : 10));
      if (focus != 4.0F) CHECK(expected.x > 5);
      CHECK(coveredBy(scene, drawables, size, 17, "lens").light == seen.light);  // drawing in bands gives
                                                                                 // the same light
    }
}

TEST_CASE("exact: few points of a lens show grain instead of the edges of their views") {
  testContext();
  const TriangleStage sheet({{-3, -3, -1}, {0, -3, -1}, {-3, 3, -1}, {0, 3, -1}}, {0, 1, 2, 2, 1, 3},
                            std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  sim::Drawables drawables;
  drawables.surfaces = {sheet.surface};
  scene::Scene scene;
  scene.sun.shadow = false;
  scene.camera.position = glm::vec3(0, 0, 3);
  scene.camera.target = glm::vec3(0, 0, -1);
  const glm::ivec2 size(160, 120);
  scene.camera.lens.emplace();
  scene.camera.lens->fNumber = 0.04F;
  scene.camera.lens->samples = 8;
  scene.camera.lens->focus = 8.0F;
  const Covered seen = coveredBy(scene, drawables, size, size.y, "lens");
  // The coverage falls from 1 to 0 across the vertical edge. Without grain, the mean of each column steps
  // by 1/8 at the edge of each view.
  double widest = 0, before = 1;
  for (int x = 0; x < size.x; ++x) {
    double mean = 0;
    for (int y = 20; y < 100; ++y)
      mean += static_cast<double>(seen.light[static_cast<std::size_t>(4 * (y * size.x + x) + 3)]) / 80;
    widest = std::max(widest, before - mean);
    before = mean;
  }
  CHECK(before == 0);
  CHECK(widest < 0.1);
}

TEST_CASE("exact: a lens adds each of its points once, in equal parts") {
  testContext();
  const TriangleStage sheet({{-9, 0, -4}, {9, 0, -4}, {-9, 0, 3}, {9, 0, 3}}, {0, 2, 1, 1, 2, 3});
  sim::Drawables drawables;
  drawables.surfaces = {sheet.surface};
  scene::Scene scene;
  scene.camera.position = glm::vec3(0.3F, 1.6F, 4);
  const glm::ivec2 size(45, 31);
  const Covered sharp = coveredBy(scene, drawables, size, size.y, "");
  // The aperture is so small that all lens points coincide.
  scene.camera.lens.emplace();
  scene.camera.lens->fNumber = 1e9F;
  for (const int samples : {2, 3, 16}) {
    scene.camera.lens->samples = samples;
    const Covered seen = coveredBy(scene, drawables, size, size.y, "lens");
    REQUIRE(seen.light.size() == sharp.light.size());
    float maximum = 0;
    for (std::size_t i = 0; i < seen.light.size(); ++i)
      maximum = std::max(maximum, std::abs(seen.light[i] - sharp.light[i]));
    CHECK(maximum < 1e-5F);
  }
}
