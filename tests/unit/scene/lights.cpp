// Tests the section "lights": named groups of fields, their limits, keyframes and overrides.
#include "scene/texts/help_page.hpp"
#include "scene/texts/schema_text.hpp"
#include "unit/scene/toy.hpp"

#include <doctest/doctest.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;

namespace {

std::string withLights(const std::string& lights) {
  return R"({"version": 1, "lights": {)" + lights + "}}";
}

/// Returns `count` lights. The first `shadowed` of them have shadows.
std::string several(int count, int shadowed) {
  std::string lights;
  for (int i = 0; i < count; ++i)
    lights += std::string(i > 0 ? ", " : "") + "\"l" + std::to_string(i) + "\": {" +
              (i < shadowed ? "" : "\"shadow\": false") + "}";
  return withLights(lights);
}

}  // namespace

TEST_CASE("lights: all fields are read, in file order") {
  const Scene scene =
      parse(withLights(R"("zeta": {"type": "point", "position": [1, 2, 3], "color": [0.5, 1, 2],
    "intensity": {"keys": [[0, 10], [2, 30]], "ease": "linear"}, "radius": 0.25, "glow": 0.5, "shadow": false,
    "shadowSize": 96, "shadowSoftness": 3, "flicker": {"amount": 0.7, "rate": 9, "sway": 0.02}}, "alpha": {})"));
  REQUIRE(scene.lights.size() == 2);
  const Light& zeta = scene.lights[0];
  CHECK(zeta.name == "zeta");
  CHECK(zeta.type == Light::Type::point);
  CHECK(zeta.position.at(0) == glm::vec3(1, 2, 3));
  CHECK(zeta.color.at(0) == glm::vec3(0.5F, 1, 2));
  CHECK(zeta.intensity.at(1) == 20.0F);
  CHECK(zeta.radius.at(0) == 0.25F);
  CHECK(zeta.glow.at(0) == 0.5F);
  CHECK(!zeta.shadow);
  CHECK(zeta.shadowSize == 96);
  CHECK(zeta.shadowSoftness == 3.0F);
  REQUIRE(zeta.flicker);
  CHECK(zeta.flicker->amount.at(0) == 0.7F);
  CHECK(zeta.flicker->rate == 9.0F);
  CHECK(zeta.flicker->sway.at(0) == 0.02F);
  const Light& alpha = scene.lights[1];
  CHECK(alpha.name == "alpha");
  CHECK(!alpha.flicker);
  CHECK(alpha.shadow);
  CHECK(alpha.intensity.at(0) == 20.0F);
  CHECK(parse(R"({"version": 1})").lights.empty());
}

TEST_CASE("lights: animatable fields accept keyframes") {
  for (const char* field : {"intensity", "radius", "glow"}) {
    const Scene scene =
        parse(withLights("\"a\": {\"" + std::string(field) + R"(": {"keys": [[0, 1], [4, 3]]}})"));
    const Light& light = scene.lights.at(0);
    const auto& value = *field == 'i' ? light.intensity : *field == 'r' ? light.radius : light.glow;
    CHECK(value.at(1) == 1.5F);
  }
  const Scene scene = parse(withLights(R"("a": {"position": {"keys": [[0, [0, 0, 0]], [2, [4, 2, 0]]]},
    "color": {"keys": [[0, [1, 0, 0]], [1, [0, 0, 1]]], "ease": "smooth"},
    "flicker": {"amount": {"keys": [[0, 0], [1, 1]]}, "sway": {"keys": [[0, 0], [1, 0.5]]}}})"));
  CHECK(scene.lights[0].position.at(1) == glm::vec3(2, 1, 0));
  CHECK(scene.lights[0].color.at(0.5) == glm::vec3(0.5F, 0, 0.5F));
  REQUIRE(scene.lights[0].flicker);
  CHECK(scene.lights[0].flicker->amount.at(0.25) == 0.25F);
  CHECK(scene.lights[0].flicker->sway.at(0.5) == 0.25F);
  const Light by = parse(R"({"version": 1, "objects": {"c": {"cloth": {}}}, "lights": {"a": {"follow": {
    "object": "c", "height": 3, "side": -2, "progress": {"keys": [[0, 0], [2, 1]]}}}}})")
                       .lights.at(0);
  REQUIRE(by.follow);
  CHECK(by.follow->object == "c");
  CHECK(by.follow->progress.at(0.5) == 0.25F);
  CHECK(by.follow->height == 3);
  CHECK(by.follow->side == -2);
}

