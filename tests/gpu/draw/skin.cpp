// Tests materials generated from fields ("skins") on surfaces: colours, relief, projections, seams, and
// patterns that are finer than pixels.
#include "draw/surface/skin_look.hpp"
#include "gpu/draw/skin_stage.hpp"
#include "sim/mesh/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <doctest/doctest.h>
#include <glm/ext/matrix_transform.hpp>

using namespace simreel;

namespace {

using Look = scene::Skin::Look;
using Cells = sim::Field::Cells;

/// Draws `mesh` with the skin material from a distance of 5 m.
Picture worn(const scene::Material& material, const FieldStage& field, const sim::Mesh& mesh = squareMesh(),
             const std::function<void(scene::Scene&, sim::Surface&)>& change = {},
             glm::ivec2 size = {131, 131}) {
  MeshStage stage(mesh);
  stage.material = material;
  scene::Scene scene = roomWith(material);
  if (change) change(scene, stage.surface);
  sim::Drawables drawables;
  drawables.surfaces.push_back(stage.surface);
  drawables.fields.push_back(field.field);
  drawables.fields.back().display = nullptr;
  return drawn(scene, drawables, size, 1);
}

scene::Material plain(const glm::vec3& color, float roughness) {
  scene::Material material;
  material.color = color;
  material.roughness = roughness;
  return material;
}

}  // namespace

TEST_CASE("skin: a constant field gives the plain colour and the surface's own normal") {
  testContext();
  for (const double value : {0.0, 1.0}) {
    const FieldStage field(Cells::floats, {37, 23}, [&](int, int) { return value; });
    const auto look = draw::lookOf(*grown(Look::leather).skin);
    const auto oblique = [](scene::Scene& scene, sim::Surface&) {
      scene.sun.direction = glm::vec3(0.6F, 0.3F, 0.5F);
    };
    const Picture skin = worn(grown(Look::leather), field, squareMesh(), oblique);
    const Picture expected =
        worn(plain(value == 0.0 ? look.low : look.high, look.roughness), field, squareMesh(), oblique);
    CHECK(skin.brightness(65, 65) > 60);
    CHECK(maxDifference(skin, expected) <= 1);
  }
}

TEST_CASE("skin: a step in the field is an edge between two colours, one pixel wide") {
  testContext();
  // The transition takes place within one cell, which covers ten pixels.
  const FieldStage field(Cells::floats, {8, 5}, [](int x, int) { return x >= 4 ? 1.0 : 0.0; });
  scene::Material material = grown(Look::leather);
  material.skin->bump = 0;
  material.skin->low = glm::vec3(0, 0.5F, 0);
  material.skin->high = glm::vec3(0.5F, 0, 0);
  const Picture picture = worn(material, field);
  int between = 0;
  for (int x = 40; x < 90; ++x) {
    const glm::ivec3 c = picture.at(x, 65);
    const bool low = c.y > 150 && c.x < 90;
    const bool high = c.x > 150 && c.y < 90;
    between += !low && !high;
    if (x < 60) CHECK(low);
    if (x > 70) CHECK(high);
  }
  CHECK(between <= 2);
  CHECK(between >= 1);  // the edge is antialiased
}

TEST_CASE("skin: the threshold is a field value, and its default is the middle of the range") {
  testContext();
  FieldStage field(Cells::floats, {64, 4}, [](int x, int) { return 10.0 + x; });
  field.field.range = {10, 74};
  scene::Material material = grown(Look::spots);
  material.skin->bump = 0;
  material.skin->low = glm::vec3(0);
  material.skin->high = glm::vec3(1);
  const auto edge = [&] {
    const Picture picture = worn(material, field, squareMesh(), {}, {257, 129});
    int lit = 0;
    for (int x = 0; x < 257; ++x) lit += picture.brightness(x, 64) > 300;
    return lit;
  };
  const int middle = edge();  // The default threshold is the middle of the range.
  material.skin->threshold = 58.5;
  const int quarter = edge();
  CHECK(quarter == doctest::Approx(middle / 2.0).epsilon(0.1));
}

