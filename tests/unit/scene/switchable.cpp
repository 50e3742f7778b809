// Tests a group that may be given as true, and a field that is false, true or a word.
#include "scene/load.hpp"
#include "scene/texts/help_page.hpp"
#include "scene/texts/schema_text.hpp"
#include "unit/scene/toy.hpp"

#include <memory>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using namespace simreel::scene;

namespace {

struct Switched final : Parameters {
  bool isOn = false;
  double size = 2;
  bool touches = false;
  bool byFaces = false;
  void describe(Fields& fields) override {
    fields.switchable("group");
    fields.optionalGroup("group", isOn, "A group.", [&](Fields& inner) {
      inner.number("size", size, {0, 9}, "m", "Size.");
    });
    fields.booleanOr("touches", touches, byFaces, "faces", "How.");
  }
};

const Kinds& switchedKinds() {
  static const Kind all[] = {{"switched", "Switched.", [] { return std::make_unique<Switched>(); }}};
  static const Kinds kinds{all};
  return kinds;
}

Switched switchedOf(const std::string& members, const std::vector<Override>& overrides = {}) {
  const std::string text = R"({"version": 1, "objects": {"s": {"switched": {)" + members + "}}}}";
  const Scene scene = parseScene(text, "s.json", overrides, switchedKinds());
  return dynamic_cast<const Switched&>(*scene.objects.at(0).parameters);
}

std::string switchMistake(const std::string& members) {
  try {
    static_cast<void>(switchedOf(members));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("true means a group with defaults, false means none") {
  CHECK(!switchedOf("").isOn);
  CHECK(switchedOf(R"("group": true)").isOn);
  CHECK(switchedOf(R"("group": true)").size == 2);
  CHECK(!switchedOf(R"("group": false)").isOn);
  CHECK(switchedOf(R"("group": {"size": 3})").size == 3);
  CHECK(switchedOf(R"("group": {"size": 3})", {parseOverride("objects.s.switched.group=true")}).size == 2);
  CHECK(switchMistake(R"("group": 4)").find("error: expected an object or true, found a number") !=
        std::string::npos);
  CHECK(switchMistake(R"("group": {"width": 4})").find("unknown key") != std::string::npos);
}

TEST_CASE("a switchable field may be false, true or a word") {
  CHECK((!switchedOf("").touches && !switchedOf("").byFaces));
  CHECK((switchedOf(R"("touches": true)").touches && !switchedOf(R"("touches": true)").byFaces));
  CHECK((!switchedOf(R"("touches": "faces")").touches && switchedOf(R"("touches": "faces")").byFaces));
  CHECK(!switchedOf(R"("touches": "faces")", {parseOverride("objects.s.switched.touches=false")}).byFaces);
  for (const char* wrong : {R"("true")", R"("face")", "3"})
    CHECK(switchMistake(std::string(R"("touches": )") + wrong)
              .find(R"(expected true, false or "faces", found)") != std::string::npos);
}

TEST_CASE("schema and help document switchable fields") {
  const auto schema = nlohmann::json::parse(schemaText(switchedKinds().list));
  const auto& properties = schema["$defs"]["switched"]["properties"];
  CHECK(properties["touches"]["enum"] == nlohmann::json::array({false, true, "faces"}));
  CHECK(properties["touches"]["default"] == false);
  REQUIRE(properties["group"]["anyOf"].size() == 2);
  CHECK(properties["group"]["anyOf"][0]["type"] == "boolean");
  CHECK(properties["group"]["anyOf"][1]["properties"]["size"]["default"] == 2);
  test::checkHas(helpText("switched", switchedKinds().list, 100), "A group. Or true: all as by default.");
}
