// Tests the kernels of glows by comparison with float64 versions, and tests the bits that every device must
// produce.
#include "gpu/draw/exact/kernel_stage.hpp"

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace simreel;

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
    program.set("color", glm::vec3(0));
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
    CHECK((w.z >> 16U) == 0x7f7fU);  // the packed slope means zero
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