TEST_CASE("skin: relief shades the same way for mirrored uvs and on both faces") {
  testContext();
  // There is one ridge in the middle, along y. It is mirror-symmetric.
  const FieldStage field(Cells::floats, {32, 32}, [](int x, int) {
    return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (x + 0.5) / 32);
  });
  scene::Material material = grown(Look::leather);
  material.skin->low = material.skin->high = glm::vec3(0.5F);
  const auto fromRight = [](scene::Scene& scene, sim::Surface&) {
    scene.sun.direction = glm::vec3(1, 0, 1);
  };
  const auto fromBehind = [](scene::Scene& scene, sim::Surface& surface) {
    scene.sun.direction = glm::vec3(1, 0, 1);
    surface.doubleSided = true;
    surface.model = glm::rotate(glm::mat4(1), std::numbers::pi_v<float>, glm::vec3(0, 1, 0));
  };
  for (const float bump : {-2.0F, 2.0F}) {
    CAPTURE(bump);
    material.skin->bump = bump;
    const float raised = bump < 0 ? 1 : -1;  // For the look of leather, high values are low.
    for (const bool mirrored : {false, true}) {
      CAPTURE(mirrored);
      const Picture front = worn(material, field, squareMesh(mirrored), fromRight);
      CHECK(raised * static_cast<float>(front.brightness(82, 65) - front.brightness(48, 65)) > 60);
      const Picture back = worn(material, field, squareMesh(mirrored), fromBehind);
      CHECK(raised * static_cast<float>(back.brightness(82, 65) - back.brightness(48, 65)) > 60);
    }
  }
  // The ridge runs across v and is seen from above. Rows of the field run downwards.
  const FieldStage across(Cells::floats, {32, 32}, [](int, int y) {
    return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (y + 0.5) / 32);
  });
  material.skin->bump = -2;
  const Picture above = worn(material, across, squareMesh(), [](scene::Scene& scene, sim::Surface&) {
    scene.sun.direction = glm::vec3(0, 1, 1);
  });
  CHECK(above.brightness(65, 48) - above.brightness(65, 82) > 60);
}

TEST_CASE("skin: triplanar projection of a square equals its uv projection, and a mesh needs no uvs") {
  testContext();
  const FieldStage field(Cells::floats, {96, 48}, [](int x, int y) { return waves(x / 96.0, y / 48.0); });
  scene::Material material = grown(Look::leather);
  const auto oblique = [](scene::Scene& scene, sim::Surface&) {
    scene.sun.direction = glm::vec3(0.6F, 0.4F, 0.5F);
  };
  // 96 x 48 cells cover 2 m x 1 m and repeat twice vertically, so half a copy of the field covers a metre.
  sim::Mesh byUv = squareMesh();
  for (std::size_t i = 0; i < byUv.uvs.size(); ++i)
    byUv.uvs[i] = {0.5F * byUv.positions[i].x, -byUv.positions[i].y};
  const Picture expected = worn(material, field, byUv, oblique);
  material.skin->projection = scene::Skin::Projection::triplanar;
  material.skin->repeats = 0.5F;
  CHECK(maxDifference(worn(material, field, byUv, oblique), expected) <= 2);
  byUv.uvs.clear();
  material.skin->projection = scene::Skin::Projection::uv;
  CHECK(maxDifference(worn(material, field, byUv, oblique), expected) <= 2);
  // The sphere needs all three projection planes, because the pattern must be visible on every side.
  sim::Mesh sphere = sim::sphereMesh(1.0F, {49, 25});
  sphere.uvs.clear();
  material.skin->bump = 0;
  material.skin->low = glm::vec3(0);
  material.skin->high = glm::vec3(1);
  for (const glm::vec3 eye :
       {glm::vec3(4, 0, 0), glm::vec3(0, 4, 0.1F), glm::vec3(0, 0, 4), glm::vec3(-3, -2, 2)}) {
    const Picture picture = worn(material, field, sphere, [&](scene::Scene& scene, sim::Surface&) {
      scene.camera.position = eye;
      scene.sun.direction = eye;
    });
    int dark = 0;
    int bright = 0;
    for (int y = 55; y < 76; ++y)
      for (int x = 55; x < 76; ++x) ++(picture.brightness(x, y) > 380 ? bright : dark);
    CHECK(dark > 40);
    CHECK(bright > 40);
  }
}

