#include "scene/framing.hpp"
#include "scene/load.hpp"
#include "sim/color_bar/parameters.hpp"
#include "sim/grid/field_view.hpp"
#include "sim/lenia/parameters.hpp"
#include "sim/world/list.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec2.hpp>

using namespace simreel;  // NOLINT
using simreel::sim::BarTick;
using simreel::sim::barTicks;

namespace {

std::vector<std::string> texts(const std::vector<BarTick>& ticks) {
  std::vector<std::string> all;
  all.reserve(ticks.size());
  for (const BarTick& tick : ticks) all.push_back(tick.text);
  return all;
}

using Texts = std::vector<std::string>;

scene::Scene sceneOf(int version, const std::string& objects, const std::string& more = "") {
  return scene::parseScene(fmt::format(R"({{"version": {}, {}"objects": {{{}}}}})", version, more, objects),
                           "s.json", {}, sim::kinds());
}

/// Returns the left and right end of a field in a picture of 160 x 90 pixels.
glm::dvec2 endsOf(const scene::Scene& scene, const char* name) {
  for (const scene::Object& object : scene.objects)
    if (object.name == name) {
      const auto& lenia = dynamic_cast<const sim::LeniaParameters&>(*object.parameters);
      const sim::FieldView view = sim::fieldView(lenia.display, lenia.size, {160, 90}, 0);
      return {-view.origin.x / view.perPixel.x, (lenia.size.x - view.origin.x) / view.perPixel.x};
    }
  return {};
}

}  // namespace

TEST_CASE("ticks of a colour bar stand at round numbers within the range") {
  CHECK(texts(barTicks(0, 1, 5)) == Texts{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(texts(barTicks(0, 3, 5)) == Texts{"0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"});
  CHECK(texts(barTicks(-0.3, 0.31, 3)) == Texts{"-0.2", "0.0", "0.2"});
  CHECK(texts(barTicks(12, 4800, 4)) == Texts{"1000", "2000", "3000", "4000"});
  CHECK(texts(barTicks(0, 2e6, 4)) == Texts{"0", "5e+05", "1e+06", "1.5e+06", "2e+06"});
}

TEST_CASE("ticks of a colour bar run backwards if the range does") {
  const std::vector<BarTick> ticks = barTicks(10, 0, 5);
  REQUIRE(ticks.size() == 6);
  CHECK(ticks.front().text == "0");
  CHECK(ticks.front().at == doctest::Approx(1));
  CHECK(ticks.back().at == doctest::Approx(0));
}

TEST_CASE("a range without width has one tick") {
  CHECK(texts(barTicks(2, 2, 5)) == Texts{"2"});
}

TEST_CASE("colour bar: since version 2 a field that fills the picture ends left of its bar") {
  const std::string field = R"("f": {"lenia": {"size": [160, 90]}})";
  const std::string wide = R"(, "bar": {"colorBar": {"of": "f"}})";
  CHECK(endsOf(sceneOf(2, field), "f") == glm::dvec2(0, 160));
  CHECK(endsOf(sceneOf(1, field + wide), "f") == glm::dvec2(0, 160));
  const glm::dvec2 ends = endsOf(sceneOf(2, field + wide), "f");
  CHECK(ends.x == doctest::Approx(0).scale(1));
  CHECK(ends.y == doctest::Approx(138));  // 14% of 160 pixels, rounded to 22
  CHECK(endsOf(sceneOf(2, field + R"(, "bar": {"colorBar": {"of": "f", "corner": [0.9, 0.2, 0]}})"), "f") ==
        glm::dvec2(0, 160));
  const std::string part = R"("f": {"lenia": {"size": [160, 90], "display": {"extent": [0.5, 1, 0]}}})";
  CHECK(endsOf(sceneOf(2, part + wide), "f") == glm::dvec2(0, 80));
  const glm::dvec2 above =
      endsOf(sceneOf(2, field + R"(, "bar": {"colorBar": {"of": "f", "horizontal": true}})"), "f");
  CHECK(above.x > 10);
  CHECK(above.y < 150);
}

TEST_CASE("colour bar: since version 2 the automatic camera leaves the strip of the bar free") {
  const std::string balls =
      R"("p": {"particles": {"groups": [{"shape": "cube"}], "method": "none", "look": {"colorBy": "mass"}}})";
  const std::string bar = R"(, "bar": {"colorBar": {"of": "p"}})";
  const auto middle = [&](int version, const std::string& objects) {
    const scene::Scene scene = sceneOf(version, objects, R"("stage": false, )");
    return scene.camera.target.at(0).x;
  };
  CHECK(middle(2, balls) == doctest::Approx(0).scale(1));
  CHECK(middle(1, balls + bar) == doctest::Approx(0).scale(1));
  CHECK(middle(2, balls + bar) > 0.1F);
  CHECK(scene::roomBeside(sceneOf(2, balls + bar, R"("panels": {"a": {"view": "top"}}, )")) ==
        glm::vec2(0));
}
