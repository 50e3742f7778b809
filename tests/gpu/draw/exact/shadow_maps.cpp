// Tests shadow maps. Balls are compared with double precision, mesh copies with a surface of the same
// triangles, and edges of shadows with traced rays.
#include "draw/exact/instances/ball_raster.hpp"
#include "draw/exact/instances/copy_raster.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gpu/draw/exact/instance_stage.hpp"
#include "gpu/draw/exact/ray_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/lamp_stage.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using Shape = sim::Instances::Shape;

namespace {

/// A shadow map a few metres wide and deep. The objects extend beyond it on all sides.
struct SunMapStage {
  explicit SunMapStage(int texels = 149)
      : side(texels), stage(sideScene(), {side, side}, 1), map("a test", {side, side}, 1, false) {
    const float across = 5;
    const float deep = 4;
    const glm::vec3 sun(0.48F, 0.6F, 0.64F);
    rows = {glm::vec4(glm::vec3(0.8F, 0, -0.6F) / across, 0.47F),
            glm::vec4(glm::vec3(-0.36F, 0.8F, -0.48F) / across, 0.55F), glm::vec4(-sun / deep, 0.52F),
            glm::vec4(across / static_cast<float>(side), across, deep, 0), glm::vec4(0)};
    light = gl::Buffer::of<glm::vec4>("light", rows);
    view = gl::Texture::view("light", GL_RGBA32F, light);
  }
  void clear() {
    stage.clear();
    view.bind(draw::lightUnit);
    map.clear();
    gl::barrier();
  }
  /// Returns the keys of the map, row by row.
  [[nodiscard]] std::vector<unsigned> keys() const {
    testContext().check();
    std::vector<unsigned> found = map.readKeys();
    found.resize(static_cast<std::size_t>(side) * side);
    return found;
  }

  int side;
  ExactStage stage;
  draw::Visibility map;
  std::vector<glm::vec4> rows;
  gl::Buffer light;
  gl::Texture view;
};

/// Returns positions inside and outside the map, in front of it and behind it, with masses over five
/// decades.
std::vector<glm::vec4> spread(int count, std::uint32_t seed) {
  Dice dice(seed);
  std::vector<glm::vec4> places;
  for (int i = 0; i < count; ++i)
    places.emplace_back(3.1F * dice.cube(), std::pow(10.0F, 5 * dice() * dice() - 2));
  return places;
}

/// Returns the root of the mean square of the difference between the pictures with shadow maps and with
/// traced rays, relative to the largest light. Rays start at the centres of pixels, so they are traced for
/// 4 x 4 parts of each pixel. The other picture has parts x parts pixels for each of them.
double differenceFromRays(scene::Scene& scene, const sim::Drawables& drawables, glm::ivec2 size,
                          int parts = 1) {
  scene.render.quality = scene::Quality::high;
  const RayPicture rays = rayPicture(scene, drawables, 4 * size);
  scene.render.quality = scene::Quality::draft;
  const RayPicture maps = rayPicture(scene, drawables, parts * size);
  double sum = 0;
  double lit = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec2 first(x, y);
      const double wanted = rays.mean(4 * first, 4 * (first + 1)).y;
      const double difference = maps.mean(parts * first, parts * (first + 1)).y - wanted;
      sum += difference * difference;
      lit = std::max(lit, wanted);
    }
  CHECK(lit > 0);
  return std::sqrt(sum / (size.x * size.y)) / lit;
}

}  // namespace