TEST_CASE("skin: a sphere and a torus show no seam") {
  testContext();
  // The seam is in front. If the mesh is turned by half a turn and the field is shifted by half its width,
  // the picture stays the same and the seam is behind.
  const auto value = [](int x, int y) { return waves(x / 64.0, y / 32.0); };
  const FieldStage field(Cells::floats, {64, 32}, value);
  const FieldStage rolled(Cells::floats, {64, 32}, [&](int x, int y) { return value(x + 32, y); });
  const auto lit = [](scene::Scene& scene, sim::Surface&) {
    scene.sun.direction = glm::vec3(0.5F, 0.5F, 1);
  };
  const auto turned = [&](scene::Scene& scene, sim::Surface& surface) {
    lit(scene, surface);
    surface.model = glm::rotate(glm::mat4(1), std::numbers::pi_v<float>, glm::vec3(0, 1, 0));
  };
  for (const sim::Mesh& mesh : {sim::sphereMesh(1.5F, {65, 33}), sim::torusMesh(1.0F, 0.5F, {65, 33})}) {
    const Picture seam = worn(grown(Look::leather), field, mesh, lit);
    const Picture none = worn(grown(Look::leather), rolled, mesh, turned);
    int pixelDifference = 0;
    int max = 0;
    for (int y = 0; y < 131; ++y)
      for (int x = 0; x < 131; ++x) {
        const int difference = std::abs(seam.brightness(x, y) - none.brightness(x, y));
        pixelDifference += difference > 12;
        max = std::max(max, difference);
      }
    CAPTURE(max);
    CHECK(pixelDifference <= 8);  // Triangle edges may be rasterized one pixel apart.
    CHECK(seam.brightness(65, 45) > 30);
  }
}

TEST_CASE("skin: a pattern finer than pixels shows its mean, not noise") {
  testContext();
  const FieldStage field(Cells::floats, {64, 64}, [](int x, int y) {
    return ((static_cast<unsigned>(x) * 7919U + static_cast<unsigned>(y) * 104729U) >> 3 & 3U) == 0 ? 1.0
                                                                                                    : 0.0;
  });
  scene::Material material = grown(Look::spots);
  material.skin->bump = 0;
  material.skin->low = glm::vec3(0.0F);
  material.skin->high = glm::vec3(0.8F);
  material.skin->repeats = 60;
  const Picture picture = worn(material, field);
  double sum = 0;
  double squares = 0;
  int count = 0;
  for (int y = 50; y < 80; ++y)
    for (int x = 50; x < 80; ++x) {
      const double b = picture.brightness(x, y);
      sum += b;
      squares += b * b;
      ++count;
    }
  const double mean = sum / count;
  const double deviation = std::sqrt(squares / count - mean * mean);
  const Picture quarter = worn(plain(glm::vec3(0.2F), 0.75F), field);
  CHECK(mean == doctest::Approx(quarter.brightness(65, 65)).epsilon(0.25));
  CHECK(deviation < 6);
}

