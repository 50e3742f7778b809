#include "scene/value/choices.hpp"

#include "scene/value/schema.hpp"

namespace simreel::scene {

std::vector<std::string> choicesOf(const Kind& kind, std::string_view name) {
  SchemaWriter schema;
  kind.makeParameters()->describe(schema);
  const auto object = schema.object();
  const auto& properties = object["properties"];
  const auto field = properties.find(name);
  if (field == properties.end() || !field->contains("enum")) return {};
  return (*field)["enum"].get<std::vector<std::string>>();
}

}  // namespace simreel::scene
