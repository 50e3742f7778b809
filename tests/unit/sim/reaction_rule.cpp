// Tests refused equations of rules in a scene, and the marked position of the error.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/parameters.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/reaction/presets.hpp"
#include "sim/world/list.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

std::string refusal(const std::string& members) {
  const std::string text = "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}";
  try {
    static_cast<void>(scene::parseScene(text, "s.json", {}, sim::kinds()));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

/// Returns the error of a rule that has one species u with this rate.
std::string rate(const std::string& expression, const std::string& more = "") {
  return refusal(more + R"X("species": {"u": {"rate": ")X" + expression + "\"}}");
}

bool shows(const std::string& refused, const std::string& message, const std::string& marked) {
  // The caret line has as many carets as the marked text, which is directly above them.
  const std::size_t caret = refused.rfind('\n') + 1;
  const std::size_t line = refused.rfind('\n', caret - 2) + 1;
  const std::size_t at = refused.find_first_of('^', caret) - caret;
  const std::size_t length = refused.size() - caret - at;
  const bool right =
      refused.find(message) != std::string::npos && refused.substr(line + at, length) == marked;
  if (!right) MESSAGE(refused);
  return right;
}

}  // namespace

TEST_CASE("reaction: an error in a rate is marked inside its text") {
  CHECK(shows(rate("1 - v"), "unknown name \"v\"", "v"));
  CHECK(shows(rate("u - feeed*u", R"X("parameters": {"feed": 1}, )X"), "did you mean \"feed\"?", "feeed"));
  CHECK(shows(rate("u +* 2"), "expected a number", "*"));
  CHECK(shows(rate("sin(u, u)"), "takes 1 argument, found 2", "sin"));
  CHECK(shows(rate("u/(2 - 2)"), "division by zero", "u/(2 - 2"));
  CHECK(shows(rate("0^-1"), "division by zero", "-1"));
  CHECK(shows(rate("a", R"X("lets": {"a": "1 + b", "b": "2*c", "c": "a - u"}, )X"),
              "the definitions of \"lets\" form a circle: a needs b needs c needs a", "a"));
  CHECK(shows(rate("a", R"X("lets": {"a": "1 + a"}, )X"),
              "the definitions of \"lets\" form a circle: a needs a", "a"));
  CHECK(shows(rate("u", R"X("parameters": {"unused": 2}, )X"), "no expression has the parameter \"unused\"",
              "2"));
  CHECK(shows(refusal(R"X("species": {"u": {"rate": "u", "start": "0.5*u"}})X"),
              "\"start\" can use only parameters", "u"));
  CHECK(shows(refusal(R"X("species": {"u": {"start": "noise(1)"}})X"), "cannot use neighbours or noise",
              "noise(1)"));
  CHECK(shows(refusal(R"X("show": "u + w", "species": {"u": {}})X"), "unknown name \"w\"", "w"));
  CHECK(rate("u").find("none") == 0);
}

TEST_CASE("reaction: a position in a text is found behind escape sequences, too") {
  CHECK(shows(rate(R"X(u\t\u002b w)X"), "unknown name \"w\"", "w"));
}

TEST_CASE("reaction: integer powers of negative numbers have the right sign for any exponent") {
  const auto scene = scene::parseScene(
      R"X({"version": 1, "objects": {"r": {"reaction": {"size": [4, 4], "species": {"u": {"start": "(x - 2)^21"},
         "v": {"start": "(x - 2)^-18"}, "w": {"start": "(-2)^20"}}}}}})X",
      "s.json", {}, sim::kinds());
  const sim::ReactionPlan plan(
      dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters), "r", 1, 0.1);
  const sim::RulePlanes first = plan.firstField().stage;
  CHECK(first[0][0] == doctest::Approx(std::pow(-1.5, 21)));
  CHECK(first[1][0] == doctest::Approx(std::pow(1.5, -18)));
  CHECK(first[2][0] == 1048576);
}