TEST_CASE("skin: the look map shows the field's own colours") {
  testContext();
  const FieldStage field(Cells::floats, {2, 2}, [](int, int) { return 0.5; }, {3, 5, 2},
                         {glm::vec3(1, 0, 0), glm::vec3(0, 0.6F, 0.3F), glm::vec3(0, 0, 1)});
  const auto look = draw::lookOf(*grown(Look::map).skin);
  CHECK(maxDifference(worn(grown(Look::map), field), worn(plain({0, 0.6F, 0.3F}, look.roughness), field)) <=
        1);
  FieldStage states(Cells::bytes, {5, 3}, [](int, int) { return 1.0; }, {3, 5, 2},
                    {glm::vec3(1, 0, 0), glm::vec3(0.1F, 0.2F, 0.7F), glm::vec3(0, 0, 1)});
  states.field.categories = true;
  states.field.range = {0, 2};
  CHECK(maxDifference(worn(grown(Look::map), states),
                      worn(plain({0.1F, 0.2F, 0.7F}, look.roughness), states)) <= 1);
}

TEST_CASE("skin: only the cracks look glows in the dark") {
  testContext();
  const FieldStage field(Cells::floats, {4, 4}, [](int, int) { return 1.0; });
  const auto dark = [](scene::Scene& scene, sim::Surface&) { scene.sun.intensity = 0.0F; };
  CHECK(worn(grown(Look::cracks), field, squareMesh(), dark).brightness(65, 65) > 300);
  CHECK(worn(grown(Look::leather), field, squareMesh(), dark).brightness(65, 65) < 10);
}

TEST_CASE("skin: cracks glow in proportion to the field's excess over the threshold") {
  testContext();
  scene::Material material = grown(Look::cracks);
  material.skin->bump = 0;
  material.skin->high = glm::vec3(0.5F, 0.3F, 0.15F);
  const auto dark = [](scene::Scene& scene, sim::Surface&) { scene.sun.intensity = 0.0F; };
  // For the last pair, hardly any value is above the threshold. The width of the range above it is clamped
  // to at least 0.05.
  for (const auto& [threshold, value] :
       {std::pair(0.4, 0.3), {0.4, 0.45}, {0.4, 0.6}, {0.4, 0.8}, {0.4, 1.0}, {0.97, 1.0}}) {
    CAPTURE(threshold);
    CAPTURE(value);
    FieldStage field(Cells::floats, {4, 4}, [&value = value](int, int) { return value; });
    field.field.range = {0, 1};
    material.skin->threshold = threshold;
    const Picture picture = worn(material, field, squareMesh(), dark);
    glm::dvec3 mean(0);
    for (int y = 55; y < 75; ++y)
      for (int x = 55; x < 75; ++x) mean += glm::dvec3(picture.at(x, y)) / 400.0;
    const double heat = std::clamp((value - threshold) / std::max(1 - threshold, 0.05), 0.0, 1.0);
    const double glow = value > threshold ? 0.3 + 0.7 * heat * heat * (3 - 2 * heat) : 0.0;
    const auto wanted = filmByte({0.5 * glow, 0.3 * glow, 0.15 * glow});
    for (int i = 0; i < 3; ++i) CHECK(std::abs(mean[i] - wanted[static_cast<std::size_t>(i)]) < 0.4);
  }
}

TEST_CASE("skin: grids can have skins; NaN values and missing fields are harmless") {
  testContext();
  const FieldStage lost(Cells::floats, {9, 7}, [](int x, int) {
    return x % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : x % 3 == 1 ? 1e38 : -1e38;
  });
  for (const Look look : {Look::leather, Look::spots, Look::cracks, Look::map}) {
    GridStage sheet({5, 4}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
    sheet.material = grown(look);
    sheet.material.skin->bump = 0;
    const scene::Scene scene = roomWith(sheet.material);
    sim::Drawables drawables{.surfaces = {sheet.surface}, .fields = {lost.field}};
    drawables.fields.back().display = nullptr;
    CHECK(drawn(scene, drawables, {65, 65}).brightness(2, 2) == 0);
    // Without the field, the surface is drawn as if it had no skin.
    const Picture bare = drawn(scene, {.surfaces = {sheet.surface}}, {65, 65});
    sheet.material.skin.reset();
    CHECK(maxDifference(bare, drawn(scene, {.surfaces = {sheet.surface}}, {65, 65})) == 0);
  }
}
