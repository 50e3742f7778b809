// Tests skins as tileable maps. Shifting the field must shift the maps, borders must match, and colours and
// normals must equal those on surfaces.
#include "draw/surface/skin_maps.hpp"

#include "draw/overlay/field_textures.hpp"
#include "draw/surface/skin_look.hpp"
#include "gpu/draw/skin_stage.hpp"

#include <algorithm>
#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

using Look = scene::Skin::Look;
using Cells = sim::Field::Cells;

draw::SkinMaps mapsOf(const scene::Material& material, const FieldStage& field, glm::ivec2 size) {
  testContext();
  const scene::Scene scene = roomWith(material);
  draw::FieldTextures fields(scene);
  draw::SkinTextures skins(scene);
  draw::SkinMapper mapper;
  sim::Drawables drawables;
  drawables.fields.push_back(field.field);
  fields.update(drawables);
  skins.update(fields);
  const draw::SkinTextures::Entry* entry = skins.find(*material.skin);
  REQUIRE(entry != nullptr);
  draw::SkinMaps maps = mapper.draw(*entry, *material.skin, size);
  testContext().check();
  return maps;
}

float pixelDifference(const glm::vec4& a, const glm::vec4& b) {
  const glm::vec4 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z, d.w});
}

/// Sorted differences between neighbouring texels, horizontally and vertically. Separate lists hold the
/// differences inside the map and those across its border.
struct Steps {
  std::vector<float> inside, seam;
};
Steps stepsOf(const std::vector<glm::vec4>& texels, glm::ivec2 size) {
  Steps steps;
  const auto at = [&](int x, int y) {
    return texels[static_cast<std::size_t>((y % size.y) * size.x + x % size.x)];
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      (x + 1 == size.x ? steps.seam : steps.inside).push_back(pixelDifference(at(x, y), at(x + 1, y)));
      (y + 1 == size.y ? steps.seam : steps.inside).push_back(pixelDifference(at(x, y), at(x, y + 1)));
    }
  std::sort(steps.inside.begin(), steps.inside.end());
  std::sort(steps.seam.begin(), steps.seam.end());
  return steps;
}

float fraction(const std::vector<float>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

TEST_CASE("skin maps: rolling the field by half rolls the maps by exactly half") {
  testContext();
  const auto value = [](int x, int y) { return waves(x / 62.0, y / 46.0); };
  const FieldStage field(Cells::floats, {62, 46}, value);
  const FieldStage rolled(Cells::floats, {62, 46},
                          [&](int x, int y) { return value((x + 31) % 62, (y + 23) % 46); });
  for (const Look look : {Look::leather, Look::spots, Look::cracks, Look::map})
    for (const int scale : {1, 3}) {
      CAPTURE(scale);
      const glm::ivec2 size = glm::ivec2(62, 46) * (2 * scale);
      const draw::SkinMaps a = mapsOf(grown(look), field, size);
      const draw::SkinMaps b = mapsOf(grown(look), rolled, size);
      float max = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const auto here = static_cast<std::size_t>(y * size.x + x);
          const auto there =
              static_cast<std::size_t>((y + size.y / 2) % size.y * size.x + (x + size.x / 2) % size.x);
          const glm::vec4 glow = glm::max(glm::vec4(draw::lookOf(*grown(look).skin).high, 1), glm::vec4(1));
          max = std::max({max, pixelDifference(a.surface[there], b.surface[here]),
                          pixelDifference(a.relief[there], b.relief[here]),
                          pixelDifference(a.light[there] / glow, b.light[here] / glow)});
        }
      CHECK(max < 0.5F / 255);  // The texture unit rounds the sampling position to 1/256 texel.
    }
}

TEST_CASE("skin maps: differences across the border are no larger than those inside") {
  testContext();
  const FieldStage field(Cells::floats, {61, 47}, [](int x, int y) { return waves(x / 61.0, y / 47.0); });
  for (const Look look : {Look::leather, Look::cracks, Look::map})
    for (const glm::ivec2 size : {glm::ivec2(61, 47), glm::ivec2(203, 155), glm::ivec2(37, 29)}) {
      CAPTURE(size.x);
      const draw::SkinMaps maps = mapsOf(grown(look), field, size);
      for (const auto* texels : {&maps.surface, &maps.relief, &maps.light}) {
        const Steps steps = stepsOf(*texels, size);
        CHECK(steps.seam.back() <= steps.inside.back() + 1e-3F);
        CHECK(fraction(steps.seam, 0.99) <= fraction(steps.inside, 0.998) + 1e-3F);
      }
    }
}

TEST_CASE("skin maps: heights and normals on a slope equal their closed form") {
  testContext();
  // The field is a triangle wave of 64 cells. It rises by 1/32 per cell up to the middle, then falls. The
  // height of its relief is `depth` cells.
  const FieldStage field(Cells::floats, {64, 6},
                         [](int x, int) { return x < 32 ? x / 32.0 : (64 - x) / 32.0; });
  scene::Material material = grown(Look::map);
  const float depth = draw::lookOf(*material.skin).depth;
  const draw::SkinMaps maps = mapsOf(material, field, {64, 6});
  const glm::vec3 up = glm::normalize(glm::vec3(-depth / 32, 0, 1));
  const glm::vec3 down = glm::normalize(glm::vec3(depth / 32, 0, 1));
  for (int x = 0; x < 64; ++x) {
    const glm::vec4 relief = maps.relief[static_cast<std::size_t>(2 * 64 + x)];
    CHECK(relief.w == doctest::Approx(x < 32 ? x / 32.0 : (64 - x) / 32.0).epsilon(0.002));
    if (x % 32 != 0) CHECK(glm::distance(glm::vec3(relief), x < 32 ? up : down) < 1e-3F);
  }
  // NaN and values more than one range width below the range are clamped to one range width below the
  // range.
  const FieldStage lost(Cells::floats, {12, 6}, [](int x, int) {
    return x == 3 ? std::numeric_limits<double>::quiet_NaN() : x == 8 ? -7.0 : 0.25;
  });
  const draw::SkinMaps pits = mapsOf(material, lost, {12, 6});
  const glm::vec3 into = glm::normalize(glm::vec3(depth * 0.625F, 0, 1));
  for (const std::size_t x : {2, 7}) {
    CHECK(glm::distance(glm::vec3(pits.relief[2 * 12 + x]), into) < 1e-3F);
    CHECK(glm::distance(glm::vec3(pits.relief[2 * 12 + x + 2]), glm::vec3(-into.x, 0, into.z)) < 1e-3F);
  }
  // The wave varies along the rows' direction. The y axis of the normal points up, in the direction of
  // decreasing row indices.
  const FieldStage rows(Cells::floats, {6, 64},
                        [](int, int y) { return y < 32 ? y / 32.0 : (64 - y) / 32.0; });
  const draw::SkinMaps tall = mapsOf(material, rows, {6, 64});
  CHECK(tall.relief[10 * 6].y == doctest::Approx(-up.x).epsilon(0.01));
  CHECK(tall.relief[50 * 6].y == doctest::Approx(up.x).epsilon(0.01));
  // With a negative bump, normal and height are inverted.
  material.skin->bump = -1;
  const draw::SkinMaps sunk = mapsOf(material, field, {64, 6});
  CHECK(sunk.relief[10].x == doctest::Approx(-up.x).epsilon(0.01));
  CHECK(sunk.relief[10].w == doctest::Approx(1 - 10 / 32.0).epsilon(0.002));
}
