// Tests numbers of objects and invocations that are permitted, but are larger than in any practical scene.
#include "base/error.hpp"
#include "base/file.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
using Shape = sim::Instances::Shape;

namespace {

/// Number of invocations in the first row of workgroups (dispatchRows), and in almost two rows. The visible
/// objects have indices near these numbers.
constexpr std::size_t row = std::size_t{32768} * 64;
constexpr std::size_t rows = 2 * row - 40;

/// Writes the elements `few` into `all`, which contains only invisible elements. The first `part` elements
/// replace elements at the start of the second row. The other elements are appended.
template <class T>
void putInto(std::vector<T>& all, const std::vector<T>& few, std::size_t part) {
  const auto from = few.begin() + static_cast<std::ptrdiff_t>(part);
  std::copy(few.begin(), from, all.begin() + static_cast<std::ptrdiff_t>(row));
  all.insert(all.end(), from, few.end());
}

scene::Scene litScene() {
  scene::Scene scene = darkScene();
  scene.render.rasterizer = scene::Rasterizer::exact;
  scene.camera.position = glm::vec3(0.3F, 1.6F, 4);
  scene.camera.target = glm::vec3(0, 0.5F, 0);
  scene.sun.direction = glm::vec3(0.4F, 1, 0.6F);
  scene.sun.shadowSize = 256;
  scene.ground.emplace();
  return scene;
}

Picture drawnExactly(const scene::Scene& scene, const sim::Drawables& drawables, glm::ivec2 size) {
  return drawn(scene, drawables, size, 4, {.rasterizer = scene::Rasterizer::exact});
}

}  // namespace

