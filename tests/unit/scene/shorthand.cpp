// Tests a group that may be given as one word.
#include "scene/load.hpp"
#include "scene/texts/help_page.hpp"
#include "scene/texts/schema_text.hpp"
#include "unit/scene/toy.hpp"

#include <memory>
#include <optional>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using namespace simreel::scene;

namespace {

enum class Weave { plain, twill, satin };

struct Woven final : Parameters {
  bool isWoven = false;
  Weave weave = Weave::twill;
  double density = 1;
  void describe(Fields& fields) override {
    fields.shorthand("cloth", "weave");
    fields.optionalGroup("cloth", isWoven, "Cloth.", [&](Fields& inner) {
      inner.choice("weave", weave, {"plain", "twill", "satin"}, "Weave.");
      inner.number("density", density, {0, 9}, "kg/m^2", "Density.");
    });
  }
};

const Kinds& wovenKinds() {
  static const Kind all[] = {{"woven", "Woven.", [] { return std::make_unique<Woven>(); }}};
  static const Kinds kinds{all};
  return kinds;
}

Woven wovenOf(const std::string& members, const std::vector<Override>& overrides = {}) {
  const std::string text = R"({"version": 1, "objects": {"w": {"woven": {)" + members + "}}}}";
  const Scene scene = parseScene(text, "s.json", overrides, wovenKinds());
  return dynamic_cast<const Woven&>(*scene.objects.at(0).parameters);
}

std::string mistakesOf(const std::string& members) {
  try {
    return wovenOf(members).isWoven ? "none" : "not woven";
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a preset name can replace its group") {
  CHECK(!wovenOf("").isWoven);
  const Woven word = wovenOf(R"("cloth": "satin")");
  CHECK(word.isWoven);
  CHECK(word.weave == Weave::satin);
  CHECK(word.density == 1);
  const Woven group = wovenOf(R"("cloth": {"weave": "plain", "density": 3})");
  CHECK(group.weave == Weave::plain);
  CHECK(group.density == 3);
  CHECK(wovenOf(R"("cloth": "satin")", {parseOverride("objects.w.woven.cloth=plain")}).weave ==
        Weave::plain);
}

TEST_CASE("an unknown word, and a value that is neither word nor group, are refused") {
  test::checkHas(mistakesOf(R"("cloth": "satn")"),
                 "s.json:1:53: error: unknown weave \"satn\"; did you mean \"satin\"?");
  test::checkHas(mistakesOf(R"("cloth": "satn")"),
                 "\n                                                      ^~~~~~");
  test::checkHas(mistakesOf(R"("cloth": ["satin"])"),
                 "s.json:1:53: error: expected an object or a weave, found a list");
  test::checkHas(mistakesOf(R"("cloth": {"density": "satin"})"), "expected a number, found a string");
}

TEST_CASE("schema and help document shorthand words") {
  const auto schema = nlohmann::json::parse(schemaText(wovenKinds().list));
  const auto& cloth = schema["$defs"]["woven"]["properties"]["cloth"];
  CHECK(cloth["description"] == "Cloth. Off unless given.");
  REQUIRE(cloth["anyOf"].size() == 2);
  CHECK(cloth["anyOf"][0]["enum"] == nlohmann::json::array({"plain", "twill", "satin"}));
  CHECK(cloth["anyOf"][1]["properties"]["density"]["maximum"] == 9);
  CHECK(cloth["anyOf"][1]["additionalProperties"] == false);
  test::checkHas(helpText("woven", wovenKinds().list, 100), "Cloth. A word alone is its \"weave\".");
}
