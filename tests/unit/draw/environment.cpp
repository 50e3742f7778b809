// Tests environment light: the data computed from an image, and the values that shaders read.
#include "draw/environment.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "draw/picture_code.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

using namespace simreel::shader;  // NOLINT: the functions are written in GLSL's names

std::vector<glm::vec4> texelsNow;
glm::vec4 environmentTexel(int i) {
  return texelsNow.at(static_cast<std::size_t>(i));
}

#define ENVIRONMENT 64
#define FUNCTION inline
#define precise
#include "glsl/draw/environment.glsl"
#undef precise
#undef FUNCTION
#undef ENVIRONMENT

constexpr double pi = std::numbers::pi;

/// Returns the direction of a pixel's centre, for a picture whose centre is in the direction -z.
glm::dvec3 looksAt(int x, int y, glm::ivec2 size) {
  const double u = 2 * pi * ((x + 0.5) / size.x - 0.5), v = pi * (y + 0.5) / size.y;
  return {std::sin(v) * std::sin(u), std::cos(v), -std::sin(v) * std::cos(u)};
}

sim::LightFile pictureOf(const std::function<glm::dvec3(glm::dvec3)>& light, glm::ivec2 size = {64, 32}) {
  sim::LightFile file;
  file.size = size;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec3 here = light(looksAt(x, y, size));
      for (int i = 0; i < 3; ++i) file.values.push_back(static_cast<float>(here[i]));
      file.values.push_back(1);
    }
  return file;
}

void load(const sim::LightFile& file, double strength = 1, double turn = 0) {
  draw::EnvironmentTexels made = draw::environmentOf(file, strength, turn, "picture");
  REQUIRE(made.side == 64);
  texelsNow = std::move(made.texels);
  REQUIRE(texelsNow.size() == static_cast<std::size_t>(environmentStart(environmentLevels)));
}

const std::array<glm::vec3, 8> ways = {glm::vec3(0, 1, 0),
                                       glm::vec3(0, -1, 0),
                                       glm::vec3(0, 0, -1),
                                       glm::vec3(1, 0, 0),
                                       glm::vec3(-1, 0, 0),
                                       glm::vec3(0, 0, 1),
                                       glm::normalize(glm::vec3(1, -2, 3)),
                                       glm::normalize(glm::vec3(-4, 1, -2))};

}  // namespace

TEST_CASE("environment: a uniform environment gives uniform irradiance") {
  load(pictureOf([](glm::dvec3) { return glm::dvec3(0.5, 1, 2); }), 3);
  for (const glm::vec3& way : ways)
    for (const float roughness : {0.0F, 0.1F, 0.25F, 0.6F, 1.0F}) {
      CHECK(glm::length(environmentMirrored(way, roughness) - glm::vec3(1.5F, 3, 6)) < 1e-4F);
      CHECK(glm::length(environmentAmbient(way) - glm::vec3(1.5F, 3, 6)) < 5e-3F);
    }
}

TEST_CASE("environment: directions map to the right texels, also with rotation") {
  // Smooth light that differs in every direction.
  const auto light = [](glm::dvec3 d) { return glm::dvec3(1 + 0.5 * d.x, 1 + 0.5 * d.y, 1 + 0.5 * d.z); };
  load(pictureOf(light));
  for (const glm::vec3& way : ways)
    CHECK(glm::length(environmentAt(way, 0) - glm::vec3(light(glm::dvec3(way)))) < 0.02F);
  // Tests directions along the edges of the map, from both sides.
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * pi * i / 400;
    for (const double y : {-0.99, -0.3, -1e-4, 1e-4, 0.4}) {
      const double round = std::sqrt(1 - y * y);
      const glm::dvec3 way(round * std::sin(angle), y, round * std::cos(angle));
      CHECK(glm::length(environmentAt(glm::vec3(way), 0) - glm::vec3(light(way))) < 0.02F);
    }
  }
  load(pictureOf(light), 1, 90);  // With a turn of 90 degrees, the image's centre is in the direction +x.
  for (const glm::vec3& way : ways) {
    const glm::dvec3 before(way.z, way.y, -way.x);
    CHECK(glm::length(environmentAt(way, 0) - glm::vec3(light(before))) < 0.02F);
    CHECK(glm::length(environmentAmbient(way) - glm::vec3(1) - glm::vec3(before) / 3.0F) < 0.01F);
  }
}

