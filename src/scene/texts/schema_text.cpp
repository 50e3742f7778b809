#include "scene/texts/schema_text.hpp"

#include "scene/json/words.hpp"
#include "scene/scene.hpp"
#include "scene/sections.hpp"
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

}  // namespace

std::string schemaText(std::span<const Kind> kinds) {
  Scene scene;
  SchemaWriter writer;
  writer.add("$schema", {{"type", "string"}});
  writer.add("version", {{"type", "integer"},
                         {"minimum", oldestSceneVersion},
                         {"maximum", sceneVersion},
                         {"description", "Version of the scene format."}});
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

}  // namespace simreel::scene
