// What simreel says about scenes: the schema, the help tables and the list.
#include "scene/scene_texts.hpp"

#include "base/error.hpp"
#include "scene/json/words.hpp"
#include "scene/scene.hpp"
#include "scene/sections.hpp"
#include "scene/value/help.hpp"
#include "scene/value/schema.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

using Json = nlohmann::ordered_json;

Json objectsSchema(std::span<const Kind> kinds) {
  Json properties = Json::object();
  Json oneKind = Json::array();
  for (const Kind& kind : kinds) {
    properties[kind.name] = {{"$ref", fmt::format("#/$defs/{}", kind.name)}};
    oneKind.push_back({{"required", Json::array({kind.name})}});
  }
  properties["material"] = {{"$ref", "#/$defs/material"}};
  Json object = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!oneKind.empty()) object["oneOf"] = oneKind;
  return {{"type", "object"},
          {"propertyNames", {{"pattern", plainNamePattern}}},
          {"maxProperties", maxObjects},
          {"additionalProperties", object},
          {"description", "What is simulated and drawn: one kind each, and perhaps a material."}};
}

std::string sceneHelp() {
  Scene scene;
  HelpWriter table(false);
  table.add("version", "", std::to_string(sceneVersion), "", "Version of the scene format; must be given.");
  describeScene(table, scene);
  table.add("objects", "{}", fmt::format("up to {}", maxObjects), "",
            "What is simulated and drawn, each {kind, material} by name.");
  describeTests(table, scene, std::nullopt);
  return "scene: a scene file.\n\n" + table.table() +
         "\nrender, time, camera, sun, sky, ground, lights, material, test and checks have their own help: "
         "simreel "
         "list NAME.\n"
         "Keyframes of a value that may move: {\"keys\": [[time, value], ...], \"ease\": \"linear\" or "
         "\"smooth\"}.\n";
}

/// What checks may ask for.
std::string quantitiesText(std::span<const Quantity> quantities) {
  if (quantities.empty()) return "";
  std::size_t name = 0, unit = 0;
  for (const Quantity& q : quantities) {
    name = std::max(name, std::string_view(q.name).size());
    unit = std::max(unit, std::string_view(q.unit).size());
  }
  std::string out = "\nMeasured, for \"what\" of \"checks\":\n\n";
  for (const Quantity& q : quantities)
    out += fmt::format("  {:<{}}  {:<{}}{}{}\n", q.name, name, q.unit, unit, unit > 0 ? "  " : "", q.doc);
  return out;
}

}  // namespace

std::string schemaText(std::span<const Kind> kinds) {
  Scene scene;
  SchemaWriter writer;
  writer.add("$schema", {{"type", "string"}});
  writer.add("version", {{"const", sceneVersion}, {"description", "Version of the scene format."}});
  describeScene(writer, scene);
  writer.add("objects", objectsSchema(kinds));
  describeTests(writer, scene, std::nullopt);

  Json definitions = Json::object();
  for (const Kind& kind : kinds) {
    SchemaWriter inner;
    kind.makeParameters()->describe(inner);
    Json& schema = definitions[kind.name] = inner.object();
    schema["description"] = kind.doc;
  }
  SchemaWriter material;
  Material().describe(material);
  definitions["material"] = material.object();

  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "simreel scene"}};
  schema.update(writer.object());
  schema["required"] = Json::array({"version"});
  schema["$defs"] = definitions;
  return schema.dump(2) + "\n";
}

std::string helpText(std::string_view name, std::span<const Kind> kinds) {
  if (name == "scene") return sceneHelp();
  std::vector<std::string> known = {"scene"};
  for (const Section& section : sections()) {
    known.emplace_back(section.name);
    if (name != section.name) continue;
    HelpWriter table(true);
    section.describe(table);
    return fmt::format("{}: {}\n\n{}", section.name, section.doc, table.table());
  }
  for (const Kind& kind : kinds) {
    known.emplace_back(kind.name);
    if (name != kind.name) continue;
    HelpWriter table(true);
    const auto parameters = kind.makeParameters();
    parameters->describe(table);
    return fmt::format(
        "{}: {}\nIn a scene: \"objects\": {{\"name\": {{\"{}\": {{...}}, \"material\": "
        "{{...}}}}}}\n\n{}{}{}",
        kind.name, kind.doc, kind.name, table.table(), quantitiesText(parameters->quantities()),
        kind.appendix ? "\n" + kind.appendix() : "");
  }
  fail(ExitCode::usage, "no simulation or scene section is named {}; {}", inQuotes(printable(name)),
       suggestion(name, known));
}

std::string listText(std::span<const Kind> kinds) {
  std::size_t width = 8;
  for (const Kind& kind : kinds) width = std::max(width, std::string_view(kind.name).size());
  std::string out = "Simulations:\n";
  for (const Kind& kind : kinds) out += fmt::format("  {:<{}}  {}\n", kind.name, width, kind.doc);
  out += fmt::format("\nScene sections:\n  {:<{}}  {}\n", "scene", width, "The scene file as a whole.");
  for (const Section& section : sections())
    out += fmt::format("  {:<{}}  {}\n", section.name, width, section.doc);
  return out;
}

}  // namespace simreel::scene