TEST_CASE("environment: irradiance is the integral over the hemisphere") {
  const auto light = [](glm::dvec3 d) {
    const double lamp = std::pow(std::fmax(glm::dot(d, glm::normalize(glm::dvec3(1, 2, 0.5))), 0), 4);
    return glm::dvec3(0.2 + 3 * lamp, 0.2 + lamp, 0.4 + 0.2 * d.y);
  };
  load(pictureOf(light));
  const glm::ivec2 size(360, 180);
  for (const glm::vec3& way : ways) {
    glm::dvec3 sum(0);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::dvec3 d = looksAt(x, y, size);
        const double angle =
            2 * pi / size.x * (std::cos(pi * y / size.y) - std::cos(pi * (y + 1) / size.y));
        sum += light(d) * (std::fmax(glm::dot(d, glm::dvec3(way)), 0) * angle / pi);
      }
    // Second-degree harmonics are accurate to a few hundredths of the max.
    CHECK(glm::length(environmentAmbient(way) - glm::vec3(sum)) < 0.06F);
  }
}

TEST_CASE("environment: rough reflections are the mean over a GGX lobe") {
  const glm::dvec3 lamp = glm::normalize(glm::dvec3(-1, 1, -2));
  const auto light = [&](glm::dvec3 d) {
    return glm::dvec3(std::pow(std::fmax(glm::dot(d, lamp), 0), 24));
  };
  load(pictureOf(light));
  const glm::ivec2 size(512, 256);
  for (const double roughness : {0.25, 0.5, 0.75, 1.0})
    for (const glm::dvec3& way :
         {lamp, glm::normalize(lamp + glm::dvec3(0.2, 0.1, 0)), glm::dvec3(0, 1, 0)}) {
      // Half vectors h are weighted by D(h) cos, with the eye along the normal. Reflections are weighted by
      // cos.
      const double alpha = roughness * roughness;
      double sum = 0, weights = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const glm::dvec3 d = looksAt(x, y, size);
          const double cosine = glm::dot(d, way);
          if (cosine <= 0) continue;
          const glm::dvec3 half = glm::normalize(d + way);
          const double nh = glm::dot(half, way), under = nh * nh * (alpha * alpha - 1) + 1;
          const double weight =
              alpha * alpha / (under * under) * cosine * std::sin(pi * (y + 0.5) / size.y);
          sum += weight * light(d).x;
          weights += weight;
        }
      CAPTURE(roughness);
      CHECK(environmentMirrored(glm::vec3(way), static_cast<float>(roughness)).x ==
            doctest::Approx(sum / weights).epsilon(0.03).scale(0.2));
    }
}

TEST_CASE("environment: an image that is not a panorama is reported") {
  const auto says = [](const sim::LightFile& file, const char* words) {
    try {
      static_cast<void>(draw::environmentOf(file, 1, 0, "the sky's picture a.hdr"));
    } catch (const UserError& error) {
      INFO(error.what());
      return std::string(error.what()).find(words) != std::string::npos;
    }
    return false;
  };
  sim::LightFile file = pictureOf([](glm::dvec3) { return glm::dvec3(1); }, {64, 64});
  CHECK(says(file, "has 64x64 pixels; an equirectangular picture is twice as wide as high"));
  file = pictureOf([](glm::dvec3) { return glm::dvec3(1); });
  file.values[4 * (64 * 3 + 7) + 1] = NAN;
  CHECK(says(file, "has the value nan at column 7, row 3, which is not a valid amount of light"));
  file.values[4 * (64 * 3 + 7) + 1] = -0.01F;
  CHECK(says(file, "has the value -0.01 at column 7, row 3, which is not a valid amount of light"));
  file = pictureOf([](glm::dvec3) { return glm::dvec3(1); });
  file.colours = "primaries of its own";
  CHECK(says(file, "has primaries of its own; convert it to those of Rec. 709"));
  file.colours.clear();
  file.unfit = "has no channel B";
  CHECK(says(file, "a.hdr has no channel B"));
}

TEST_CASE("environment: slightly negative values from resampling become 0") {
  const Silence silence;
  sim::LightFile file = pictureOf([](glm::dvec3) { return glm::dvec3(0); });
  const draw::EnvironmentTexels black = draw::environmentOf(file, 1, 0, "picture");
  file.values[4 * (64 * 3 + 7) + 1] = -1e-5F;
  const draw::EnvironmentTexels made = draw::environmentOf(file, 1, 0, "picture");
  CHECK(made.texels == black.texels);
}
