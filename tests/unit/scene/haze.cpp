// Tests the reading of haze, and how far ground and view then reach.
#include "base/error.hpp"
#include "draw/frame_values.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"

#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace simreel::test::haze {

namespace {

scene::Scene parsed(const std::string& members) {
  return scene::parseScene(
      fmt::format(R"({{"version": 2, {}"objects": {{"b": {{"sphere": {{}}}}}}}})", members), "haze.json",
      {}, sim::kinds());
}

std::string mistakeOf(const std::string& members) {
  try {
    static_cast<void>(parsed(members));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("haze: a number alone is its distance, and keyframes alone are too") {
  CHECK(!parsed("").haze);
  CHECK(parsed(R"("haze": {}, )").haze->distance.at(0) == 200);
  CHECK(parsed(R"("haze": 35, )").haze->distance.at(0) == 35);
  CHECK(!parsed(R"("haze": 35, )").haze->color);
  const scene::Scene moving = parsed(R"("haze": {"keys": [[0, 10], [2, 30]]}, )");
  CHECK(moving.haze->distance.at(1) == 20);
  const scene::Scene all =
      parsed(R"("haze": {"distance": 5, "color": [1, 0.5, 0], "height": 4, "start": 3}, )");
  CHECK(all.haze->color->at(0) == glm::vec3(1, 0.5F, 0));
  CHECK(*all.haze->height == 4);
  const shader::Frame frame = draw::frameValues(all, {64, 36}, 0, {});
  CHECK(frame.haze.x == 0.2F);
  CHECK(frame.haze.y == 0.25F);
  CHECK(frame.haze.z == 3);
  CHECK(frame.haze.w == all.ground->height);
}

TEST_CASE("haze: wrong values are reported in one line each") {
  for (const auto& [members, text] : {
           std::pair{R"("haze": 0, )", "\"distance\" must be at least 0.001 m, found 0"},
           std::pair{R"("haze": "thick", )", "expected an object or a distance, found a string"},
           std::pair{R"("haze": {"height": -2}, )", "-2"},
           std::pair{R"("haze": {"color": [1, -1, 0]}, )", "-1"},
           std::pair{R"("haze": {"start": -1}, )", "-1"},
           std::pair{R"("haze": {"density": 2}, )", "\"density\""},
           std::pair{R"("haze": 9, "render": {"rasterizer": "driver"}, )",
                     "haze needs \"rasterizer\": \"exact\""},
       }) {
    const std::string found = mistakeOf(members);
    CAPTURE(found);
    CHECK(found.find(text) != std::string::npos);
    CHECK(found.find("error: ") == found.rfind("error: "));
  }
}

TEST_CASE("haze: ground and view reach to where haze hides them, unless the scene says how far") {
  const scene::Scene plain = parsed("");
  const scene::Scene hazy = parsed(R"("haze": {"distance": 500, "start": 10}, )");
  CHECK(plain.ground->fadeEnd < 100);
  CHECK(hazy.ground->fadeStart == 2510);
  CHECK(hazy.ground->fadeEnd == 4010);
  CHECK(hazy.camera.far > hazy.ground->fadeEnd);
  const scene::Scene given =
      parsed(R"("haze": 500, "ground": {"fadeStart": 9, "fadeEnd": 20}, "camera": {"far": 90}, )");
  CHECK(given.ground->fadeEnd == 20);
  CHECK(given.camera.far == 90);
  CHECK(parsed(R"("haze": 1e-3, )").ground->fadeEnd == plain.ground->fadeEnd);
}

}  // namespace simreel::test::haze
