// Kernels that decide what is drawn: each against the same in float64, and by the bits that every device
// has to give.
#include "base/hash.hpp"
#include "draw/draw_state.hpp"
#include "draw/frame_values.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr float massExponent = 0.4F;
constexpr float perMassReference = 0.5F;
constexpr float ballSize = 0.37F;
constexpr float ballRadius = 0.5F;

/// Numbers written down, so that the bits of nothing else matter: an eye 7 m before the origin.
shader::Frame writtenFrame() {
  shader::Frame frame{};
  frame.viewProjection[0] = glm::vec4(0.9F, 0, 0, 0);
  frame.viewProjection[1] = glm::vec4(0, 1.6F, 0, 0);
  frame.viewProjection[2] = glm::vec4(0, 0, -1.002F, -1);
  frame.viewProjection[3] = glm::vec4(0, 0, 6.8138F, 7);
  frame.eye = glm::vec4(0, 0, 7, 0);
  frame.rayForward = glm::vec4(0, 0, -1, 0);
  frame.rayRight = glm::vec4(1 / 0.9F, 0, 0, 0);
  frame.rayUp = glm::vec4(0, 0.625F, 0, 0);
  frame.sunDirection = glm::vec4(0.48F, 0.6F, 0.64F, 0);
  frame.lightRight = glm::vec4(0.8F, 0, -0.6F, 0);
  frame.lightUp = glm::vec4(-0.36F, 0.8F, -0.48F, 0);
  frame.shadowTexels = 512;
  frame.shadowSoftness = 1.7F;
  frame.groundHeight = -0.3F;
  frame.size = glm::vec2(97, 55);
  return frame;
}

/// The frame and 701 balls, some of them dead or lost, as kernels see them.
struct KernelStage {
  static constexpr int count = 701;

