#include "scene/scene_texts.hpp"
#include "unit/scene/toy.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel::scene;
using namespace simreel::scene::toy;

TEST_CASE("the schema says what the reader checks") {
  const std::string text = schemaText(toyKinds().list);
  CHECK(text.back() == '\n');
  const auto schema = nlohmann::json::parse(text);
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(schema["required"] == nlohmann::json::array({"version"}));
  CHECK(schema["additionalProperties"] == false);
  CHECK(schema["properties"].contains("$schema"));
  CHECK(schema["properties"]["version"]["const"] == 1);
  const auto& cloth = schema["$defs"]["cloth"]["properties"];
  CHECK(cloth["stretch"]["minimum"] == 0);
  CHECK(cloth["stretch"]["maximum"] == 1);
  CHECK(cloth["stretch"]["default"].dump() == "0.05");
  CHECK(cloth["stretch"]["description"] == "Stretch. Unit: m/N.");
  CHECK(cloth["fray"]["maximum"] == 3);
  CHECK(cloth["fray"]["description"] == "Fray. Unit: mm.");
  CHECK(!cloth["fray"].contains("default"));
  CHECK(cloth["threads"]["type"] == "integer");
  CHECK(cloth["gust"]["anyOf"][0]["maximum"] == 5);
  const auto& key = cloth["gust"]["anyOf"][1]["properties"]["keys"]["items"];
  CHECK(key["prefixItems"][1]["maximum"] == 5);
  CHECK(cloth["lift"]["default"] == nlohmann::json::array({0, 1, 0}));
  CHECK(cloth["grid"]["items"]["minimum"] == 2);
  CHECK(cloth["passes"]["default"] == "auto");
  CHECK(cloth["shape"]["enum"] == nlohmann::json::array({"round", "flat"}));
  CHECK(cloth["shape"]["default"] == "flat");
  CHECK(cloth["sides"]["items"]["enum"] == nlohmann::json::array({"left", "right"}));
  CHECK(cloth["sides"]["default"] == nlohmann::json::array({"left"}));
  CHECK(cloth["worn"]["additionalProperties"] == false);
  CHECK(cloth["pins"]["maxItems"] == 4);
  CHECK(cloth["pins"]["items"]["properties"]["row"]["maximum"] == 9);
  CHECK(schema["properties"]["objects"]["additionalProperties"]["oneOf"].size() == 2);
  CHECK(schema["$defs"]["material"]["properties"]["roughness"]["default"].dump() == "0.8");
  for (const char* name : {"title", "seed", "numerics", "render", "time", "camera", "sun", "sky", "ground",
                           "lights", "objects", "test", "checks"})
    CHECK_MESSAGE(schema["properties"][name].contains("description"), name);
}

TEST_CASE("help is a table of name, default, range, unit and sentence") {
  const std::string help = helpText("cloth", toyKinds().list);
  const auto line = [&](const std::string& name) {
    const std::size_t begin = help.find("\n  " + name + " ") + 1;
    std::string found = help.substr(begin, help.find('\n', begin) - begin);
    for (std::size_t at; (at = found.find("  ")) != std::string::npos;) found.erase(at, 1);
    return found;
  };
  CHECK(has(help, "cloth: A toy cloth.\n"));
  CHECK(line("stretch") == " stretch 0.05 0..1 m/N Stretch.");
  CHECK(line("gust") == " gust 1 0..5 m/s Gust. May move along keyframes.");
  CHECK(line("slack") == " slack 0.25 >= 0 m Slack.");
  CHECK(line("fray") == " fray off 0..3 mm Fray.");
  CHECK(line("seam.width") == " seam.width 0.1 > 0 m Width.");
  CHECK(line("pins[].row") == " pins[].row 0 0..9 Row.");
  CHECK(line("shape") == " shape \"flat\" round, flat Shape.");
  CHECK(line("passes") == " passes \"auto\" 1..99 or \"auto\" Passes.");
  CHECK(line("worn") == " worn off Wear.");
}

TEST_CASE("every section has help, and a wrong name gets a suggestion") {
  for (const char* name : {"scene", "render", "time", "camera", "sun", "sky", "ground", "lights",
                           "material", "test", "checks", "capsule"})
    CHECK_MESSAGE(has(helpText(name, toyKinds().list), std::string(name) + ": "), name);
  try {
    static_cast<void>(helpText("cloht", toyKinds().list));
    FAIL("no error");
  } catch (const simreel::UserError& error) {
    CHECK(error.code() == simreel::ExitCode::usage);
    CHECK(has(error.what(), "did you mean \"cloth\"?"));
  }
}

TEST_CASE("the list has one line per kind and section") {
  const std::string list = listText(toyKinds().list);
  CHECK(has(list, "  cloth     A toy cloth.\n"));
  CHECK(has(list, "  camera    "));
  CHECK(has(list, "  scene     "));
}
