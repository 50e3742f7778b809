// Tests the kernels for culling and bounds by comparison with float64 versions, and tests the bits that
// every device must produce.
#include "gpu/draw/exact/kernel_stage.hpp"

#include <bit>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

double stepped(double size) {
  const double unit = std::exp2(std::floor(std::log2(size)) - 3);
  return std::ceil(size / unit) * unit;
}

}  // namespace

TEST_CASE("exact kernels: the sun's map is fitted to the balls") {
  KernelStage stage;
  const auto rows = stage.fitted();
  glm::dvec3 low(1e9);
  glm::dvec3 high(-1e9);
  glm::dvec2 groundLow(1e9);
  glm::dvec2 groundHigh(-1e9);
  const glm::dvec3 right(stage.frame.lightRight);
  const glm::dvec3 up(stage.frame.lightUp);
  const glm::dvec3 sun(stage.frame.sunDirection);
  for (std::size_t i = 0; i < KernelStage::count; ++i) {
    if (!KernelStage::shown(i)) continue;
    const glm::dvec3 p(KernelStage::places()[i]);
    const double r = KernelStage::radius(i);
    const glm::dvec3 q(glm::dot(p, right), glm::dot(p, up), glm::dot(p, sun));
    const double above = (p.y - static_cast<double>(stage.frame.groundHeight)) / sun.y;
    const glm::dvec2 g(p.x - sun.x * above, p.z - sun.z * above);
    low = glm::min(low, q - r);
    high = glm::max(high, q + r);
    groundLow = glm::min(groundLow, g - r / sun.y);
    groundHigh = glm::max(groundHigh, g + r / sun.y);
  }
  const double size = stepped(std::max(high.x - low.x, high.y - low.y));
  const double texel = size / (512 - 2 * 4 - 1);
  const double side = 512 * texel;
  const double depth = 1.02 * stepped(high.z - low.z);
  const auto near = [](const glm::vec4& found, const glm::dvec4& wanted) {
    return glm::length(glm::dvec4(found) - wanted) < 1e-5 * (1 + glm::length(wanted));
  };
  const auto corner = [&](double lowest) { return (std::floor(lowest / texel) - 4) * texel; };
  CHECK(near(rows[0], glm::dvec4(right, -corner(low.x)) / side));
  CHECK(near(rows[1], glm::dvec4(up, -corner(low.y)) / side));
  CHECK(near(rows[2], glm::dvec4(-sun, high.z + 0.01 * depth) / depth));
  CHECK(near(rows[3], glm::dvec4(texel, side, depth, 0)));
  const double reach = 4 * texel / sun.y;
  CHECK(near(rows[4], glm::dvec4(groundLow - reach, groundHigh + reach)));
  CHECK(hashOf(rows) == "3354ed3af9ac93aef0d6829551df69a7");
}

TEST_CASE("exact kernels: balls in sight of camera and sun, in levels of detail") {
  KernelStage stage;
  // A map 10 m wide and 6.25 m deep that contains some of the balls.
  const std::vector<glm::vec4> rows = {0.1F * stage.frame.lightRight + glm::vec4(0, 0, 0, 0.45F),
                                       0.1F * stage.frame.lightUp + glm::vec4(0, 0, 0, 0.52F),
                                       -0.16F * stage.frame.sunDirection + glm::vec4(0, 0, 0, 0.5F),
                                       glm::vec4(0.01F, 10, 6.25F, 0), glm::vec4(0)};
  stage.light.write(0, std::as_bytes(std::span(rows)));
  stage.lightView.bind(draw::lightUnit);
  for (const bool forLight : {false, true}) {
    CAPTURE(forLight);
    constexpr int words = 22;
    constexpr int levels = 5;
    gl::Defines defines = {{"LEVELS", std::to_string(levels)}};
    if (forLight) defines.emplace_back("FOR_LIGHT", "1");
    const auto cull = gl::Program::compute("draw/instances/cull_instances.comp", defines);
    const gl::Buffer masks("masks", std::size_t{levels} * words * 4);
    masks.bindStorage(draw::maskBinding);
    stage.set(cull);
    cull.set("capacity", KernelStage::count);
    cull.set("words", words);
    cull.set("levelError", 0.02F);
    cull.dispatch(words);
    gl::barrier();
    const auto found = masks.readAll<unsigned>();
    int seen = 0;
    int unsure = 0;
    int used = 0;
    for (std::size_t i = 0; i < KernelStage::count; ++i) {
      const glm::dvec4 p(glm::dvec3(KernelStage::places()[i]), 1);
      double r = KernelStage::radius(i);
      double inside = 1e9;  // distance from the nearest border (m)
      double pixels = 0;
      if (forLight) {
        const double extents[] = {static_cast<double>(rows[3].y), static_cast<double>(rows[3].y),
                                  static_cast<double>(rows[3].z)};
        for (int axis = 0; axis < 3; ++axis) {
          const double at = glm::dot(glm::dvec4(rows[static_cast<std::size_t>(axis)]), p);
          inside = std::min(inside, std::min(at, 1 - at) * extents[axis]);
        }
        pixels = r / static_cast<double>(rows[3].x);
      } else {
        const double ahead = 7 - p.z;
        r = std::max(r, std::max(ahead, 0.0) * 0.8 / (27.5 / 0.625));
        const glm::dmat4 m(stage.frame.viewProjection);
        for (int axis = 0; axis < 3; ++axis)
          for (const double sign : {1.0, -1.0}) {
            glm::dvec4 plane;
            for (int k = 0; k < 4; ++k) plane[k] = m[k][3] + sign * m[k][axis];
            inside = std::min(inside, glm::dot(plane, p) / glm::length(glm::dvec3(plane)));
          }
        pixels = r * (27.5 / 0.625) / std::max(ahead - r, 1e-3);
      }
      int level = 0;
      bool close = std::abs(inside + r) < 1e-4;
      for (const double missed : {0.149, 0.0489, 0.0123, 0.0031}) {
        close = close || std::abs(missed * pixels / 0.02 - 1) < 1e-4;
        level += missed * pixels > 0.02 ? 1 : 0;
      }
      unsure += close ? 1 : 0;
      int listed = -1;
      for (int l = 0; l < levels; ++l)
        if ((found[static_cast<std::size_t>(l * words) + i / 32] >> (i % 32) & 1U) != 0) {
          CHECK(listed == -1);
          listed = l;
          used |= 1 << l;
        }
      seen += listed >= 0 ? 1 : 0;
      if (close) continue;
      CAPTURE(i);
      CHECK(listed == (KernelStage::shown(i) && inside > -r ? level : -1));
    }
    CHECK(unsure < 4);
    CHECK(seen > 100);
    CHECK(seen < KernelStage::count - 100);
    CHECK((used & (used - 1)) != 0);
    CHECK(hashOf(found) ==
          std::string(forLight ? "d6343e60b6647facc9b6b9a37726c5d2" : "c09ab157076fedbbe2910483c9990c20"));
  }
}