  KernelStage() : frame(writtenFrame()), block("frame values", sizeof frame), balls(places(), speeds()) {
    block.write(0, std::as_bytes(std::span(&frame, 1)));
    block.bindUniform(draw::frameBinding, 0, sizeof frame);
    balls.positionView.bind(draw::positionUnit);
    balls.velocityView.bind(draw::velocityUnit);
  }
  static std::vector<glm::vec4> places() {
    Dice dice(11);
    std::vector<glm::vec4> all;
    for (int i = 0; i < count; ++i) all.emplace_back(6.0F * dice.cube(), 0.02F + 5 * dice());
    all[13].y = 3e6F;
    all[14].x = std::numeric_limits<float>::quiet_NaN();
    return all;
  }
  static std::vector<glm::vec4> speeds() {
    Dice dice(12);
    std::vector<glm::vec4> all;
    for (int i = 0; i < count; ++i) all.emplace_back(2.0F * dice.cube(), dice() < 0.2F ? -1.0F : dice());
    return all;
  }
  static bool shown(std::size_t i) { return i != 13 && i != 14 && speeds()[i].w >= 0; }
  static double radius(std::size_t i) {
    return static_cast<double>(ballSize * ballRadius) *
           std::pow(static_cast<double>(places()[i].w * perMassReference),
                    static_cast<double>(massExponent));
  }
  void set(const gl::Program& program) const {
    program.set("size", ballSize);
    program.set("shapeRadius", ballRadius);
    program.set("massExponent", massExponent);
    program.set("perMassReference", perMassReference);
    program.set("minPixels", 0.8F);
  }
  /// Bounds of the balls, then the light's map: five rows, bound to draw::lightUnit.
  std::vector<glm::vec4> fitted() {
    std::array<GLuint, 10> empty{};
    std::fill_n(empty.begin(), 5, 0xffffffffU);
    bounds = gl::Buffer::of<GLuint>("bounds", empty);
    bounds.bindStorage(draw::boundsBinding);
    light.bindStorage(draw::lightBinding);
    const auto grow = gl::Program::compute("draw/surface/shadow_bounds.comp", {{"INSTANCES", "1"}});
    set(grow);
    grow.set("vertexCount", count);
    grow.set("invocations", 37);
    grow.dispatch(37);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    gl::Program::compute("draw/surface/shadow_fit.comp").dispatch(1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    lightView.bind(draw::lightUnit);
    return light.readAll<glm::vec4>();
  }

  gl::Context& context = testContext();
  shader::Frame frame;
  gl::Buffer block;
  InstanceStage balls;
  gl::Buffer bounds;
  gl::Buffer light{"light", 5 * sizeof(glm::vec4)};
  gl::Texture lightView = gl::Texture::view("light", GL_RGBA32F, light);
};

template <class T>
std::string hashOf(const std::vector<T>& items) {
  return hashHex(std::as_bytes(std::span(items)));
}

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
  // A map of 10 m, 6.25 m deep, which some balls are in.
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
      double inside = 1e9;  // from the nearest border (m)
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

TEST_CASE("exact kernels: glows' places, sizes and light, and their sums") {
  KernelStage stage;
  std::vector<unsigned> slots;
  for (unsigned i = 0; i < KernelStage::count; ++i)
    if (KernelStage::shown(i) && std::abs(KernelStage::places()[i].x) < 3 &&
        std::abs(KernelStage::places()[i].y) < 2 && KernelStage::places()[i].z < 3)
      slots.push_back(i);
  REQUIRE(slots.size() > 50);
  const auto number = static_cast<unsigned>(slots.size());
  const auto list = gl::Buffer::of<unsigned>("list", slots);
  const auto arguments =
      gl::Buffer::of<unsigned>("arguments", std::vector<unsigned>{0, 0, 0, 0, 0, 0, number, 0});
  const auto stops = gl::Buffer::of<glm::vec4>(
      "stops",
      std::vector<glm::vec4>{{0.1F, 0.2F, 0.9F, 1}, {0.5F, 0.4F, 0.3F, 1}, {0.9F, 0.8F, 0.05F, 1}});
  const auto listView = gl::Texture::view("list", GL_R32UI, list, 4);
  const auto argumentView = gl::Texture::view("arguments", GL_R32UI, arguments, 4);
  const auto stopView = gl::Texture::view("stops", GL_RGBA32F, stops);
  const auto bind = [&](const gl::Program& program) {
    stage.set(program);
    program.set("level", 0);
    program.set("colorBy", 1);
    program.set("stopCount", 3);
    program.set("colorFactor", 0.4F);
    program.set("colorOffset", -0.1F);
    program.set("brightness", 3.0F);
    program.set("fade", 0.3F);
    listView.bind(draw::listUnit);
    argumentView.bind(draw::argumentUnit);
    stopView.bind(draw::stopUnit);
  };
  struct Glow {
    glm::dvec3 place;
    double pixels;
    glm::dvec3 light;
  };
  const auto glowOf = [&](std::size_t i) {
    const glm::dvec4 p(glm::dvec3(KernelStage::places()[i]), 1);
    const glm::dvec4 clip = glm::dmat4(stage.frame.viewProjection) * p;
    const double scale = 27.5 / 0.625 / (7 - p.z);
    const double fraction = std::min(KernelStage::radius(i) * scale / 0.8, 1.0);
    const double age = static_cast<double>(KernelStage::speeds()[i].w);
    const double life = std::clamp(std::min(age, 1 - age) / 0.3, 0.0, 1.0);
    const double speed = glm::length(glm::dvec3(KernelStage::speeds()[i]));
    const double at = 2 * std::clamp(0.4 * speed - 0.1, 0.0, 1.0);
    const glm::dvec3 colors[] = {{0.1, 0.2, 0.9}, {0.5, 0.4, 0.3}, {0.9, 0.8, 0.05}};
    const int below = std::min(static_cast<int>(at), 1);
    return Glow{glm::dvec3(clip) / clip.w, std::max(KernelStage::radius(i) * scale, 0.8),
                glm::mix(colors[below], colors[below + 1], at - below) *
                    (3 * life * life * (3 - 2 * life) * fraction * fraction)};
  };

  const auto kernel = gl::Program::compute("draw/instances/small_sprites.comp", {{"GLOW", "1"}});
  bind(kernel);
  const gl::Buffer sprites("sprites", slots.size() * 16);
  sprites.bindStorage(draw::spriteBinding);
  kernel.set("invocations", 64);
  kernel.dispatch(64);
  gl::barrier();
  const auto packed = sprites.readAll<glm::uvec4>();
  for (std::size_t s = 0; s < slots.size(); ++s) {
    CAPTURE(s);
    const Glow wanted = glowOf(slots[s]);
    const glm::uvec4 w = packed[s];
    const double x = (w.x & 0xfffffU) / 1048575.0 * 2 - 1;
    const double y = (w.x >> 20U | (w.y & 0xffU) << 12U) / 1048575.0 * 2 - 1;
    CHECK(glm::length(glm::dvec3(x, y, (w.y >> 8U) / 16777215.0 * 2 - 1) - wanted.place) < 3e-6);
    const double unit = std::exp2(static_cast<double>(w.w >> 27U) - 24);
    const glm::dvec3 light = unit * glm::dvec3(w.w & 511U, w.w >> 9U & 511U, w.w >> 18U & 511U);
    CHECK(glm::length(light - wanted.light) < 0.51 * 1.75 * unit);
    CHECK((w.z >> 16U) == 0x7f7fU);  // no slope
  }
  CHECK(hashOf(packed) == "15dffbfadd0c9547947f4c22a944c6ce");

  const glm::ivec2 size(stage.frame.size);
  const auto sum =
      gl::Program::compute("draw/instances/glow_sums.comp", {{"SAMPLES", "1"}, {"SLICES", "8"}});
  bind(sum);
  sum.set("strides", 64);
  sum.set("roundPixels", 6.0F);
  const gl::Texture depth = gl::Texture::image("depth", GL_R32F, size.x, size.y);
  const float far = 1;
  glClearTexImage(depth.name(), 0, GL_RED, GL_FLOAT, &far);
  depth.bind(draw::depthUnit);
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const gl::Buffer sums("sums", pixels * 24);
  sums.bindStorage(draw::glowBinding);
  sum.dispatch(64);
  gl::barrier();
  const auto words = sums.readAll<unsigned>();
  std::vector<double> wanted(pixels, 0.0);
  for (const unsigned slot : slots) {
    const Glow g = glowOf(slot);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::dvec2 aside =
            (glm::dvec2(x, y) + 0.5 - (glm::dvec2(g.place) * 0.5 + 0.5) * glm::dvec2(size)) / g.pixels;
        const double inside = std::max(1 - glm::dot(aside, aside), 0.0);
        wanted[static_cast<std::size_t>(y * size.x + x)] += g.light.y * inside * inside;
      }
  }
  double brightest = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const double found = words[6 * i + 1] / 16777216.0 + 256.0 * words[6 * i + 4];
    brightest = std::max(brightest, found);
    CHECK(std::abs(found - wanted[i]) < 1e-5 * (1 + wanted[i]));
  }
  CHECK(brightest > 1);
  CHECK(hashOf(words) == "ecee81e314728ccb104a4d8dc293eec9");
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
  kernel.set("surface", 0);
  kernel.set("vertexCount", 13);  // the next ones are lost
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
  scene.hasGround = true;
  scene.ground.height = -1;
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
