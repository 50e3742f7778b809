// Tests colours as text: "#rrggbb" and the named colours of CSS.
#include "scene/value/color_text.hpp"

#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

scene::Scene withColor(const std::string& color) {
  return scene::parseScene(fmt::format(R"({{"version": 1, "stage": false, "sun": {{"color": {0}}},
                       "objects": {{"a": {{"sphere": {{}}, "material": {{"color": {0}}}}}}}}})",
                                       color),
                           "scene.json", {}, sim::kinds());
}

std::string messageOf(const std::string& color) {
  try {
    static_cast<void>(withColor(color));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("colours: hexadecimal text is sRGB, by the formula of IEC 61966-2-1") {
  const auto linear = [](int byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const glm::vec3 orange = scene::colorOf("#ff8800").value();
  CHECK(orange.x == 1);
  CHECK(orange.y == doctest::Approx(linear(0x88)).epsilon(1e-6));
  CHECK(orange.z == 0);
  CHECK(scene::colorOf("#F80") == scene::colorOf("#ff8800"));
  CHECK(scene::colorOf("#0A0b0C").value().z == doctest::Approx(linear(12)).epsilon(1e-6));
}

TEST_CASE("colours: names are those of CSS, in any case") {
  CHECK(scene::colorNames().size() == 148);
  for (const std::string& name : scene::colorNames()) CHECK_MESSAGE(scene::colorOf(name).has_value(), name);
  CHECK(scene::colorOf("Tomato") == scene::colorOf("#ff6347"));
  CHECK(scene::colorOf("rebeccapurple") == scene::colorOf("#663399"));
  for (const char* wrong : {"", "#", "#12", "#12345", "#1234567", "#12345g", "tomatoe", "ff8800"})
    CHECK_MESSAGE(!scene::colorOf(wrong).has_value(), wrong);
}

TEST_CASE("colours: a scene gives colours as numbers, text or keyframes") {
  const scene::Scene named = withColor("\"tomato\"");
  CHECK(named.objects[0].material.color == scene::colorOf("tomato"));
  CHECK(named.sun.color.at(0) == scene::colorOf("tomato"));
  CHECK(withColor("[0.1, 0.2, 0.3]").objects[0].material.color == glm::vec3(0.1F, 0.2F, 0.3F));
  const scene::Scene moving =
      scene::parseScene(R"({"version": 1, "sun": {"color": {"keys": [[0, "black"], [1, "#fff"]]}}})",
                        "scene.json", {}, sim::kinds());
  CHECK(moving.sun.color.at(1) == glm::vec3(1));
}

TEST_CASE("colours: an error is reported with a suggestion") {
  CHECK(messageOf("\"tomatoe\"").find("unknown colour \"tomatoe\"; did you mean \"tomato\"?") !=
        std::string::npos);
  CHECK(messageOf("\"#12345\"").find("expected \"#rrggbb\" in hexadecimal digits") != std::string::npos);
  CHECK(messageOf("3").find("expected a list of three numbers") != std::string::npos);
}
