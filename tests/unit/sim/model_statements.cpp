// Tests rules of models by comparison with independent implementations in double precision. This is needed
// because the twins compile the kernels and would repeat their errors.
#include "sim/core/shader_code.hpp"
#include "sim/particles/gravity_tree.hpp"
#include "sim/spread/epidemic_plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <glm/vec4.hpp>

namespace {

namespace models {

using namespace simreel::shader;

inline int findLSB(int x) {
  return std::countr_zero(static_cast<unsigned>(x));
}

#define FUNCTION inline
#define precise
#define REAL float
struct Epidemic {
  const EpidemicStep& stepData;
#include "glsl/spread/epidemic/model.glsl"
};
struct Gale {
#include "glsl/spread/wildfire/gale.glsl"
};
struct GravityTree {
  [[nodiscard]] static vec4 loadBody(int /*unused*/) { return vec4(0); }
#include "glsl/particles/tree/model.glsl"
};
#undef REAL
#undef precise
#undef FUNCTION

}  // namespace models

}  // namespace

TEST_CASE("epidemic: meeting eight random people infects with probability 1 - (1 - beta fraction)^8") {
  constexpr double people = 1e6;
  for (const double beta : {0.02, 0.3, 0.9})
    for (const unsigned infected : {0U, 1U, 4095U, 4096U, 300000U, 999999U}) {
      simreel::shader::EpidemicStep step{};
      step.perInfected = static_cast<float>(beta / people);
      step.per4096 = static_cast<float>(beta / people * 4096);
      const double expected = (1 - std::pow(1 - beta * infected / people, 8)) * 0x1p31;
      CAPTURE(beta);
      CAPTURE(infected);
      // The tolerance is 2, because thresholds are even numbers and may be rounded to the next one.
      CHECK(std::abs(models::Epidemic{step}.mixedThreshold(infected) - expected) <= 2 + 1e-6 * expected);
    }
}

TEST_CASE("wildfire: wind is stored in units of 1/2048, up to 15.99, and acts by its exponential") {
  models::Gale model;
  CHECK(model.galeOf(0, 0, 1) == model.stillAir);
  CHECK(model.stillAir == 0);  // Maps without wind contain the value 0.
  const int neighbours[8][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
  for (const double u : {0.0, 0.7, -3.1, 31.9, -31.9, 90.0, -90.0})
    for (const double v : {0.0, -0.2, 5.3, 70.0, -70.0}) {
      CAPTURE(u);
      CAPTURE(v);
      const auto gale = model.galeOf(static_cast<float>(u), static_cast<float>(v), 0.5F);
      const double x = std::clamp(0.5 * u, -15.99, 15.99), y = std::clamp(0.5 * v, -15.99, 15.99);
      const auto parts = model.galeParts(gale);
      CHECK(parts.x == static_cast<int>(std::floor(2048 * x + 0.5)));
      CHECK(parts.y == static_cast<int>(std::floor(2048 * y + 0.5)));
      for (unsigned d = 0; d < 8; ++d)
        for (const unsigned chance : {1U, 300U, 40000U, 65536U}) {
          const auto& way = neighbours[d];
          const double along = -(way[0] * parts.x + way[1] * parts.y) / 2048.0 / std::hypot(way[0], way[1]);
          const double expected = std::min(chance * std::exp(along), 65536.0);
          CHECK(std::abs(model.blownOver(chance, d, gale) - expected) <= 1 + 2e-5 * expected);
        }
    }
}

TEST_CASE("gravity tree: bodies take part by position and mass, exactly at the limits") {
  const auto takesPart = [](float x, float y, float z, float mass) {
    return models::GravityTree().takesPart({x, y, z, mass});
  };
  const float far = 1e18F, below = std::nextafter(far, 0.0F);
  for (const float sign : {-1.0F, 1.0F}) {
    CHECK(takesPart(sign * below, sign * below, sign * below, 1));
    CHECK_FALSE(takesPart(sign * far, 0, 0, 1));
    CHECK_FALSE(takesPart(0, sign * far, 0, 1));
    CHECK_FALSE(takesPart(0, 0, sign * far, 1));
  }
  CHECK_FALSE(takesPart(std::numeric_limits<float>::quiet_NaN(), 0, 0, 1));
  const float light = 1e-30F, heavy = 1e30F;
  CHECK_FALSE(takesPart(0, 0, 0, light));
  CHECK(takesPart(0, 0, 0, std::nextafter(light, 1.0F)));
  CHECK(takesPart(0, 0, 0, std::nextafter(heavy, 0.0F)));
  CHECK_FALSE(takesPart(0, 0, 0, heavy));
  CHECK_FALSE(takesPart(0, 0, 0, -1));
}
