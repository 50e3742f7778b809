// Tests surfaces merged into one world-space mesh by comparison with the separate surfaces. A lamp's shadow
// map must be the same for both.
#include "draw/exact/scene/merged_mesh.hpp"

#include "draw/exact/scene/lamp_maps.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/lamp_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include <doctest/doctest.h>
#include <glm/ext/matrix_transform.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Returns random triangles around the origin, some of them large, and one with a NaN vertex.
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

constexpr int side = 83;

/// Returns a lamp's shadow map with all triangles of `meshes`. The surfaces of each element are merged.
std::vector<GLuint> mapOf(const std::vector<std::vector<const sim::Surface*>>& meshes,
                          int binRoom = draw::binnedTriangles()) {
  const shader::ExactView view = exactViewFrom({0.1F, 0.2F, 3}, {0.2F, -0.1F, 0}, {side, side});
  gl::Buffer block("view", sizeof view);
  block.write(0, std::as_bytes(std::span(&view, 1)));
  const draw::Visibility keys("a test", {side, side}, 1, false);
  draw::TriangleRaster raster(draw::TriangleRaster::Into::lampMap, 1, 16, draw::fansOfTriangles(), 0,
                              binRoom);
  draw::FaceLists lists({});
  draw::MergedMesh mesh;
  keys.clear();
  for (const auto& surfaces : meshes) {
    mesh.merge(surfaces);
    int triangles = 0;
    for (const sim::Surface* surface : surfaces)
      triangles += surface->arguments == nullptr
                       ? surface->indexCount / 3
                       : static_cast<int>(surface->arguments->readAll<GLuint>()[0]) / 3;
    const draw::MapPart part{.slopeOffset = 1.5F, .side = side, .firstKey = 0, .keyStride = side};
    raster.number(lists.all(mesh, triangles, 1), {{&block, 0, part}});
    raster.draw(keys);
  }
  auto found = keys.readKeys();
  found.resize(static_cast<std::size_t>(side) * side);
  testContext().check();
  return found;
}

/// Returns the number of triangles that are not completely outside any side of a lamp's face. The sides are
/// moved outwards by the relative tolerance `slack`.
int shownBy(const std::vector<glm::vec4>& places, const shader::Lamp& lamp, int face, double slack) {
  int count = 0;
  for (std::size_t i = 3; i < places.size(); i += 3) {
    std::array<bool, 5> beyond = {true, true, true, true, true};
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      const glm::dvec3 from = glm::dvec3(places[corner]) - glm::dvec3(lamp.place);
      const double x = (face % 2 == 0 ? 1 : -1) * from[face / 2];
      const double y = from[(face / 2 + 1) % 3] * double{lamp.maps.w};
      const double z = from[(face / 2 + 2) % 3] * double{lamp.maps.w};
      const auto before = [&](double a, double b) {
        return a - b + slack * (std::abs(a) + std::abs(b)) < 0;
      };
      const std::array<bool, 5> here = {before(x, lamp.sampling.x), before(x, y), before(x, -y),
                                        before(x, z), before(x, -z)};
      for (std::size_t k = 0; k < here.size(); ++k) beyond[k] = beyond[k] && here[k];
    }
    count += std::find(beyond.begin(), beyond.end(), true) == beyond.end() ? 1 : 0;
  }
  return count;
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
  for (const std::vector<const sim::Surface*>& surfaces :
       {std::vector<const sim::Surface*>{&first.surface, &second.surface, &third.surface},
        {&third.surface},
        {&second.surface, &first.surface}}) {
    std::vector<std::vector<const sim::Surface*>> pixelDifference;
    for (const sim::Surface* surface : surfaces) pixelDifference.push_back({surface});
    const std::vector<GLuint> wanted = mapOf(pixelDifference);
    CHECK(std::count(wanted.begin(), wanted.end(), 0xffffffffU) < side * side - 500);
    for (const int binRoom : {0, 11, 1 << 20}) CHECK(mapOf({surfaces}, binRoom) == wanted);
  }
}

TEST_CASE("exact: lists of what faces of lamps may show leave out nothing that they show") {
  testContext();
  scene::Scene scene = fromAbove();
  for (const glm::vec3 place : {glm::vec3(0.1F, -0.2F, 0.3F), glm::vec3(-0.7F, 0.6F, 0.05F)}) {
    scene.lights.push_back(lampAt(place, 3, true));
    scene.lights.back().shadowSize = side;
    scene.lights.back().shadowSoftness = 2;
  }
  TriangleStage mesh = scattered(11, 300);
  sim::Drawables drawables;
  drawables.surfaces.push_back(mesh.surface);
  draw::Lamps lamps(scene, draw::Rasterizer::exact);
  lamps.update(0, drawables);
  draw::ExactInstances instances(1, {{}, lamps.defines()});
  const auto mapsOf = [&](bool sparing, bool together = false) {
    draw::LampMaps maps(lamps, sparing, together);
    maps.draw(drawables, lamps, instances);
    testContext().check();
    return maps.keys().readKeys();
  };
  const std::vector<GLuint> wanted = mapsOf(false);
  CHECK(std::count(wanted.begin(), wanted.end(), 0xffffffffU) < 12 * side * side / 2);
  CHECK(mapsOf(true) == wanted);
  CHECK(mapsOf(true, true) == wanted);  // drawing all maps in one dispatch gives the same result
  CHECK(mapsOf(false, true) == wanted);

  draw::MergedMesh merged;
  merged.merge({&mesh.surface});
  draw::FaceLists lists(lamps.shadowDefines());
  const std::vector<glm::vec4> places = mesh.positions.readAll<glm::vec4>();
  const std::vector<GLuint> counts = lists.find(merged, 0, 12).counts->readAll<GLuint>();
  for (int face = 0; face < 12; ++face) {
    CAPTURE(face);
    const shader::Lamp& lamp = lamps.values()[static_cast<std::size_t>(face / 6)];
    const auto listed = static_cast<int>(counts[static_cast<std::size_t>(face)]);
    CHECK(listed >= shownBy(places, lamp, face % 6, -1e-4));
    CHECK(listed <= shownBy(places, lamp, face % 6, 1e-4) + 1);  // The list may also contain the triangle
                                                                 // with the NaN vertex.
  }
}
