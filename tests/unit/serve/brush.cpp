#include "serve/edit/brush.hpp"

#include "sim/fluid/parameters.hpp"
#include "sim/world/list.hpp"

#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using Json = nlohmann::json;

namespace {

scene::Scene sceneOf(const std::string& kind, const Json& given) {
  const Json all = {{"version", 1}, {"objects", {{"it", {{kind, given}}}}}};
  return scene::parseScene(all.dump(), "test.json", {}, sim::kinds());
}

/// The stroke that a piece of the brush's way leaves.
Json painted(const std::string& kind, const Json& given, const serve::BrushPiece& piece) {
  return serve::strokeOf(sceneOf(kind, given).objects.front(), given, piece);
}

}  // namespace

TEST_CASE("serve: a fluid that is painted keeps the jets that nobody gave it") {
  Json given = Json::parse(R"({"size": [64, 40]})");
  const scene::Scene left = sceneOf("fluid", given);
  given["strokes"] = serve::strokesOf(left.objects.front(), given);
  const scene::Scene told = sceneOf("fluid", given);
  const auto& jets = sim::parametersOf<sim::FluidParameters>(left.objects.front()).strokes;
  const auto& same = sim::parametersOf<sim::FluidParameters>(told.objects.front()).strokes;
  REQUIRE_EQ(jets.size(), 10);
  REQUIRE_EQ(same.size(), jets.size());
  for (std::size_t i = 0; i < jets.size(); ++i) {
    CAPTURE(i);
    CHECK(same[i].from == jets[i].from);
    CHECK(same[i].to == jets[i].to);
    CHECK_EQ(same[i].until, jets[i].until);
    CHECK_EQ(same[i].radius, jets[i].radius);
    CHECK(same[i].setsDye);
    CHECK(same[i].setsVelocity);
    CHECK_FALSE(same[i].setsTemperature);
    CHECK(same[i].velocity.at(0) == jets[i].velocity.at(0));
    CHECK(same[i].dye.at(0) == jets[i].dye.at(0));
  }
  CHECK_EQ(serve::strokesOf(left.objects.front(), Json::parse(R"({"strokes": []})")), Json::array());
}

TEST_CASE("serve: a brush sets something in a fluid, and pushes it along, no faster than it may go") {
  const Json given = Json::parse(R"({"size": [64, 40], "speed": 50})");
  const Json pressed = painted("fluid", given, {.from = {3, 4}, .to = {3, 4}});
  CHECK(pressed.contains("dye"));
  CHECK_FALSE(pressed.contains("velocity"));
  CHECK_EQ(painted("fluid", given, {.from = {3, 4}, .to = {6, 4}})["velocity"], Json({25.0, 0.0, 0}));
  CHECK_EQ(painted("fluid", given, {.from = {3, 4}, .to = {3, 40}})["velocity"], Json({0.0, 50.0, 0}));
  const Json fire = Json::parse(R"({"strokes": [{"temperature": 1}]})");
  CHECK(painted("fluid", fire, {}).contains("temperature"));
  CHECK_FALSE(painted("fluid", fire, {}).contains("dye"));
}

TEST_CASE("serve: a stroke begins at the step that the frame shows") {
  const auto begins = [](const std::string& kind, const Json& given, double time) {
    return painted(kind, given, {.time = time})["at"].get<double>();
  };
  CHECK_EQ(begins("life", Json::object(), 2.0 / 30), 0);
  CHECK_EQ(begins("life", Json::object(), 3.0 / 30), doctest::Approx(0.1));
  CHECK_EQ(begins("life", {{"stepsPerSecond", 100}}, 2.0 / 30), doctest::Approx(0.06));
  CHECK_EQ(begins("grayScott", Json::object(), 2.0 / 30), 2.0 / 30);
  CHECK_EQ(painted("life", Json::object(), {.value = 0})["value"].get<double>(), 0);
  CHECK_FALSE(painted("life", Json::object(), {}).contains("value"));
}
