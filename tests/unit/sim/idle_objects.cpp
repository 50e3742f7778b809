// Tests warnings about keys of objects and materials that change nothing, at their positions.
#include "scene/load.hpp"
#include "sim/world/list.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;  // NOLINT

namespace {

/// Returns the number of warnings that contain `words` and begin at the line and column of `key`.
int remarksAt(const std::string& text, const std::string& key, const std::string& words) {
  const std::string scene = R"({"version": 2, )" + text + "}";
  const auto place = fmt::format("s.json:1:{}: warning: ", scene.find(key) + 1);
  int count = 0;
  for (const std::string& remark : scene::parseScene(scene, "s.json", {}, sim::kinds()).remarks)
    if (remark.starts_with(place) && remark.find(words) != std::string::npos) ++count;
  return count;
}

std::size_t remarks(const std::string& text) {
  return scene::parseScene(R"({"version": 2, )" + text + "}", "s.json", {}, sim::kinds()).remarks.size();
}

}  // namespace

TEST_CASE("idle: the anchor of the only text in view is reported") {
  const auto text = [](const std::string& members, const std::string& more = "") {
    return R"("objects": {"t": {"text": {"text": "word", )" + members + "}}" + more + "}";
  };
  CHECK(remarksAt(text(R"("align": "left")"), "\"align\"", "\"align\" moves nothing") == 1);
  CHECK(remarksAt(text(R"("vertical": "top")"), "\"vertical\"", "\"vertical\" moves nothing") == 1);
  CHECK(remarks(text(R"("align": "left")", R"(, "b": {"sphere": {}})")) == 0);
  CHECK(remarks(text(R"("align": "left", "screen": {})")) == 0);
  CHECK(remarks(R"("camera": {"target": [0, 0, 0]}, )" + text(R"("align": "left")")) == 0);
  CHECK(remarks(R"("objects": {"t": {"text": {"text": "two\nlines", "align": "left"}}})") == 0);
  CHECK(remarks(R"("objects": {"t": {"text": {"text": "{frame}", "align": "left"}}})") == 0);
}

TEST_CASE("idle: doubleSided of closed solids that are seen from outside is reported") {
  for (const char* solid : {"sphere", "capsule", "box", "cylinder", "cone", "torus"}) {
    CAPTURE(solid);
    const auto scene = [&](const std::string& more) {
      return fmt::format(R"("objects": {{"b": {{"{}": {{}}, "material": {{"doubleSided": true{}}}}}}})",
                         solid, more);
    };
    CHECK(remarksAt(scene(""), "\"doubleSided\"", "here \"doubleSided\" does nothing") == 1);
    CHECK(remarks(scene(R"(, "alpha": "blend", "opacity": 0.5)")) == 0);
    const std::string inside = R"("camera": {"position": [0, 0, 0], "target": [0, 0, 1]}, )";
    CHECK(remarks(inside + scene("")) == 0);
    const std::string outside = R"("camera": {"position": [0, 0, 9], "target": [0, 0, 0]}, )";
    CHECK(remarks(outside + scene("")) == 1);
  }
  CHECK(remarks(R"("objects": {"d": {"disc": {}, "material": {"doubleSided": true}}})") == 0);
}

TEST_CASE("idle: colorBy of a cloth reports the colour, texture and skin that it replaces") {
  const auto cloth = [](const std::string& members, const std::string& material) {
    return R"("objects": {"f": {"grayScott": {"display": {"layer": "none"}}}, "c": {"cloth": {)" + members +
           R"(}, "material": {)" + material + "}}}";
  };
  const std::string by = R"("colorBy": "speed")";
  CHECK(remarksAt(cloth(by, R"("texture": "textures/wood.png")"), "\"texture\"", "its \"colorBy\"") == 1);
  CHECK(remarksAt(cloth(by, R"("skin": {"field": "f"})"), "\"skin\"", "\"skin\" of the material") == 1);
  CHECK(remarksAt(cloth(by, R"("skin": {"field": "f"}, "color": [1, 0, 0])"), "\"color\"",
                  "its \"colorBy\"") == 1);
  CHECK(remarks(cloth("", R"("texture": "textures/wood.png")")) == 0);
}