TEST_CASE("sun's map: of balls the one nearest to the sun, in double precision, drawn in any way") {
  testContext();
  SunMapStage stage;
  const std::vector<glm::vec4> places = spread(190, 51);
  std::vector<glm::vec4> speeds(places.size(), glm::vec4(0));
  for (std::size_t i = 0; i < speeds.size(); i += 9)
    speeds[i].w = -1;  // A negative age means that the particle is dead.
  InstanceStage first(places, speeds);
  InstanceStage second({{0.1F, 0.4F, 0.2F, 1}, {-4.5F, 1, 0, 300}}, {glm::vec4(0), glm::vec4(0)});
  for (InstanceStage* group : {&first, &second}) {
    group->instances.shape = Shape::sphere;
    group->instances.size = 0.17F;
    group->instances.massExponent = 1.0F / 3;
  }
  std::vector<unsigned> usual;
  for (const int smallPixels : {16, 0, 3, 64}) {
    draw::BallRaster raster(draw::BallRaster::Into::sunMap, 1, smallPixels);
    stage.clear();
    raster.drawNearest({&first.instances, &second.instances}, {}, stage.map);
    if (usual.empty()) usual = stage.keys();
    CHECK(stage.keys() == usual);
  }
  struct Disc {
    glm::dvec2 middle;
    double radius, near;
  };
  std::vector<Disc> discs;
  const auto add = [&](glm::vec4 place) {
    const glm::dvec4 p(glm::dvec3(place), 1);
    const auto along = [&](std::size_t row) { return glm::dot(glm::dvec4(stage.rows[row]), p); };
    discs.push_back(
        {glm::dvec2(along(0), along(1)) * static_cast<double>(stage.side),
         0.5 * 0.17 * std::cbrt(static_cast<double>(place.w)) / static_cast<double>(stage.rows[3].x),
         std::max(1 - along(2), 0.0)});
  };
  for (std::size_t i = 0; i < places.size(); ++i)
    if (speeds[i].w >= 0) add(places[i]);
  add({0.1F, 0.4F, 0.2F, 1});
  add({-4.5F, 1, 0, 300});
  int wrong = 0;
  int close = 0;
  int covered = 0;
  for (int y = 0; y < stage.side; ++y)
    for (int x = 0; x < stage.side; ++x) {
      double nearest = -1;
      bool doubtful = false;
      for (const Disc& disc : discs) {
        const double away = glm::length(glm::dvec2(x, y) + 0.5 - disc.middle) - disc.radius;
        doubtful = doubtful || std::abs(away) < 2e-3;
        if (away <= 0) nearest = std::max(nearest, disc.near);
      }
      const unsigned key = usual[static_cast<std::size_t>(y * stage.side + x)];
      close += doubtful ? 1 : 0;
      covered += nearest >= 0 ? 1 : 0;
      if (doubtful) continue;
      const double found =
          key == 0xffffffffU
              ? -1
              : static_cast<double>(shader::intBitsToFloat(static_cast<int>(0x7fffffffU - key)));
      wrong += std::abs(found - nearest) > 2e-6 ? 1 : 0;
    }
  CHECK(wrong == 0);
  CHECK(close < 300);
  CHECK(covered > 3000);
  CHECK(covered < stage.side * stage.side - 3000);
}

TEST_CASE("sun's map: a ball over more texels than an invocation may go through") {
  testContext();
  SunMapStage stage(301);
  InstanceStage ball({{0, 0, 0, 1}}, {glm::vec4(0)});
  ball.instances.shape = Shape::sphere;
  ball.instances.size = 60;
  draw::BallRaster raster(draw::BallRaster::Into::sunMap, 1);
  stage.clear();
  raster.drawNearest({&ball.instances}, {}, stage.map);
  const std::vector<unsigned> keys = stage.keys();
  CHECK(std::count(keys.begin(), keys.end(), keys.front()) == static_cast<std::ptrdiff_t>(keys.size()));
  CHECK(keys.front() != 0xffffffffU);
  // In a larger map, the ball covers about fifteen columns at the left side, in rows around the fiftieth
  // from the end.
  SunMapStage wide(4500);
  const glm::vec3 right(0.8F, 0, -0.6F);
  const glm::vec3 up(-0.36F, 0.8F, -0.48F);
  InstanceStage beside({glm::vec4(-32.3333F * right + 2.1944F * up, 1)}, {glm::vec4(0)});
  beside.instances.shape = Shape::sphere;
  beside.instances.size = 60;
  wide.clear();
  raster.drawNearest({&beside.instances}, {}, wide.map);
  const std::vector<unsigned> found = wide.keys();
  for (const auto& [column, row, covered] :
       {std::tuple(3, 4495, true), {3, 4450, true}, {3, 4200, true}, {3, 10, false}, {30, 4450, false}}) {
    CAPTURE(row);
    CHECK((found[static_cast<std::size_t>(row * wide.side + column)] != 0xffffffffU) == covered);
  }
}

TEST_CASE("sun's map: copies of a mesh throw the shadows of the same triangles of a surface") {
  testContext();
  SunMapStage stage;
  const DartStage mesh;
  for (const auto& [size, count] : {std::pair(0.3F, 300), {3.1F, 12}}) {
    CAPTURE(size);
    std::vector<glm::vec3> places;
    for (const glm::vec4& p : spread(count, 57)) places.emplace_back(p);
    InstanceStage group(places);
    group.instances.size = size;
    group.instances.shape = Shape::mesh;
    const DartSurface same(mesh, places, size);
    const draw::MapPart part{.slopeOffset = 1.5F};
    std::vector<unsigned> wanted;
    for (const int binRoom : {0, 5, 1 << 20}) {  // values of the max number of triangles that are binned by
                                                 // tile: none, some, all
      draw::TriangleRaster surfaces(draw::TriangleRaster::Into::sunMap, 1, draw::smallTriangle(),
                                    draw::fansOfTriangles(), 0, binRoom);
      stage.clear();
      surfaces.number({&same.surface});
      surfaces.draw(stage.map, part);
      CHECK((binRoom == 0 || stage.keys() == wanted));
      wanted = stage.keys();
    }
    const auto empty = std::count(wanted.begin(), wanted.end(), 0xffffffffU);
    CHECK(empty > 500);
    CHECK(empty < stage.side * stage.side - 2000);
    CHECK(std::count(wanted.begin(), wanted.end(), 0x7fffffffU) > 20);  // Some texels show triangles at the
                                                                        // far end of the map.
    for (const auto& [smallPixels, pairs] : {std::pair(16, 1U << 22U), {0, 100U}, {64, 17U}}) {
      CAPTURE(smallPixels);
      draw::CopyRaster raster(draw::CopyRaster::Into::sunMap, 1, smallPixels, pairs, pairs == 17U ? 0 : 40);
      stage.clear();
      raster.drawNearest({{&group.instances, &mesh.shape}}, {}, stage.map, part);
      CHECK(stage.keys() == wanted);
    }
  }
}

