#include "scene/schema.hpp"

#include "scene/default_text.hpp"
#include "scene/value_writer.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

using Json = nlohmann::ordered_json;

std::string sentence(const char* doc, const char* unit) {
  return *unit == '\0' ? std::string(doc) : fmt::format("{} Unit: {}.", doc, unit);
}

Json numberSchema(const char* type, Range range) {
  Json schema = {{"type", type}};
  if (std::isfinite(range.least)) schema["minimum"] = shortest(range.least);
  if (std::isfinite(range.most)) schema["maximum"] = shortest(range.most);
  return schema;
}

Json tuple(const Json& item, int count) {
  return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}

/// The plain value, or keyframes of it.
Json animatedSchema(const Json& plain) {
  const Json key = {
      {"type", "array"},
      {"prefixItems", Json::array({{{"type", "number"}, {"description", "Unit: s."}}, plain})},
      {"items", false},
      {"minItems", 2}};
  const Json keys = {{"type", "array"},
                     {"items", key},
                     {"minItems", 1},
                     {"description", "[time, value], times strictly increasing."}};
  const Json ease = {{"enum", {"linear", "smooth"}}, {"default", "linear"}};
  const Json keyframes = {{"type", "object"},
                          {"properties", {{"keys", keys}, {"ease", ease}}},
                          {"required", Json::array({"keys"})},
                          {"additionalProperties", false}};
  return {{"anyOf", Json::array({plain, keyframes})}};
}

Json described(Json schema, Json standard, const std::string& doc) {
  schema["default"] = std::move(standard);
  schema["description"] = doc;
  return schema;
}

}  // namespace

Json SchemaWriter::object() const {
  return {{"type", "object"}, {"properties", properties_}, {"additionalProperties", false}};
}

void SchemaWriter::boolean(const char* name, bool& value, const char* doc) {
  add(name, described({{"type", "boolean"}}, value, doc));
}

void SchemaWriter::integer(const char* name, int& value, Range range, const char* unit, const char* doc) {
  add(name, described(numberSchema("integer", range), value, sentence(doc, unit)));
}

void SchemaWriter::number(const char* name, float& value, Range range, const char* unit, const char* doc) {
  add(name, described(numberSchema("number", range), shortest(value), sentence(doc, unit)));
}

void SchemaWriter::number(const char* name, double& value, Range range, const char* unit, const char* doc) {
  add(name, described(numberSchema("number", range), shortest(value), sentence(doc, unit)));
}

void SchemaWriter::number(const char* name, Animated<float>& value, Range range, const char* unit,
                          const char* doc) {
  add(name, described(animatedSchema(numberSchema("number", range)), shortest(value), sentence(doc, unit)));
}

void SchemaWriter::optionalNumber(const char* name, std::optional<double>& /*value*/, Range range,
                                  const char* unit, const char* doc) {
  Json schema = numberSchema("number", range);
  schema["description"] = sentence(doc, unit);
  add(name, std::move(schema));
}

void SchemaWriter::vector(const char* name, glm::vec3& value, Range range, const char* unit,
                          const char* doc) {
  add(name, described(tuple(numberSchema("number", range), 3), shortest(value), sentence(doc, unit)));
}

void SchemaWriter::vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit,
                          const char* doc) {
  add(name, described(animatedSchema(tuple(numberSchema("number", range), 3)), shortest(value),
                      sentence(doc, unit)));
}

void SchemaWriter::pair(const char* name, glm::ivec2& value, Range range, const char* unit,
                        const char* doc) {
  add(name, described(tuple(numberSchema("integer", range), 2), shortest(value), sentence(doc, unit)));
}

void SchemaWriter::pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
                         const char* doc) {
  Json standard = Json::array();
  for (const glm::ivec2& item : value) standard.push_back(shortest(item));
  add(name, described({{"type", "array"}, {"items", tuple(numberSchema("integer", range), 2)}}, standard,
                      sentence(doc, unit)));
}

void SchemaWriter::text(const char* name, std::string& value, const char* doc) {
  add(name, described({{"type", "string"}}, value, doc));
}

void SchemaWriter::integerOr(const char* name, std::optional<int>& value, const char* word, Range range,
                             const char* unit, const char* doc) {
  Json schema = {{"anyOf", Json::array({numberSchema("integer", range), {{"const", word}}})}};
  add(name, described(std::move(schema), value ? Json(*value) : Json(word), sentence(doc, unit)));
}

void SchemaWriter::integers(const char* name, std::vector<int>& value, Range range, const char* unit,
                            const char* doc) {
  add(name, described({{"type", "array"}, {"items", numberSchema("integer", range)}}, value,
                      sentence(doc, unit)));
}

void SchemaWriter::oneOf(const char* name, int& value, const std::vector<const char*>& names,
                         const char* doc) {
  Json schema = {{"enum", names}};
  if (value >= 0) schema["default"] = names[static_cast<std::size_t>(value)];
  schema["description"] = doc;
  add(name, std::move(schema));
}

void SchemaWriter::someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
                          const char* doc) {
  Json standard = Json::array();
  for (const int index : value) standard.push_back(names[static_cast<std::size_t>(index)]);
  add(name,
      described({{"type", "array"}, {"items", {{"enum", names}}}, {"uniqueItems", true}}, standard, doc));
}

void SchemaWriter::asset(const char* name, std::filesystem::path& value, const char* doc) {
  add(name, described({{"type", "string"}}, value.string(),
                      fmt::format("{} A file of the scene's folder or the asset folder.", doc)));
}

void SchemaWriter::group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) {
  SchemaWriter inner;
  describe(inner);
  Json schema = inner.object();
  schema["description"] = doc;
  add(name, std::move(schema));
}

void SchemaWriter::optionalGroup(const char* name, bool& /*present*/, const char* doc,
                                 const std::function<void(Fields&)>& describe) {
  group(name, fmt::format("{} Off unless given.", doc).c_str(), describe);
}

void SchemaWriter::leftOut(const char* name, const char* what) {
  Json& schema = properties_[name];
  schema.erase("default");
  schema["description"] = fmt::format("{} Left out: {}.", schema.value("description", ""), what);
}

void SchemaWriter::listOf(const char* name, const char* doc, std::size_t mostItems, std::size_t items,
                          const std::function<void(std::size_t)>& resize,
                          const std::function<void(Fields&, std::size_t)>& describe) {
  Json standard = standardItems(items, resize, describe);
  SchemaWriter inner;
  describe(inner, 0);
  add(name, described({{"type", "array"}, {"items", inner.object()}, {"maxItems", mostItems}},
                      std::move(standard), doc));
}

}  // namespace simreel::scene
