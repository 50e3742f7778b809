#include "scene/texts/help_page.hpp"
#include "scene/texts/schema_text.hpp"
#include "unit/scene/toy.hpp"

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel::scene;
using namespace simreel::scene::toy;

TEST_CASE("the schema states what the reader checks") {
  const std::string text = schemaText(toyKinds().list);
  CHECK(text.back() == '\n');
  const auto schema = nlohmann::json::parse(text);
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(schema["required"] == nlohmann::json::array({"version"}));
  CHECK(schema["additionalProperties"] == false);
  CHECK(schema["properties"].contains("$schema"));
  CHECK(schema["properties"]["version"]["minimum"] == 1);
  CHECK(schema["properties"]["version"]["maximum"] == 2);
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
  CHECK(schema["$defs"]["material"]["properties"]["metallic"]["default"].dump() == "0");
  for (const char* name : {"title", "seed", "numerics", "render", "time", "camera", "stage", "sun", "sky",
                           "haze", "ground", "lights", "objects", "test", "checks"})
    CHECK_MESSAGE(schema["properties"][name].contains("description"), name);
}

TEST_CASE("help shows description, default, range and unit of each parameter") {
  const HelpPage page = helpPage("cloth", toyKinds().list);
  const auto line = [&](const std::string& name) {
    const auto rows = page.rowsAt(name);
    return rows.empty() ? "no such row" : rows.front().doc + " [" + rows.front().facts() + "]";
  };
  CHECK(has(helpText("cloth", toyKinds().list, 100), "cloth: A toy cloth.\n"));
  CHECK(line("stretch") == "Stretch. [default 0.05; 0..1; m/N]");
  CHECK(line("gust") == "Gust. May move along keyframes. [default 1; 0..5; m/s]");
  CHECK(line("slack") == "Slack. [default 0.25; >= 0; m]");
  CHECK(line("fray") == "Fray. [default off; 0..3; mm]");
  CHECK(line("seam.width") == "Width. [default 0.1; > 0; m]");
  CHECK(line("pins[].row") == "Row. [default 0; 0..9]");
  CHECK(line("pins.row") == line("pins[].row"));
  CHECK(line("shape") == "Shape. [default \"flat\"; round, flat]");
  CHECK(line("passes") == "Passes. [default \"auto\"; 1..99 or \"auto\"]");
  CHECK(line("worn") == "Wear. [default off]");
  CHECK(page.rowsAt("seam").size() > 1);
}

TEST_CASE("help fits the terminal's width without losing words") {
  const auto words = [](const std::string& text) {
    std::istringstream in(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
  };
  for (const char* name : {"scene", "cloth", "camera"}) {
    const std::string narrow = helpText(name, toyKinds().list, 60);
    std::istringstream lines(narrow);
    for (std::string one; std::getline(lines, one);)
      CHECK_MESSAGE((one.size() <= 60 || one.find(' ', one.find_first_not_of(' ')) == std::string::npos ||
                     has(one, "In a scene")),
                    one);
    CHECK(words(narrow) == words(helpText(name, toyKinds().list, 200)));
  }
}

TEST_CASE("every section has help, and a misspelt section gets a suggestion") {
  for (const char* name : {"scene", "render", "time", "camera", "stage", "sun", "sky", "haze", "ground",
                           "lights", "material", "test", "checks", "capsule"})
    CHECK_MESSAGE(has(helpText(name, toyKinds().list, 100), std::string(name) + ": "), name);
  try {
    static_cast<void>(helpText("cloht", toyKinds().list, 100));
    FAIL("no error");
  } catch (const simreel::UserError& error) {
    CHECK(error.code() == simreel::ExitCode::usage);
    CHECK(has(error.what(), "did you mean \"cloth\"?"));
  }
}

TEST_CASE("the section list has one entry for each kind and section") {
  const std::string list = listText(toyKinds().list, 100);
  CHECK(has(list, "  cloth      A toy cloth.\n"));
  CHECK(has(list, "  camera    "));
  CHECK(has(list, "  scene     "));
}
