// Surfaces merged into one in world space, against the same surfaces one by one: the same shadow map of a
// lamp.
#include "draw/exact/scene/merged_mesh.hpp"

#include "draw/exact/triangle_raster.hpp"
#include "gpu/draw/exact/stage.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include <doctest/doctest.h>
#include <glm/ext/matrix_transform.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Triangles in any place around the middle, some of them large, and one with a vertex that is no number.
TriangleStage scattered(unsigned seed, int triangles) {
  std::mt19937 engine(seed);
  const auto dice = [&] { return static_cast<float>(engine() >> 8U) * 0x1p-23F - 1.0F; };
  std::vector<glm::vec3> places;
  std::vector<unsigned> indices;
  for (int i = 0; i < 3 * triangles; ++i) {
    const float size = i % 30 < 3 ? 4.0F : 1.0F;
    const float x = dice();
    const float y = dice();
    places.push_back(size * glm::vec3(x, y, dice()));
    indices.push_back(static_cast<unsigned>(i));
  }
  places[1].x = std::numeric_limits<float>::quiet_NaN();
  return {places, indices};
}

std::vector<GLuint> mapOf(const std::vector<const sim::Surface*>& surfaces) {
  constexpr int side = 83;
  const shader::ExactView view = exactViewFrom({0.1F, 0.2F, 3}, {0.2F, -0.1F, 0}, {side, side});
  gl::Buffer block("view", sizeof view);
  block.write(0, std::as_bytes(std::span(&view, 1)));
  block.bindUniform(draw::viewBinding, 0, sizeof view);
  const draw::Visibility keys("a test", {side, side}, 1, false);
  draw::TriangleRaster raster(draw::TriangleRaster::Into::lampMap, 1, 16);
  keys.clear();
  raster.number(surfaces);
  raster.draw(keys, {.slopeOffset = 1.5F, .side = side, .firstKey = 0, .keyStride = side});
  auto found = keys.readKeys();
  found.resize(static_cast<std::size_t>(side) * side);
  testContext().check();
  return found;
}

}  // namespace

TEST_CASE("exact: one mesh of several surfaces casts their shadows, counted ones and moved ones too") {
  testContext();
  TriangleStage first = scattered(3, 67);
  TriangleStage second = scattered(5, 131);
  TriangleStage third = scattered(7, 40);
  second.surface.model = glm::rotate(glm::translate(glm::mat4(1), {0.4F, -0.3F, 0.2F}), 0.7F, {1, 2, 0.5F});
  const gl::Buffer arguments =
      gl::Buffer::of<GLuint>("arguments", std::array<GLuint, 5>{3 * 17, 1, 0, 0, 0});
  third.surface.arguments = &arguments;
  draw::MergedMesh mesh;
  for (const std::vector<const sim::Surface*>& surfaces :
       {std::vector<const sim::Surface*>{&first.surface, &second.surface, &third.surface},
        {&third.surface},
        {&second.surface, &first.surface}}) {
    const std::vector<GLuint> wanted = mapOf(surfaces);
    CHECK(std::count(wanted.begin(), wanted.end(), 0xffffffffU) < 83 * 83 - 500);
    const sim::Surface& merged = mesh.merge(surfaces);
    CHECK(mapOf({&merged}) == wanted);
  }
}
