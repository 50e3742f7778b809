// Tests time steps that are too long for the expressions, by the stability limits of the methods.
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/presets.hpp"
#include "sim/reaction/stability.hpp"
#include "sim/world/list.hpp"

#include <cmath>
#include <optional>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

std::optional<sim::StepGrowth> growthOf(const std::string& members) {
  const std::string text =
      "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {\"size\": [16, 12], " + members + "}}}}";
  const auto scene = scene::parseScene(text, "s.json", {}, sim::kinds());
  const sim::ReactionPlan plan(
      dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters), "r", 1, 0.1);
  return unstableSteps(plan, plan.firstField().stage);
}

std::optional<sim::StepGrowth> growthOf(const char* rate, double dt, const char* method) {
  return growthOf(
      fmt::format(R"X("dt": {}, "method": "{}", "species": {{"u": {{"start": "1", "rate": "{}"}}}})X", dt,
                  method, rate));
}

}  // namespace

TEST_CASE("reaction: time steps that amplify small waves are detected, and stable ones are not reported") {
  // The Laplacian of the fastest wave has the eigenvalue -16/3.
  CHECK_FALSE(growthOf("laplacian(u)", 0.37, "euler"));
  CHECK_FALSE(growthOf("laplacian(u)", 0.51, "rk4"));
  CHECK(growthOf("laplacian(u)", 0.54, "rk4"));
  const auto heat = growthOf("laplacian(u)", 0.45, "euler");
  REQUIRE(heat);
  CHECK(heat->step == doctest::Approx(0.45 * 16 / 3 - 1).epsilon(0.01));
  CHECK(heat->equations == doctest::Approx(1).epsilon(0.01));
  CHECK(heat->dt == 0.225);
  CHECK_FALSE(growthOf("-laplacian(laplacian(u))", 0.069, "heun"));
  CHECK(growthOf("-laplacian(laplacian(u))", 0.076, "heun"));
  const auto decay = growthOf("-100*u", 0.1, "euler");
  REQUIRE(decay);
  CHECK(decay->step == doctest::Approx(9).epsilon(0.01));
  // With Euler's method, oscillations grow. A wave of four cells moves by one cell in a time of 1.
  const auto moved = growthOf("ddx(u)", 0.5, "euler");
  REQUIRE(moved);
  CHECK(moved->step == doctest::Approx(std::sqrt(1.25)).epsilon(0.01));
  CHECK_FALSE(growthOf("ddx(u)", 0.5, "rk4"));
  // Growth that is part of the equation itself is allowed.
  CHECK_FALSE(growthOf("3*u", 0.2, "euler"));
  CHECK_FALSE(growthOf("-laplacian(u)", 0.1, "euler"));
}

TEST_CASE("reaction: the default time step of every preset is stable") {
  for (const sim::ReactionPreset& preset : sim::reactionPresets()) {
    CAPTURE(std::string(preset.name));
    CHECK_FALSE(growthOf(fmt::format("\"preset\": \"{}\"", preset.name)));
  }
}