TEST_CASE("exact limits: instances beyond the first row of groups, to the end of the second") {
  testContext();
  const scene::Scene scene = litScene();
  const auto file = temporaryFile("row_dart.obj");
  writeFileAtomically(file,
                      "v 0 0 0.6\nv 0.34 0.03 -0.4\nv -0.34 0.03 -0.4\nv 0 -0.14 -0.4\n"
                      "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  Dice dice(41);
  std::vector<glm::vec4> places;
  std::vector<glm::vec4> speeds;
  for (int i = 0; i < 37; ++i) {
    places.emplace_back(dice.cube() + glm::vec3(0, 1.2F, 0), 1 + 40 * dice());
    speeds.emplace_back(dice.cube(), dice());
  }
  InstanceStage few(places, speeds);
  constexpr glm::vec4 dead{0, 0, 0, -1};
  std::vector<glm::vec4> allPlaces(rows, glm::vec4(0, 1, 0, 1));
  std::vector<glm::vec4> allSpeeds(rows, dead);
  putInto(allPlaces, places, 15);
  putInto(allSpeeds, speeds, 15);
  InstanceStage many(allPlaces, allSpeeds);
  for (const Shape shape : {Shape::sprite, Shape::sphere, Shape::mesh})
    for (const bool additive : {false, true}) {
      CAPTURE(static_cast<int>(shape));
      CAPTURE(additive);
      for (InstanceStage* stage : {&few, &many}) {
        stage->instances.shape = shape;
        stage->instances.mesh = file;
        stage->instances.additive = additive;
        stage->instances.size = 0.1F;
        stage->instances.massExponent = 1.0F / 3;
      }
      const Picture wanted = drawnExactly(scene, {.instances = {few.instances}}, {67, 53});
      CHECK(wanted.bytes != drawnExactly(scene, {}, {67, 53}).bytes);
      CHECK(drawnExactly(scene, {.instances = {many.instances}}, {67, 53}).bytes == wanted.bytes);
    }
  std::filesystem::remove(file);
}

TEST_CASE("exact limits: vertices and triangles beyond the first row of groups, to the end of the second") {
  testContext();
  const scene::Scene scene = litScene();
  Dice dice(43);
  std::vector<glm::vec3> places;
  std::vector<unsigned> corners;
  for (unsigned i = 0; i < 90; ++i) {
    const glm::vec3 middle = i % 3 == 0 ? dice.cube() : places[i - i % 3];
    places.push_back(middle + 0.3F * dice.cube() + glm::vec3(0, i % 3 == 0 ? 0.7F : 0, 0));
    corners.push_back(i);
  }
  TriangleStage few(places, corners);
  std::vector<glm::vec3> allPlaces(rows, glm::vec3(0));
  putInto(allPlaces, places, 45);
  std::vector<unsigned> allCorners(std::size_t{3} * rows, 0);
  for (const unsigned corner : corners) {
    const std::size_t number = corner < 45 ? row + corner : rows + corner - 45;
    if (corner < 45)
      allCorners[3 * row + corner] = static_cast<unsigned>(number);
    else
      allCorners.push_back(static_cast<unsigned>(number));
  }
  TriangleStage many(allPlaces, allCorners);
  few.surface.doubleSided = many.surface.doubleSided = true;
  const Picture wanted = drawnExactly(scene, {.surfaces = {few.surface}}, {67, 53});
  CHECK(wanted.bytes != drawnExactly(scene, {}, {67, 53}).bytes);
  CHECK(drawnExactly(scene, {.surfaces = {many.surface}}, {67, 53}).bytes == wanted.bytes);
}

TEST_CASE("exact limits: as many things as are drawn at once, each where it is; one more is refused") {
  testContext();
  constexpr int maximum = 2046;
  constexpr int across = 62;
  constexpr int side = 8;  // side (pixels) of the square cell in which each object is drawn, equal to the
                           // side of a tile
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  const glm::ivec2 size(across * side, (maximum + across - 1) / across * side);
  // At a distance of 5 m, the picture is 2 * tan(20 degrees) * 5 m high.
  const float pixel = 3.6397023F / static_cast<float>(size.y);
  const float half = 0.4F * pixel * static_cast<float>(side);
  TriangleStage square({{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}},
                       {0, 1, 2, 0, 2, 3}, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  std::vector<scene::Material> materials(3);
  for (int i = 0; i < 3; ++i) {
    materials[static_cast<std::size_t>(i)].color = glm::vec3(0.02F);
    materials[static_cast<std::size_t>(i)].color[i] = 0.9F;
  }
  const auto cell = [&](int i) { return side * glm::ivec2(i % across, i / across) + side / 2; };
  std::vector<sim::Surface> surfaces(maximum, square.surface);
  for (int i = 0; i < maximum; ++i) {
    const glm::vec2 at = glm::vec2(cell(i)) - 0.5F * glm::vec2(size);
    surfaces[static_cast<std::size_t>(i)].model[3] = glm::vec4(pixel * at.x, -pixel * at.y, 0, 1);
    surfaces[static_cast<std::size_t>(i)].material = &materials[static_cast<std::size_t>(i % 3)];
  }
  const Picture picture = drawnExactly(scene, {.surfaces = surfaces}, size);
  int wrong = 0;
  for (int i = 0; i < maximum; ++i) {
    const glm::ivec3 seen = picture.at(cell(i).x, cell(i).y);
    const int own = i % 3;
    if (seen[own] < std::max(seen[(own + 1) % 3], seen[(own + 2) % 3]) + 60) ++wrong;
  }
  CHECK(wrong == 0);
  const JoiningForced pixelDifference("no");  // Joined surfaces would count as one object.
  surfaces.push_back(square.surface);
  surfaces.back().material = materials.data();
  try {
    (void)drawnExactly(scene, {.surfaces = surfaces}, size);
    CHECK(false);
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::device);
    CHECK(std::string(error.what()).find("has 2047 surfaces and groups of copies") != std::string::npos);
  }
}

TEST_CASE("exact limits: what is nearer than the nearest plane or beyond the farthest is not drawn") {
  testContext();
  scene::Scene scene = darkScene();  // The eye is 5 m in front of the origin.
  scene.sun.shadow = false;
  scene.camera.near = 1;
  scene.camera.far = 6;
  const auto file = temporaryFile("limit_plate.obj");
  writeFileAtomically(file, "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n");
  const Picture empty = drawnExactly(scene, {}, {161, 153});
  for (const Shape shape : {Shape::sprite, Shape::sphere, Shape::mesh})
    for (const bool additive : {false, true})
      for (const float size : {0.05F, 1.2F}) {  // Round sprites have a radius of at most 64 pixels.
        CAPTURE(static_cast<int>(shape));
        CAPTURE(additive);
        CAPTURE(size);
        const auto shows = [&](float z) {
          InstanceStage stage({{0.1F, 0.05F, z, 1}}, {{0, 0, 0, 0.5F}});
          stage.instances.shape = shape;
          stage.instances.mesh = file;
          stage.instances.additive = additive;
          stage.instances.size = size;
          return drawnExactly(scene, {.instances = {stage.instances}}, {161, 153}).bytes != empty.bytes;
        };
        CHECK(shows(0.5F));
        CHECK(shows(-0.3F));
        CHECK_FALSE(shows(4.9F));
        CHECK_FALSE(shows(-2.3F));
      }
  std::filesystem::remove(file);
}

TEST_CASE("exact limits: one primitive over the whole picture is the same at any number of samples") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  scene.sun.intensity = 1.0F;
  const auto file = temporaryFile("one_triangle.obj");
  writeFileAtomically(file, "v -30 -30 0\nv 30 -30 0\nv 0 50 0\nf 1 2 3\n");
  TriangleStage triangle({{-30, -30, 0}, {30, -30, 0}, {0, 50, 0}}, {0, 1, 2},
                         std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
  InstanceStage instance(std::vector<glm::vec3>(1, glm::vec3(0)));
  instance.instances.mesh = file;
  instance.instances.size = 1;
  InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0, 0, -57)));  // The eye is close to the front of
                                                                        // the ball.
  ball.instances.size = 120;
  instance.instances.shape = Shape::mesh;
  ball.instances.shape = Shape::sphere;
  // The triangle extends beyond the picture, but not beyond the guard band, so it is never clipped.
  const auto whole = temporaryFile("whole_triangle.obj");
  writeFileAtomically(whole, "v -8 -8 0\nv 8 -8 0\nv 0 13 0\nf 1 2 3\n");
  InstanceStage inside(std::vector<glm::vec3>(1, glm::vec3(0)));
  inside.instances.mesh = whole;
  inside.instances.size = 1;
  inside.instances.shape = Shape::mesh;
  const sim::Drawables kinds[] = {{.surfaces = {triangle.surface}},
                                  {.instances = {inside.instances}},
                                  {.instances = {instance.instances}},
                                  {.instances = {ball.instances}}};
  for (const sim::Drawables& drawables : kinds) {
    CAPTURE(drawables.surfaces.size());
    const auto with = [&](int samples) {
      return drawn(scene, drawables, {21, 13}, samples, {.rasterizer = scene::Rasterizer::exact});
    };
    const Picture one = with(1);
    for (int y = 0; y < 13; ++y)
      for (int x = 0; x < 21; ++x) CHECK(one.brightness(x, y) > 200);
    for (const int samples : {2, 4, 8, 16}) {
      CAPTURE(samples);
      CHECK(with(samples).bytes == one.bytes);
    }
    // The picture has more pixels than one invocation may loop over, and the triangle covers more pixels
    // than small triangles may cover.
    for (const glm::ivec2 size : {glm::ivec2(401, 301), glm::ivec2(13, 5400)}) {
      const Picture large = drawn(scene, drawables, size, 1, {.rasterizer = scene::Rasterizer::exact});
      int dark = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) dark += large.brightness(x, y) > 200 ? 0 : 1;
      CHECK(dark == 0);
    }
  }
  std::filesystem::remove(file);
  std::filesystem::remove(whole);
}