TEST_CASE(
    "a lamp's map: of balls the discs through their middles that face the lamp, in double precision") {
  testContext();
  constexpr int side = 83;
  const shader::ExactView v = exactViewFrom({0.1F, 0.2F, 0.3F}, {0.2F, -0.1F, 0}, {side, side});
  gl::Buffer block("view", sizeof v);
  block.write(0, std::as_bytes(std::span(&v, 1)));
  Dice dice(67);
  std::vector<glm::vec4> places;
  for (int i = 0; i < 150; ++i) {
    const float away = i % 3 == 0 ? 4.0F : 0.6F;
    const glm::vec3 aside = away * dice.cube();
    if (glm::length(aside) < 0.2F) continue;
    places.emplace_back(glm::vec3(v.eye) + aside, 0.05F + dice());
  }
  InstanceStage group(places, std::vector<glm::vec4>(places.size(), glm::vec4(0)));
  group.instances.shape = Shape::sphere;
  group.instances.size = 0.2F;
  group.instances.massExponent = 1;
  std::vector<unsigned> usual;
  for (const auto& [smallPixels, mediumPixels] : {std::pair(16, 0), {0, 0}, {64, 0}, {0, 64}, {3, 12}}) {
    const draw::Visibility keys("a test", {side, side}, 1, false);
    draw::BallRaster raster(draw::BallRaster::Into::lampMap, 1, smallPixels, mediumPixels);
    block.bindUniform(draw::viewBinding, 0, sizeof v);
    keys.clear();
    gl::barrier();
    raster.drawNearest({&group.instances}, {}, keys,
                       {.slopeOffset = 1.5F, .side = side, .firstKey = 0, .keyStride = side});
    testContext().check();
    std::vector<unsigned> found = keys.readKeys();
    found.resize(static_cast<std::size_t>(side) * side);
    if (usual.empty()) usual = found;
    CHECK(found == usual);
  }
  int wrong = 0;
  int close = 0;
  int covered = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::dvec3 ray = glm::dvec3(glm::vec3(v.ray)) + glm::dvec3(glm::vec3(v.rayAcross)) * (x + 0.5) +
                             glm::dvec3(glm::vec3(v.rayDown)) * (y + 0.5);
      double nearest = 1e9;
      bool doubtful = false;
      for (const glm::vec4& place : places) {
        const glm::dvec3 middle = glm::dvec3(glm::vec3(place)) - glm::dvec3(glm::vec3(v.eye));
        const double radius = 0.1 * static_cast<double>(place.w);
        // Distance of the ray from the centre, and its intersection with a plane through the centre. The
        // plane is perpendicular to the line from the eye to the centre.
        const double along = glm::dot(ray, middle);
        const double past = glm::length(glm::cross(ray, middle)) / glm::length(ray);
        doubtful = doubtful || std::abs(past - radius) < 1e-4 * glm::length(middle);
        if (past >= radius || along <= 0) continue;
        const double depth = glm::dot(middle, middle) / along;
        doubtful = doubtful || std::abs(depth - static_cast<double>(v.near)) < 1e-5;
        if (depth >= static_cast<double>(v.near)) nearest = std::min(nearest, depth);
      }
      close += doubtful ? 1 : 0;
      covered += nearest < 1e9 ? 1 : 0;
      if (doubtful) continue;
      const unsigned key = usual[static_cast<std::size_t>(y * side + x)];
      if (key == 0xffffffffU || nearest == 1e9) {
        wrong += (key == 0xffffffffU) != (nearest == 1e9) ? 1 : 0;
        continue;
      }
      const auto near = static_cast<double>(shader::intBitsToFloat(static_cast<int>(0x7fffffffU - key)));
      wrong += std::abs(static_cast<double>(v.near) / near - nearest) > 1e-5 * nearest ? 1 : 0;
    }
  CHECK(wrong == 0);
  CHECK(close < 200);
  CHECK(covered > 1000);
  CHECK(covered < side * side - 1000);
}