TEST_CASE("exact kernels: the box around a surface in the world") {
  KernelStage stage;
  const auto kernel = gl::Program::compute("draw/lights/surface_box.comp");
  glm::mat4 model(0.8F, 0.3F, -0.1F, 0, -0.2F, 0.9F, 0.4F, 0, 0.05F, -0.35F, 1.1F, 0, 2, -1, 0.5F, 1);
  std::array<GLuint, 6> empty{};
  std::fill_n(empty.begin(), 3, 0xffffffffU);
  const auto boxes = gl::Buffer::of<GLuint>("box", empty);
  boxes.bindStorage(draw::boxBinding);
  kernel.set("model", model);
  kernel.set("heightShape", glm::ivec4(0));
  kernel.set("heightGrid", glm::vec4(0));
  kernel.set("heightRim", 0.0F);
  kernel.set("surface", 0);
  kernel.set("vertexCount", 13);  // vertices with an index of 13 or more are invalid
  kernel.set("invocations", 5);
  kernel.dispatch(5);
  gl::barrier();
  const auto keys = boxes.readAll<unsigned>();
  glm::dvec3 low(1e9);
  glm::dvec3 high(-1e9);
  for (std::size_t i = 0; i < 13; ++i) {
    const glm::dvec3 p(glm::dmat4(model) * glm::dvec4(glm::dvec3(KernelStage::places()[i]), 1));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const auto valueOf = [](unsigned key) {
    return static_cast<double>(std::bit_cast<float>(key ^ ((key >> 31U) != 0 ? 0x80000000U : 0xffffffffU)));
  };
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(std::abs(valueOf(keys[static_cast<std::size_t>(axis)]) - low[axis]) < 1e-5);
    CHECK(std::abs(valueOf(keys[static_cast<std::size_t>(axis) + 3]) - high[axis]) < 1e-5);
  }
  CHECK(hashOf(keys) == "0a1fd9f42647d1fefe522d5e0b46ef9f");
}

TEST_CASE("balls' shadows do not depend on what a simulation left bound") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.direction = glm::vec3(0.3F, 1, 0.4F);
  scene.sun.shadow = true;
  scene.ground.emplace();
  scene.ground->height = -1;
  scene.camera.position = glm::vec3(0, 4, 5);
  Dice dice(21);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 60; ++i) places.push_back(dice.cube());
  InstanceStage balls(places);
  balls.instances.size = 0.2F;
  const sim::Drawables drawables{{}, {balls.instances}};
  const Picture first = drawn(scene, drawables, {97, 65});
  const auto junk = gl::Buffer::of<glm::vec4>("junk", std::vector<glm::vec4>(8, glm::vec4(1e-3F)));
  const auto view = gl::Texture::view("junk", GL_RGBA32F, junk);
  view.bind(draw::lightUnit);
  CHECK(drawn(scene, drawables, {97, 65}).bytes == first.bytes);
  const auto wide = gl::Buffer::of<glm::vec4>("junk", std::vector<glm::vec4>(8, glm::vec4(1e5F)));
  const auto wideView = gl::Texture::view("junk", GL_RGBA32F, wide);
  wideView.bind(draw::lightUnit);
  CHECK(drawn(scene, drawables, {97, 65}).bytes == first.bytes);
}