TEST_CASE("lights: errors are reported at their place with a suggestion") {
  const auto says = [](const std::string& lights, const std::string& what) {
    return has(mistakes(withLights(lights)), what);
  };
  CHECK(says(R"("a": {"intenisty": 3})", "unknown key \"intenisty\"; did you mean \"intensity\"?"));
  CHECK(says(R"("a": {"type": "pont"})", "unknown type \"pont\"; did you mean \"point\"?"));
  CHECK(says(R"("a": {"flicker": {"speed": 3}})", "unknown key \"speed\""));
  CHECK(says(R"("a": {"radius": 0})", "\"radius\" must be between 0.001 and 1000 m, found 0"));
  CHECK(says(R"("a": {"intensity": -1})", "\"intensity\" must be at least 0, found -1"));
  CHECK(says(R"("a": {"flicker": {"amount": 1.5}})", "\"amount\" must be between 0 and 1, found 1.5"));
  CHECK(says(R"("a": {"follow": {"object": "c"}, "position": [0, 1, 0]})",
             "\"follow\" sets the place of the light; leave out \"position\""));
  CHECK(says(R"("a": {"follow": {"progress": 1.5}})", "\"progress\" must be between 0 and 1, found 1.5"));
  CHECK(says(R"("a b": {})", "light name \"a b\" must be 1 to 64 letters, digits, '-' or '_'"));
  CHECK(says(R"("a": 3)", "expected an object, found a number"));
  CHECK(has(mistakes(R"({"version": 1, "lights": [{}]})"), "expected lamps by name"));
  CHECK(has(mistakes(R"({"version": 1, "light": {}})"), "did you mean \"lights\"?"));
}

TEST_CASE("lights: at most 256 lights are allowed, eight of them with shadows") {
  CHECK(parse(several(256, 8)).lights.size() == 256);
  CHECK(has(mistakes(several(257, 0)), "a scene has at most 256 lights, found 257"));
  CHECK(has(mistakes(several(16, 9)),
            "9 lights cast shadows, and at most 8 may; give the others \"shadow\": false"));
  CHECK(has(mistakes(several(9, 9)), "s.json:1:26: error: 9 lights"));
}

TEST_CASE("lights: overrides change and complete lights but do not create them") {
  const std::string text = withLights(R"("torch": {"intensity": 5})");
  CHECK(parse(text, {"lights.torch.intensity=7"}).lights.at(0).intensity.at(0) == 7.0F);
  CHECK(parse(text, {"lights.torch.flicker.rate=2"}).lights.at(0).flicker);
  CHECK(parse(text, {"lights.lamp={\"radius\": 2}"}).lights.at(1).radius.at(0) == 2.0F);
  CHECK(parse(R"({"version": 1})", {"lights.a={}"}).lights.at(0).name == "a");
  CHECK(mistakes(text, {"lights.trch.intensity=7"}) ==
        "-D lights.trch.intensity=7: error: no light is named \"trch\"; did you mean \"torch\"? "
        "(-D lights.trch={...} adds one)\n"
        "  lights.trch.intensity=7\n"
        "         ^~~~");
  CHECK(has(mistakes(text, {"lights.torch.intenisty=7"}), "did you mean \"intensity\"?"));
}

TEST_CASE("lights: schema and help are generated from the same declaration") {
  const std::string help = helpText("lights", toyKinds().list, 100);
  for (const char* name : {"position", "intensity", "radius", "flicker.rate", "shadowSize"})
    CHECK_MESSAGE(has(help, std::string("\n  ") + name + " "), name);
  CHECK(has(schemaText(toyKinds().list), "\"maxProperties\": 256"));
  CHECK(has(helpText("scene", toyKinds().list, 100), "up to 256"));
}
