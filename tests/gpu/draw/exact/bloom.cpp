// Tests bloom against its definition in double precision. Light above the threshold is repeatedly halved in
// size by the five overlapping 4x4 boxes of Jimenez, and tent filters enlarge each level.
#include "draw/exact/screen/bloom.hpp"

#include "gpu/draw/instance_stage.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <doctest/doctest.h>
#include <glm/common.hpp>

using namespace simreel;

namespace {

/// Light of each pixel. Positions outside the picture are clamped to its border.
struct LightImage {
  glm::ivec2 size{0};
  std::vector<glm::dvec3> texels;

  LightImage(glm::ivec2 of, const std::function<glm::dvec3(int, int)>& at) : size(of) {
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) texels.push_back(at(x, y));
  }
  [[nodiscard]] glm::dvec3 at(int x, int y) const {
    x = std::clamp(x, 0, size.x - 1);
    y = std::clamp(y, 0, size.y - 1);
    return texels[static_cast<std::size_t>(y * size.x + x)];
  }
  /// Interpolates bilinearly; texel centres are at integers plus one half.
  [[nodiscard]] glm::dvec3 between(double x, double y) const {
    const int left = static_cast<int>(std::floor(x - 0.5));
    const int top = static_cast<int>(std::floor(y - 0.5));
    const double across = x - 0.5 - left;
    const double down = y - 0.5 - top;
    return glm::mix(glm::mix(at(left, top), at(left + 1, top), across),
                    glm::mix(at(left, top + 1), at(left + 1, top + 1), across), down);
  }
  [[nodiscard]] glm::dvec3 square(int x, int y) const {
    glm::dvec3 sum(0);
    for (int i = 0; i < 16; ++i) sum += at(x + i % 4, y + i / 4);
    return sum / 16.0;
  }
};

LightImage aboveThreshold(const LightImage& image, double threshold) {
  const LightImage rest(image.size, [&](int x, int y) {
    const glm::dvec3 light = glm::min(image.at(x, y), glm::dvec3(6e4));
    const double brightest = std::max({light.x, light.y, light.z});
    return brightest > threshold ? light * (1 - threshold / brightest) : glm::dvec3(0);
  });
  return {(image.size + 1) / 2, [&](int x, int y) {
            return (rest.at(2 * x, 2 * y) + rest.at(2 * x + 1, 2 * y) + rest.at(2 * x, 2 * y + 1) +
                    rest.at(2 * x + 1, 2 * y + 1)) /
                   4.0;
          }};
}

LightImage smaller(const LightImage& image) {
  return {(image.size + 1) / 2, [&](int x, int y) {
            glm::dvec3 sum = 0.5 * image.square(2 * x - 1, 2 * y - 1);
            for (const int across : {-2, 0})
              for (const int down : {-2, 0}) sum += 0.125 * image.square(2 * x + across, 2 * y + down);
            return sum;
          }};
}

LightImage larger(const LightImage& image, glm::ivec2 size) {
  return {size, [&](int x, int y) {
            glm::dvec3 sum(0);
            for (const int across : {-1, 0, 1})
              for (const int down : {-1, 0, 1})
                sum += image.between(0.5 * (x + 0.5) + across, 0.5 * (y + 0.5) + down) *
                       static_cast<double>((2 - std::abs(across)) * (2 - std::abs(down))) / 16.0;
            return sum;
          }};
}

}  // namespace

TEST_CASE(
    "exact bloom: levels of half the size and their sum, in double precision, also of pictures of few "
    "pixels") {
  testContext();
  Dice dice(61);
  for (const glm::ivec2 size :
       {glm::ivec2(73, 41), {38, 64}, {9, 7}, {6, 5}, {5, 11}, {3, 70}, {4, 3}, {3, 3}, {1, 1}}) {
    std::vector<glm::vec4> light;
    for (int i = 0; i < size.x * size.y; ++i) {
      const glm::vec3 color = 0.5F * dice.cube() + 0.5F;
      light.emplace_back((i % 7 == 3 ? 30.0F : 1.5F) * color, 1);
    }
    if (light.size() > 40) light[33].x = 2e5F;  // bloom clamps light to 60,000
    gl::Texture image = gl::Texture::image("light", GL_RGBA32F, size.x, size.y);
    glTextureSubImage2D(image.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, light.data());
    const LightImage given(size, [&](int x, int y) {
      return glm::dvec3(glm::vec3(light[static_cast<std::size_t>(y * size.x + x)]));
    });
    for (const float radius : {0.9F, 0.11F}) {
      CAPTURE(size.x);
      CAPTURE(size.y);
      CAPTURE(radius);
      scene::Bloom settings;
      settings.strength = 0.4F;
      settings.threshold = 0.7F;
      settings.radius = radius;
      const draw::Bloom bloom(settings, size);
      REQUIRE(bloom.on());
      const gl::Texture& found = bloom.draw(image);
      REQUIRE(glm::ivec2(found.width(), found.height()) == (size + 1) / 2);
      glMemoryBarrier(GL_ALL_BARRIER_BITS);
      std::vector<glm::vec4> texels(static_cast<std::size_t>(found.width()) *
                                    static_cast<std::size_t>(found.height()));
      glGetTextureImage(found.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(16 * texels.size()),
                        texels.data());
      testContext().check();

      // All levels have equal weight, except the last one, whose weight is the fractional part of the
      // logarithm of the reach.
      const double reach = std::clamp(std::log2(static_cast<double>(radius) * size.y), 1.0, 9.0);
      std::vector<LightImage> levels = {aboveThreshold(given, static_cast<double>(0.7F))};
      while (static_cast<double>(levels.size()) < reach &&
             std::max(levels.back().size.x, levels.back().size.y) > 2)
        levels.push_back(smaller(levels.back()));
      const double whole = std::min(reach, static_cast<double>(levels.size()));
      std::vector<glm::dvec3> wanted(texels.size(), glm::dvec3(0));
      for (std::size_t i = 0; i < levels.size(); ++i) {
        LightImage level = levels[i];
        for (std::size_t k = i; k-- > 0;) level = larger(level, levels[k].size);
        const double share = std::min(1.0, whole - static_cast<double>(i)) / whole;
        for (std::size_t k = 0; k < wanted.size(); ++k) wanted[k] += share * level.texels[k];
      }
      int wrong = 0;
      for (std::size_t k = 0; k < wanted.size(); ++k)
        for (int channel = 0; channel < 3; ++channel)
          wrong += std::abs(static_cast<double>(texels[k][channel]) - wanted[k][channel]) >
                           1e-5 * (0.01 + wanted[k][channel])
                       ? 1
                       : 0;
      CHECK(wrong == 0);
    }
  }
}