TEST_CASE("reaction: errors of a rule as a whole are reported") {
  CHECK(refusal("").find("there are no equations: give a \"preset\" or \"species\"") != std::string::npos);
  CHECK(refusal(R"X("species": {"2u": {}})X").find("\"2u\" cannot be a name in expressions") !=
        std::string::npos);
  CHECK(refusal(R"X("species": {"sin": {}})X").find("\"sin\" cannot be a name") != std::string::npos);
  CHECK(refusal(R"X("parameters": {"u": 1}, "species": {"u": {}})X")
            .find("is a name in \"species\" already") != std::string::npos);
  CHECK(refusal(R"X("preset": "barkely")X").find("did you mean \"barkley\"?") != std::string::npos);
  CHECK(
      refusal(R"X("preset": "barkley", "parameters": {"epsilom": 1})X").find("did you mean \"epsilon\"?") !=
      std::string::npos);
  std::string nine;
  for (int i = 0; i < 9; ++i) nine += fmt::format("{}\"s{}\": {{}}", i > 0 ? ", " : "", i);
  CHECK(refusal("\"species\": {" + nine + "}").find("at most 8 species, found 9") != std::string::npos);
  std::string dear = "u";
  for (int i = 0; i < 100; ++i) dear += fmt::format("+tanh(u+{})", i);
  CHECK(rate(dear).find("the rates need") != std::string::npos);
  // Each let doubles the previous one. Expanded, this would be 2^30 operations. As a graph, it is 30.
  std::string lets = "\"l0\": \"u\"";
  for (int i = 1; i < 31; ++i) lets += fmt::format(", \"l{0}\": \"l{1}*l{1} + l{1}\"", i, i - 1);
  CHECK(rate("l30", "\"lets\": {" + lets + "}, ") == "none");
}

