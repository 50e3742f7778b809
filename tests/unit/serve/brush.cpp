#include "serve/edit/brush.hpp"

#include "scene/load.hpp"
#include "sim/fluid/parameters.hpp"
#include "sim/world/list.hpp"

#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {

simreel::scene::Scene brushedScene(const std::string& kind, const nlohmann::json& given) {
  const nlohmann::json all = {{"version", 1}, {"objects", {{"it", {{kind, given}}}}}};
  return simreel::scene::parseScene(all.dump(), "test.json", {}, simreel::sim::kinds());
}

/// Returns the stroke made by one segment of the brush's path.
nlohmann::json brushedStroke(const std::string& kind, const nlohmann::json& given,
                             const simreel::serve::BrushPiece& piece) {
  return simreel::serve::strokeOf(brushedScene(kind, given).objects.front(), given, piece);
}

}  // namespace

TEST_CASE("serve: a painted fluid keeps its default jets") {
  nlohmann::json given = nlohmann::json::parse(R"({"size": [64, 40]})");
  const simreel::scene::Scene left = brushedScene("fluid", given);
  given["strokes"] = simreel::serve::strokesOf(left.objects.front(), given);
  const simreel::scene::Scene brushed = brushedScene("fluid", given);
  const auto& jets =
      simreel::sim::parametersOf<simreel::sim::FluidParameters>(left.objects.front()).strokes;
  const auto& same =
      simreel::sim::parametersOf<simreel::sim::FluidParameters>(brushed.objects.front()).strokes;
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
  CHECK_EQ(simreel::serve::strokesOf(left.objects.front(), nlohmann::json::parse(R"({"strokes": []})")),
           nlohmann::json::array());
}

TEST_CASE("serve: a brush sets values in a fluid and pushes it, up to the fluid's max speed") {
  const nlohmann::json given = nlohmann::json::parse(R"({"size": [64, 40], "speed": 50})");
  const nlohmann::json pressed = brushedStroke("fluid", given, {.from = {3, 4}, .to = {3, 4}});
  CHECK(pressed.contains("dye"));
  CHECK_FALSE(pressed.contains("velocity"));
  CHECK_EQ(brushedStroke("fluid", given, {.from = {3, 4}, .to = {6, 4}})["velocity"],
           nlohmann::json({25.0, 0.0, 0}));
  CHECK_EQ(brushedStroke("fluid", given, {.from = {3, 4}, .to = {3, 40}})["velocity"],
           nlohmann::json({0.0, 50.0, 0}));
  const nlohmann::json fire = nlohmann::json::parse(R"({"strokes": [{"temperature": 1}]})");
  CHECK(brushedStroke("fluid", fire, {}).contains("temperature"));
  CHECK_FALSE(brushedStroke("fluid", fire, {}).contains("dye"));
}

TEST_CASE("serve: a stroke starts at the simulation step of the displayed frame") {
  const auto begins = [](const std::string& kind, const nlohmann::json& given, double time) {
    return brushedStroke(kind, given, {.time = time})["at"].get<double>();
  };
  CHECK_EQ(begins("life", nlohmann::json::object(), 2.0 / 30), 0);
  CHECK_EQ(begins("life", nlohmann::json::object(), 3.0 / 30), doctest::Approx(0.1));
  CHECK_EQ(begins("life", {{"stepsPerSecond", 100}}, 2.0 / 30), doctest::Approx(0.06));
  CHECK_EQ(begins("grayScott", nlohmann::json::object(), 2.0 / 30), 2.0 / 30);
  CHECK_EQ(brushedStroke("life", nlohmann::json::object(), {.value = 0})["value"].get<double>(), 0);
  CHECK_FALSE(brushedStroke("life", nlohmann::json::object(), {}).contains("value"));
}
