// Tests motion blur through the coverage of pixels by a moving sheet in front of the sky, and tests the
// interpolation between frames.
#include "draw/exact/motion/motion.hpp"

#include "frame/draw_world.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <bit>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;  // NOLINT

namespace {

struct Smear {
  double area = 0;                  ///< covered area in pixels
  glm::dvec2 middle{0}, spread{0};  ///< mean and variance of the covered positions (pixels)
};

Smear smearOf(const draw::PassPicture& kept, glm::ivec2 size) {
  Smear smear;
  for (const draw::PassArray& array : kept.arrays) {
    if (array.pass != "light" || array.part != "lens") continue;
    glm::dvec2 squares(0);
    for (std::size_t i = 3; i < array.words.size(); i += 4) {
      const auto share = static_cast<double>(std::bit_cast<float>(array.words[i]));
      const auto pixel = static_cast<int>(i / 4);
      const glm::dvec2 at(pixel % size.x, pixel / size.x);
      smear.area += share;
      smear.middle += share * at;
      squares += share * at * at;
    }
    smear.middle /= smear.area;
    smear.spread = squares / smear.area - smear.middle * smear.middle;
  }
  return smear;
}

std::unique_ptr<TriangleStage> sheetAt(glm::vec2 at) {
  const glm::vec3 to(at, 0);
  return std::make_unique<TriangleStage>(
      std::vector<glm::vec3>{to + glm::vec3(-0.2F, -0.15F, -1), to + glm::vec3(0.2F, -0.15F, -1),
                             to + glm::vec3(-0.2F, 0.15F, -1), to + glm::vec3(0.2F, 0.15F, -1)},
      std::vector<unsigned>{0, 1, 2, 2, 1, 3}, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
}

/// Returns the content of a texel view.
std::vector<glm::vec4> read(const gl::Texture& view, std::size_t count) {
  GLint buffer = 0;
  glGetTextureLevelParameteriv(view.name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
  std::vector<glm::vec4> items(count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(static_cast<GLuint>(buffer), 0,
                          static_cast<GLsizeiptr>(count * sizeof(glm::vec4)), items.data());
  return items;
}

constexpr glm::ivec2 shotSize(191, 143);

scene::Scene sceneOfSheet(float angle, int samples) {
  scene::Scene scene;
  scene.sun.shadow = false;
  scene.camera.position = glm::vec3(0, 0, 3);  // the camera is 4 m from the sheet
  scene.camera.target = glm::vec3(0, 0, -1);
  scene.camera.shutter.emplace();
  scene.camera.shutter->angle = angle;
  scene.camera.shutter->samples = samples;
  return scene;
}

/// Returns the coverage by the static sheet, which is a box convolved with the box of a pixel.
Smear boxOf(double metre) {
  const glm::dvec2 sides = metre * glm::dvec2(0.4, 0.3);
  return {sides.x * sides.y, 0.5 * (glm::dvec2(shotSize) - 1.0), sides * sides / 12.0 + 1.0 / 12};
}

double pixelsPerMetre(const scene::Scene& scene) {
  const draw::View view = draw::viewAt(scene.camera, 0, shotSize, {});
  return 0.5 * shotSize.y / (4 * static_cast<double>(view.reach.y));
}

}  // namespace

TEST_CASE("exact: a shutter spreads what moves over its way while it is open, and keeps what it covers") {
  testContext();
  const auto before = sheetAt({-0.3F, 0.1F}), now = sheetAt({0.5F, -0.2F});
  const glm::dvec2 way(0.8, 0.3);  // displacement between the frames, to the right and down (m)
  for (const float angle : {90.0F, 360.0F}) {
    CAPTURE(angle);
    constexpr int samples = 13;
    const scene::Scene scene = sceneOfSheet(angle, samples);
    const double metre = pixelsPerMetre(scene), open = static_cast<double>(angle) / 360;
    draw::PassPicture kept;
    draw::Renderer renderer(scene, shotSize, 4, {.rasterizer = scene::Rasterizer::exact});
    renderer.keepPasses(&kept);
    const Smear rest = boxOf(metre);
    renderer.setPreviousFrame({.surfaces = {before->surface}});
    renderer.draw(1, {.surfaces = {now->surface}});
    const Smear seen = smearOf(kept, shotSize);
    CHECK(seen.area == doctest::Approx(rest.area).epsilon(0.01));
    // The moments are at the centres of equal intervals of the exposure time, which ends at the frame. They
    // are symmetric about the middle of that time.
    const glm::dvec2 end(0.5, 0.2);
    for (int i = 0; i < 2; ++i) {
      CHECK(seen.middle[i] - rest.middle[i] ==
            doctest::Approx(metre * (end[i] - 0.5 * open * way[i])).epsilon(0.01));
      const double spread = metre * open * way[i];
      CHECK(seen.spread[i] ==
            doctest::Approx(rest.spread[i] + spread * spread / 12 * (1 - 1.0 / (samples * samples)))
                .epsilon(0.01));
    }
  }
}

TEST_CASE("exact: a shutter sees what jumps at one place and then at the other, and nothing in between") {
  testContext();
  const auto before = sheetAt({-0.3F, 0.1F}), now = sheetAt({0.5F, -0.2F});
  constexpr int samples = 13;
  const scene::Scene scene = sceneOfSheet(360, samples);
  const double metre = pixelsPerMetre(scene);
  draw::PassPicture kept;
  draw::Renderer renderer(scene, shotSize, 4, {.rasterizer = scene::Rasterizer::exact});
  renderer.keepPasses(&kept);
  const Smear rest = boxOf(metre);
  sim::Surface lastJumpSeconds = now->surface;
  lastJumpSeconds.lastJumpSeconds = 1 - 0.7 / scene.time.fps;  // The jump is before 9 of the 13 moments.
  renderer.setPreviousFrame({.surfaces = {before->surface}});
  renderer.draw(1, {.surfaces = {lastJumpSeconds}});
  const Smear seen = smearOf(kept, shotSize);
  CHECK(seen.area == doctest::Approx(rest.area).epsilon(0.01));
  const glm::dvec2 end(0.5, 0.2), way(0.8, 0.3);
  for (int i = 0; i < 2; ++i) {
    CHECK(seen.middle[i] - rest.middle[i] ==
          doctest::Approx(metre * (end[i] - 4.0 / 13 * way[i])).epsilon(0.02));
    CHECK(seen.spread[i] ==
          doctest::Approx(rest.spread[i] + 36.0 / 169 * metre * metre * way[i] * way[i]).epsilon(0.01));
  }
  // In the next frame, the jump is in the past.
  renderer.setPreviousFrame({.surfaces = {lastJumpSeconds}});
  renderer.draw(1 + 1 / scene.time.fps, {.surfaces = {lastJumpSeconds}});
  CHECK(smearOf(kept, shotSize).spread.x == doctest::Approx(rest.spread.x).epsilon(0.01));
}

TEST_CASE("exact: what jumps by keyframes has no speed there, and a camera that looks at it jumps along") {
  testContext();
  const auto layersAt = [](const char* keys, int frame) {
    const scene::Scene scene = scene::parseScene(
        R"({"version": 1, "stage": false, "render": {"size": [48, 27], "samples": 1}, "time": {"fps": 10},
            "camera": {"position": [0, 0, 6], "track": "ball", "shutter": {"angle": 360, "samples": 4}}, "sun": {"intensity": 0},
            "sky": {"zenith": [0.5, 0.5, 0.5], "horizon": [0.5, 0.5, 0.5], "ground": [0.5, 0.5, 0.5]},
            "objects": {"ball": {"sphere": {"radius": 0.5, "position": {"keys": )" +
            std::string(keys) + R"(}}, "material": {"color": [0.05, 0.05, 0.05]}}}})",
        "scene.json", {}, sim::kinds());
    sim::World world(scene);
    draw::Renderer renderer(scene, scene.render.size, scene.render.samples);
    renderer.keepLayers({{draw::Layer::velocity, draw::Layer::vector, draw::Layer::object}, false, 32});
    frame::followMotion(renderer, world);
    world.advanceTo(frame);
    frame::drawWorld(renderer, world);
    return renderer.takeLayers();
  };
  const auto middle = [](const draw::PictureLayers& layers) {
    const std::size_t pixel = std::size_t{48} * 13 + 24;
    return glm::vec4(layers.velocity[3 * pixel], layers.light[4 * pixel], layers.vector[2 * pixel],
                     layers.light[4 * (pixel + 20)]);
  };
  // The object moves 1 m per second, and jumps by 2 m during frame 5.
  const char* const jumping =
      "[[0, [0, 0, 0]], [0.45, [0.45, 0, 0]], [0.45, [2.45, 0, 0]], [1, [3, 0, 0]]]";
  const char* const steady = "[[0, [0, 0, 0]], [1, [1, 0, 0]]]";
  for (const int frame : {4, 6}) {
    CAPTURE(frame);
    CHECK(middle(layersAt(jumping, frame)).x == doctest::Approx(1).epsilon(1e-3).scale(0));
  }
  const draw::PictureLayers there = layersAt(jumping, 5), plain = layersAt(steady, 5);
  CHECK(middle(there).x == 0.0F);
  CHECK(middle(plain).x == doctest::Approx(1).epsilon(1e-3).scale(0));
  // The tracking camera keeps the ball at the centre at all moments. The ball therefore has its full
  // brightness, and nothing appears next to it.
  CHECK(middle(there).y == doctest::Approx(static_cast<double>(middle(plain).y)).epsilon(0.02).scale(0));
  CHECK(middle(there).w == doctest::Approx(static_cast<double>(middle(plain).w)).epsilon(0.02).scale(0));
}

TEST_CASE("exact: a shutter sees the camera move, and a frame before which nothing is known stand still") {
  testContext();
  const auto sheet = sheetAt({0, 0});
  scene::Scene scene = sceneOfSheet(360, 9);
  const double metre = pixelsPerMetre(scene);
  scene.time.fps = 10;
  using Keys = scene::Animated<glm::vec3>;
  scene.camera.position =
      Keys({{0, glm::vec3(-0.4F, 0, 3)}, {1, glm::vec3(0.4F, 0, 3)}}, scene::Ease::linear);
  scene.camera.target =
      Keys({{0, glm::vec3(-0.4F, 0, -1)}, {1, glm::vec3(0.4F, 0, -1)}}, scene::Ease::linear);
  draw::PassPicture kept;
  draw::Renderer renderer(scene, shotSize, 4, {.rasterizer = scene::Rasterizer::exact});
  renderer.keepPasses(&kept);
  const Smear rest = boxOf(metre);
  renderer.draw(0.5, {.surfaces = {sheet->surface}});
  const Smear seen = smearOf(kept, shotSize);
  CHECK(seen.area == doctest::Approx(rest.area).epsilon(0.03));  // The tolerance is large, because a pixel
                                                                 // has few distinct sample heights.
  // The camera moves 0.08 m to the right during the tenth of a second before the frame, so the sheet starts
  // at this distance to the right of the centre.
  CHECK(seen.middle.x - rest.middle.x == doctest::Approx(metre * 0.04).epsilon(0.03));
  const double spread = metre * 0.08;
  CHECK(seen.spread.x ==
        doctest::Approx(rest.spread.x + spread * spread / 12 * (1 - 1.0 / 81)).epsilon(0.01));
  CHECK(seen.spread.y == doctest::Approx(rest.spread.y).epsilon(0.05));
}

TEST_CASE("exact: with a lens each moment is seen through other points of it, all of them once") {
  testContext();
  const auto sheet = sheetAt({0, 0});
  scene::Scene scene = sceneOfSheet(180, 5);
  scene.camera.lens.emplace();
  scene.camera.lens->fNumber = 0.06F;
  scene.camera.lens->samples = 37;
  scene.camera.lens->focus = 7.0F;
  draw::PassPicture kept;
  draw::Renderer renderer(scene, shotSize, 4, {.rasterizer = scene::Rasterizer::exact});
  renderer.keepPasses(&kept);
  renderer.draw(0, {.surfaces = {sheet->surface}});
  const Smear seen = smearOf(kept, shotSize);
  scene.camera.shutter.reset();
  draw::PassPicture lens;
  draw::Renderer alone(scene, shotSize, 4, {.rasterizer = scene::Rasterizer::exact});
  alone.keepPasses(&lens);
  alone.draw(0, {.surfaces = {sheet->surface}});
  const Smear wanted = smearOf(lens, shotSize);
  // The same views are summed in a different order, and each pixel looks through other points beside
  // theirs.
  CHECK(seen.area == doctest::Approx(wanted.area).epsilon(2e-3));
  for (int i = 0; i < 2; ++i) {
    CHECK(seen.middle[i] == doctest::Approx(wanted.middle[i]).epsilon(1e-3));
    CHECK(seen.spread[i] == doctest::Approx(wanted.spread[i]).epsilon(1e-2));
  }
}

TEST_CASE("motion: instances go straight, and newborn ones along their velocities") {
  testContext();
  // Particle 1 is new, 2 did not exist before, 3 dies, and 4 jumps farther than its velocity permits.
  const std::vector<glm::vec4> placesBefore = {
      {0, 0, 0, 2}, {1, 0, 0, 2}, {5, 5, 5, 2}, {0, 1, 0, 2}, {0, 0, 1, 2}};
  const std::vector<glm::vec4> placesNow = {
      {0.1F, 0.2F, 0, 2}, {1, 0.2F, 0, 2}, {0, 0, 0, 3}, {0, 1, 0.1F, 2}, {9, 0, 1, 2}};
  const std::vector<glm::vec4> motionBefore = {
      {1, 2, 0, 0.5F}, {0, 1, 0, 0.9F}, {0, 0, 0, -1}, {0, 0, 1, 0.9F}, {1, 0, 0, 0.1F}};
  const std::vector<glm::vec4> motionNow = {
      {1, 2, 0, 0.6F}, {0, 3, 0, 0.01F}, {1, 0, 0, 0}, {0, 0, 1, -1}, {2, 0, 0, 0.2F}};
  const auto bufferOf = [](const std::vector<glm::vec4>& items) {
    return gl::Buffer::of<glm::vec4>("elements", items);
  };
  const gl::Buffer buffers[] = {bufferOf(placesBefore), bufferOf(motionBefore), bufferOf(placesNow),
                                bufferOf(motionNow)};
  std::vector<gl::Texture> views;
  for (const gl::Buffer& buffer : buffers)
    views.push_back(gl::Texture::view("elements", GL_RGBA32F, buffer));
  const scene::Material material;
  sim::Instances before;
  before.positions = views.data();
  before.velocities = &views[1];
  before.capacity = 5;
  before.material = &material;
  sim::Instances now = before;
  now.positions = &views[2];
  now.velocities = &views[3];
  draw::Motion motion(false);
  motion.keep({.instances = {before}});
  const sim::Drawables present{.instances = {now}};
  motion.begin(present, 0.1);
  const sim::Drawables& seen = motion.between(0.75F);
  const auto places = read(*seen.instances.front().positions, 5);
  const auto motions = read(*seen.instances.front().velocities, 5);
  const glm::vec3 wanted[] = {
      {0.075F, 0.15F, 0}, {1, 0.125F, 0}, {-0.025F, 0, 0}, {0, 1, 0.075F}, {8.95F, 0, 1}};
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(motions[i].w == motionNow[i].w);
    CHECK(places[i].w == placesNow[i].w);
    if (motionNow[i].w >= 0) CHECK(glm::length(glm::vec3(places[i]) - wanted[i]) < 1e-6F);
  }
}

TEST_CASE("motion: grids, turned meshes and still ones between two frames") {
  testContext();
  const GridStage before({5, 3}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
  const GridStage now({5, 3}, {0, 0, 2}, {1, 0, 0}, {0, -1, 0});
  const auto mesh = sheetAt({0, 0});
  sim::Surface turned = mesh->surface, resting = mesh->surface;
  resting.still = 7;
  turned.model[3] = glm::vec4(2, 0, 0, 1);
  draw::Motion motion(false);
  motion.keep({.surfaces = {before.surface, mesh->surface, resting}});
  const sim::Drawables present{.surfaces = {now.surface, turned, resting}};
  motion.begin(present, 0.1);
  const sim::Drawables& seen = motion.between(0.25F);
  for (const glm::vec4& place : read(*seen.surfaces[0].positions, 15)) CHECK(place.z == 0.5F);
  CHECK(seen.surfaces[0].normals == nullptr);  // Grids have no normals, because shaders compute the normals
                                               // from neighbouring vertices.
  CHECK(seen.surfaces[0].grid == glm::ivec2(5, 3));
  const auto places = read(*seen.surfaces[1].positions, 4);
  CHECK(places[0].x == doctest::Approx(0.3));
  CHECK(places[3].x == doctest::Approx(0.7));
  CHECK(seen.surfaces[1].model == glm::mat4(1.0F));
  CHECK(read(*seen.surfaces[1].normals, 4)[2].z == 1.0F);
  CHECK(seen.surfaces[2].positions == resting.positions);
  CHECK(seen.surfaces[2].still == 7);
}