TEST_CASE(
    "reaction: fields of other objects must exist, be used alone, and are not read before the first "
    "frame") {
  const auto with = [](const std::string& parameter, const std::string& more = "") {
    return R"X("a": {"reaction": {"size": [8, 8], )X" + more + R"X("parameters": {"f": )X" + parameter +
           R"X(}, "species": {"u": {"rate": "f"}}}}, "smoke": {"fluid": {"size": [16, 8]}}, "ball": {"sphere": {}})X";
  };
  const auto refused = [](const std::string& objects) -> std::string {
    try {
      static_cast<void>(
          scene::parseScene(R"({"version": 1, "objects": {)" + objects + "}}", "s.json", {}, sim::kinds()));
      return "none";
    } catch (const UserError& error) {
      return error.what();
    }
  };
  CHECK(refused(with(R"({"field": "smoke.temperature"})")) == "none");
  CHECK(refused(with(R"({"field": "smoke"})")) == "none");
  CHECK(refused(with(R"({"field": "a.u"})")) == "none");
  const std::string unknown = refused(with(R"({"field": "smoke.temprature"})"));
  CHECK(shows(unknown,
              "object \"smoke\" has no field \"smoke.temprature\"; did you mean \"smoke.temperature\"?",
              "\"smoke.temprature\""));
  CHECK(
      refused(with(R"({"field": "smok"})")).find("no object is named \"smok\"; did you mean \"smoke\"?") !=
      std::string::npos);
  CHECK(refused(with(R"({"field": "ball"})")).find("object \"ball\" is a sphere, not a field") !=
        std::string::npos);
  CHECK(refused(with(R"({"field": "smoke", "value": 2})")).find("leave out \"value\"") !=
        std::string::npos);
  CHECK(refused(with(R"({"field": "smoke", "down": 2})")).find("leave out \"down\"") != std::string::npos);
  CHECK(refused(with(R"({"field": "smoke"})", R"("presteps": 3, )")).find("leave out \"presteps\"") !=
        std::string::npos);
  // A rule on a mesh may read fields of grids, and of the same mesh at any position. A rule on a grid
  // cannot read fields of meshes.
  const auto onMesh = [](const char* name, const char* mesh, const char* field) {
    return fmt::format(
        R"X("{}": {{"reaction": {{"mesh": {}, "parameters": {{"f": {{"field": "{}"}}}}, "species": {{"u": {{"rate": "f"}}}}}}}}, )X",
        name, mesh, field);
  };
  const std::string other =
      onMesh("m", R"({"shape": "torus", "position": [3, 0, 0], "scale": 2})", "smoke");
  CHECK(refused(onMesh("n", R"({"shape": "torus"})", "m") + other + with(R"({"field": "smoke"})")) ==
        "none");
  CHECK(refused(onMesh("n", R"({"shape": "torus"})", "m.u") + other + with(R"({"field": "smoke"})")) ==
        "none");
  CHECK(refused(onMesh("n", R"({"shape": "torus", "tube": 0.3})", "m") + other +
                with(R"({"field": "smoke"})"))
            .find("object \"m\" is a reaction on a mesh, whose field only a reaction on the same mesh can "
                  "use") != std::string::npos);
  CHECK(refused(other + with(R"({"field": "m"})"))
            .find("whose field only a reaction on the same mesh can use") != std::string::npos);
  CHECK(refused(onMesh("n", R"({"shape": "torus"})", "m.v") + other + with(R"({"field": "smoke"})"))
            .find("object \"m\" has no field \"m.v\"; did you mean") != std::string::npos);
  // A rule in a volume may read fields of grids, whose values are equal in all layers, and of volumes with
  // the same proportions.
  const auto inVolume = [](const char* name, const char* size, const char* field) {
    return fmt::format(
        R"X("{}": {{"reaction": {{"size": {}, "parameters": {{"f": {{"field": "{}"}}}}, "species": {{"u": {{"rate": "f"}}}}}}}}, )X",
        name, size, field);
  };
  const std::string volume = inVolume("v", R"([12, 8], "depth": 16)", "smoke");
  CHECK(refused(inVolume("w", R"([9, 6], "depth": 12)", "v.u") + volume + with(R"({"field": "smoke"})")) ==
        "none");
  CHECK(refused(inVolume("w", R"([9, 6], "depth": 11)", "v") + volume + with(R"({"field": "smoke"})"))
            .find("object \"v\" is a reaction in a volume of 12x8x16 cells, whose field only a volume of "
                  "the same proportions can use") != std::string::npos);
  CHECK(refused(volume + with(R"({"field": "v"})")).find("only a volume of the same proportions can use") !=
        std::string::npos);
  CHECK(shows(rate("u", R"X("parameters": {"f": {"field": "r"}}, "lets": {"l": "f"}, )X") == "none"
                  ? refusal(R"X("parameters": {"f": {"field": "r"}}, "species": {"u": {"start": "f"}})X")
                  : "",
              "no other object has a field yet when \"start\" is made", "f"));
}

TEST_CASE("reaction: a preset is what its page shows, and a scene can change parts of it") {
  const auto read = [](const std::string& members) {
    const auto scene =
        scene::parseScene("{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}",
                          "s.json", {}, sim::kinds());
    return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
  };
  for (const sim::ReactionPreset& preset : sim::reactionPresets()) {
    const auto p = read(fmt::format("\"preset\": \"{}\"", preset.name));
    CHECK(p.dt == preset.dt);
    CHECK(p.species.size() == preset.species.size());
    const std::string text = sim::compileRule(p.ruleText()).text;
    CHECK(sim::reactionPresetsText().find(text.substr(0, text.find('\n'))) != std::string::npos);
  }
  const auto p =
      read(R"X("preset": "barkley", "parameters": {"a": 0.9, "b": {"keys": [[0, 0.01], [1, 0.05]]}},
                         "species": {"v": {"diffusion": 0.5}, "w": {"rate": "u - w"}}, "dt": 0.002)X");
  CHECK(p.species.size() == 3);
  CHECK(p.species[0].rate == "u*(1 - u)*(u - (v + b)/a)/epsilon");
  CHECK(p.species[1].diffusion.at(0) == 0.5F);
  CHECK(p.species[1].rate == "u - v");
  CHECK(p.parameters[0].value.at(0) == 0.9F);
  CHECK(p.parameters[1].value.at(0.5) == doctest::Approx(0.03));
  CHECK(p.parameters[2].value.at(0) == 0.02F);
  CHECK(p.dt == 0.002);
}
