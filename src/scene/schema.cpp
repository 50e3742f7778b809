// The JSON Schema of scene files, written by the same declarations that read them.
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scene/describe.hpp"

namespace simreel::scene {

namespace {

using Json = nlohmann::ordered_json;

/// A float as the shortest number that reads back the same.
Json shortest(float value) {
  return Json::parse(fmt::format("{}", value));
}
Json shortest(const glm::vec3& v) {
  return Json::array({shortest(v.x), shortest(v.y), shortest(v.z)});
}

/// Fills an object schema's "properties".
class SchemaWriter : public Fields {
 public:
  explicit SchemaWriter(Json& properties) : properties_(properties) {}

  void boolean(const char* name, bool& value, const char* doc) override {
    add(name, {{"type", "boolean"}, {"default", value}}, doc, "");
  }
  void integer(const char* name, int& value, Range range, const char* unit, const char* doc) override {
    Json schema = plain("integer", range);
    schema["default"] = value;
    add(name, schema, doc, unit);
  }
  void number(const char* name, float& value, Range range, const char* unit, const char* doc) override {
    Json schema = plain("number", range);
    schema["default"] = shortest(value);
    add(name, schema, doc, unit);
  }
  void number(const char* name, double& value, Range range, const char* unit, const char* doc) override {
    Json schema = plain("number", range);
    schema["default"] = value;
    add(name, schema, doc, unit);
  }
  void number(const char* name, Animated<float>& value, Range range, const char* unit, const char* doc) override {
    add(name, moving(plain("number", range), shortest(value.at(0))), doc, unit);
  }
  void vector(const char* name, glm::vec3& value, Range range, const char* unit, const char* doc) override {
    Json schema = several(plain("number", range), 3);
    schema["default"] = shortest(value);
    add(name, schema, doc, unit);
  }
  void vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit, const char* doc) override {
    add(name, moving(several(plain("number", range), 3), shortest(value.at(0))), doc, unit);
  }
  void pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) override {
    Json schema = several(plain("integer", range), 2);
    schema["default"] = {value.x, value.y};
    add(name, schema, doc, unit);
  }
  void pairs(const char* name, std::vector<glm::ivec2>& /*value*/, Range range, const char* unit,
             const char* doc) override {
    add(name, {{"type", "array"}, {"items", several(plain("integer", range), 2)}}, doc, unit);
  }
  void text(const char* name, std::string& value, const char* doc) override {
    add(name, {{"type", "string"}, {"default", value}}, doc, "");
  }
  void integerOr(const char* name, std::optional<int>& value, const char* word, Range range, const char* unit,
                 const char* doc) override {
    Json schema = {{"anyOf", Json::array({plain("integer", range), Json{{"const", word}}})}};
    schema["default"] = value ? Json(*value) : Json(word);
    add(name, schema, doc, unit);
  }
  void integers(const char* name, std::vector<int>& value, Range range, const char* unit, const char* doc) override {
    add(name, {{"type", "array"}, {"items", plain("integer", range)}, {"default", value}}, doc, unit);
  }
  void oneOf(const char* name, int& value, const std::vector<const char*>& names, const char* doc) override {
    add(name, {{"enum", names}, {"default", names[static_cast<std::size_t>(value)]}}, doc, "");
  }
  void someOf(const char* name, std::vector<int>& /*value*/, const std::vector<const char*>& names,
              const char* doc) override {
    add(name, {{"type", "array"}, {"items", {{"enum", names}}}}, doc, "");
  }
  void asset(const char* name, std::filesystem::path& /*value*/, const char* doc) override {
    add(name, {{"type", "string"}}, doc, "");
  }
  void group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) override {
    add(name, object(describe), doc, "");
  }
  void optionalGroup(const char* name, bool& /*present*/, const char* doc,
                     const std::function<void(Fields&)>& describe) override {
    add(name, object(describe), doc, "");
  }
  void listOf(const char* name, const char* doc, std::size_t mostItems,
              const std::function<void(std::size_t)>& resize,
              const std::function<void(Fields&, std::size_t)>& describe) override {
    resize(1);
    const Json items = object([&](Fields& fields) { describe(fields, 0); });
    add(name, {{"type", "array"}, {"maxItems", mostItems}, {"items", items}}, doc, "");
  }
  void error(const char* /*name*/, const std::string& /*message*/) override {}
  [[nodiscard]] bool given(const char* /*name*/) const override { return false; }

  static Json object(const std::function<void(Fields&)>& describe) {
    Json schema = {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
    SchemaWriter inner(schema["properties"]);
    describe(inner);
    return schema;
  }

 private:
  static Json plain(const char* type, Range range) {
    Json schema = {{"type", type}};
    if (std::isfinite(range.least)) schema["minimum"] = range.least;
    if (std::isfinite(range.most)) schema["maximum"] = range.most;
    return schema;
  }
  static Json several(const Json& item, int count) {
    return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
  }
  static Json moving(const Json& value, const Json& standard) {
    const Json key = {{"type", "array"},
                      {"prefixItems", Json::array({Json{{"type", "number"}}, value})},
                      {"items", false},
                      {"minItems", 2}};
    const Json keyed = {{"type", "object"},
                        {"additionalProperties", false},
                        {"required", {"keys"}},
                        {"properties",
                         {{"keys", {{"type", "array"}, {"minItems", 1}, {"items", key}}},
                          {"ease", {{"enum", {"linear", "smooth"}}, {"default", "linear"}}}}}};
    return {{"anyOf", Json::array({value, keyed})}, {"default", standard}};
  }
  void add(const char* name, Json schema, const char* doc, const char* unit) {
    schema["description"] = *unit == '\0' ? std::string(doc) : fmt::format("{} Unit: {}.", doc, unit);
    properties_[name] = std::move(schema);
  }

  Json& properties_;
};

}  // namespace

std::string schemaText(std::span<const Kind> kinds) {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "simreel scene"},
                 {"type", "object"},
                 {"additionalProperties", false},
                 {"required", {"version"}}};
  Json& properties = schema["properties"] = Json::object();
  properties["$schema"] = {{"type", "string"}, {"description", "This file, for completion in editors."}};
  properties["version"] = {{"const", sceneVersion}, {"description", "Format of the scene file."}};
  Scene scene;
  SchemaWriter writer(properties);
  describeScene(writer, scene);

  Json object = {{"type", "object"}, {"additionalProperties", false}, {"minProperties", 1}};
  Json& members = object["properties"] = Json::object();
  for (const Kind& kind : kinds) {
    const auto parameters = kind.makeParameters();
    members[kind.name] = SchemaWriter::object([&](Fields& f) { parameters->describe(f); });
    members[kind.name]["description"] = kind.doc;
  }
  members["material"] = SchemaWriter::object([](Fields& f) { Material().describe(f); });
  members["material"]["description"] = "How the surface looks.";
  properties["objects"] = {{"type", "object"},
                           {"description", "What is simulated and drawn, by name: one kind each, and a material."},
                           {"additionalProperties", object}};
  return schema.dump(2) + "\n";
}

}  // namespace simreel::scene