TEST_CASE("shadow edges on ground seen at a grazing angle match those of traced rays") {
  testContext();
  scene::Scene scene = furnace(1);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  setGround(scene, 0.5F);
  scene.ground->fadeStart = 1000;
  scene.ground->fadeEnd = 2000;
  scene.camera.position = glm::vec3(0, 0.5F, 3);
  scene.camera.target = glm::vec3(0);
  scene.camera.fieldOfView = 12;
  // The edge of the sheet's shadow crosses about six rows of the picture. The sheet is not in view.
  GridStage sheet({2, 2}, {-6, 1.5F, -2}, {12, 0, 4}, {0, 0, -20});
  sheet.material.color = glm::vec3(0);
  const glm::ivec2 size(96, 24);
  for (const float softness : {1.5F, 2.5F}) {
    CAPTURE(softness);
    const double most = softness > 2 ? 0.021 : 0.025;  // The filters have 16 and 4 taps.
    scene.sun.direction = glm::vec3(0, 1, 0.1F);
    scene.sun.intensity = 3.0F;
    scene.sun.shadowSoftness = softness;
    scene.lights.clear();
    CHECK(differenceFromRays(scene, {.surfaces = {sheet.surface}}, size) < most);
    scene.sun.intensity = 0.0F;
    scene.lights = {lampAt({0, 6, 0}, 20, true)};
    scene.lights[0].shadowSoftness = softness;
    CHECK(differenceFromRays(scene, {.surfaces = {sheet.surface}}, size) < most);
  }
}

TEST_CASE("shadows in folds match those of traced rays") {
  testContext();
  scene::Scene scene = furnace(1);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  scene.sun.shadowSize = 320;
  lookDown(scene, 20, 11);
  // The sheet has 8 folds, which are about 32 texels of the maps wide. It is dark, because only rays show
  // the light that it throws on itself.
  const glm::ivec2 grid(257, 3);
  GridStage sheet(grid, {-2, 0, -2}, {4, 0, 0}, {0, 0, 4});
  std::vector<glm::vec4> folded;
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x) {
      const float part = static_cast<float>(x) / static_cast<float>(grid.x - 1);
      folded.emplace_back(4 * part - 2, 0.11F * std::sin(16 * std::numbers::pi_v<float> * part), 2 * y - 2,
                          1);
    }
  sheet.buffer.write(0, std::as_bytes(std::span(folded)));
  sheet.material.roughness = 1;
  sheet.material.color = glm::vec3(0.05F);
  const glm::ivec2 size(96, 24);
  for (const float elevation : {0.6F, 1.2F})
    for (const float softness : {1.5F, 2.5F}) {
      CAPTURE(elevation);
      CAPTURE(softness);
      scene.sun.direction = glm::vec3(1, elevation, 0.2F);
      scene.sun.intensity = 3.0F;
      scene.sun.shadowSoftness = softness;
      scene.lights.clear();
      CHECK(differenceFromRays(scene, {.surfaces = {sheet.surface}}, size, 4) < 0.027);
      scene.sun.intensity = 0.0F;
      scene.lights = {lampAt(6.0F * glm::normalize(glm::vec3(1, elevation, 0.2F)), 50, true)};
      scene.lights[0].shadowSoftness = softness;
      scene.lights[0].shadowSize = 800;
      CHECK(differenceFromRays(scene, {.surfaces = {sheet.surface}}, size, 4) <
            (elevation > 1 ? 0.0086 : 0.0175));
    }
}

TEST_CASE("a floor that reaches far beyond the picture does not coarsen the sun's shadows") {
  testContext();
  scene::Scene scene = furnace(1);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  scene.sun.direction = glm::vec3(1, 1, 0.3F);
  scene.sun.intensity = 3.0F;
  scene.sun.shadowSize = 256;
  GridStage floor({2, 2}, {-30, 0, -30}, {60, 0, 0}, {0, 0, 60});
  floor.material.roughness = 1;
  floor.material.color = glm::vec3(0.05F);
  // The sheet is outside the picture, its shadow in the middle.
  GridStage sheet({2, 2}, {3.5F, 4, 0.7F}, {1, 0, 0}, {0, 0, 1});
  sheet.material.color = glm::vec3(0);
  for (const auto& [place, most] :
       {std::pair(glm::vec3(0, 9, 1e-3F), 0.18), {{3, 6, 4}, 0.21}, {{-6, 4, -2}, 0.15}}) {
    scene.camera.position = place;
    scene.camera.target = glm::vec3(0);
    scene.camera.fieldOfView = 16;
    CHECK(differenceFromRays(scene, {.surfaces = {floor.surface, sheet.surface}}, {64, 48}, 4) < most);
  }
}
