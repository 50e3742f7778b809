#include "scene/value/schema.hpp"

#include "scene/json/words.hpp"
#include "scene/value/value_writer.hpp"

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
  if (std::isfinite(range.min)) schema["minimum"] = shortest(range.min);
  if (std::isfinite(range.max)) schema["maximum"] = shortest(range.max);
  return schema;
}

Json tuple(const Json& item, int count) {
  return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}

/// Returns the schema of a value that is plain or has keyframes. `plain`: schema of the plain value.
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
  const Json ease = {{"enum", easeWords}, {"default", easeWords[0]}};
  const Json keyframes = {{"type", "object"},
                          {"properties", {{"keys", keys}, {"ease", ease}}},
                          {"required", Json::array({"keys"})},
                          {"additionalProperties", false}};
  return {{"anyOf", Json::array({plain, keyframes})}};
}

constexpr const char* colorText = "\"#rrggbb\" (sRGB) or the name of a CSS colour.";

/// Returns the JSON Schema of each type of member.
class Types {
 public:
  explicit Types(const Spec& spec) : spec_(spec) {}

  Json operator()(const bool*) const { return {{"type", "boolean"}}; }
  Json operator()(const int*) const {
    return spec_.words.empty() ? numberSchema("integer", spec_.range) : words();
  }
  Json operator()(const float*) const { return numberSchema("number", spec_.range); }
  Json operator()(const double*) const { return numberSchema("number", spec_.range); }
  Json operator()(const std::string*) const { return {{"type", "string"}}; }
  Json operator()(const std::filesystem::path*) const { return {{"type", "string"}}; }
  Json operator()(const glm::vec3*) const {
    Json numbers = tuple(numberSchema("number", spec_.range), 3);
    if (spec_.flat.axis >= 0) numbers["minItems"] = 2;
    if (!spec_.color) return numbers;
    return {{"anyOf", Json::array({std::move(numbers), {{"type", "string"}, {"description", colorText}}})}};
  }
  Json operator()(const glm::ivec2*) const { return tuple(numberSchema("integer", spec_.range), 2); }
  Json operator()(const std::optional<int>*) const {
    return {{"anyOf", Json::array({numberSchema("integer", spec_.range), {{"const", spec_.none}}})}};
  }
  Json operator()(const std::optional<double>*) const {
    Json number = numberSchema("number", spec_.range);
    if (spec_.none == nullptr) return number;
    return {{"anyOf", Json::array({std::move(number), {{"const", spec_.none}}})}};
  }
  Json operator()(const Formula*) const {
    Json plain = {{"type", Json::array({"number", "string", "boolean", "array"})},
                  {"maxItems", maxFormulaParts}};
    return animatedSchema(plain);
  }
  Json operator()(const Formulas*) const {
    Json one = (*this)(static_cast<const Formula*>(nullptr));
    one["anyOf"].push_back({{"type", "object"}});
    return one;
  }
  template <class T>
  Json operator()(const std::vector<T>*) const {
    Json list = {{"type", "array"}, {"items", (*this)(static_cast<const T*>(nullptr))}};
    if (!spec_.words.empty()) list["uniqueItems"] = true;
    return list;
  }
  template <class T>
  Json operator()(const Animated<T>*) const {
    return animatedSchema((*this)(static_cast<const T*>(nullptr)));
  }

 private:
  [[nodiscard]] Json words() const {
    Json words(spec_.words);
    if (spec_.isSwitch()) words[0] = false, words[1] = true;
    return {{"enum", words}};
  }

  const Spec& spec_;
};

/// Returns the schema of a field whose value a scene may give in place of its whole group.
Json shortFor(const std::string& field, const Json& properties) {
  Json schema = properties.at(field);
  schema["description"] = fmt::format("Short for {{\"{}\": ...}}.", field);
  return schema;
}

}  // namespace

Json SchemaWriter::object() const {
  return {{"type", "object"}, {"properties", properties_}, {"additionalProperties", false}};
}

void SchemaWriter::field(const char* name, Member member, const Spec& spec) {
  Json schema = std::visit([&](const auto* value) { return Types(spec)(value); }, member);
  if (auto standard = written(member, spec)) schema["default"] = std::move(*standard);
  const bool isFile = std::holds_alternative<std::filesystem::path*>(member);
  schema["description"] = fmt::format("{}{}", sentence(spec.doc, spec.unit),
                                      isFile ? " A file of the scene's folder or the asset folder." : "");
  add(name, std::move(schema));
}

void SchemaWriter::section(const char* name, bool* present, const char* doc,
                           const std::function<void(Fields&)>& describe) {
  SchemaWriter inner;
  describe(inner);
  Json schema = inner.object();
  if (const auto word = shorthands_.find(name); word != shorthands_.end()) {
    Json words = {{"enum", inner.properties_[word->second]["enum"]},
                  {"description", fmt::format("Short for {{\"{}\": ...}}.", word->second)}};
    schema = {{"anyOf", Json::array({std::move(words), std::move(schema)})}};
  }
  if (const auto number = shortNumbers_.find(name); number != shortNumbers_.end())
    schema = {{"anyOf", Json::array({shortFor(number->second, inner.properties_), std::move(schema)})}};
  if (switchable_.contains(name))
    schema = {{"anyOf", Json::array({{{"type", "boolean"}, {"description", "true stands for {}."}},
                                     std::move(schema)})}};
  schema["description"] = fmt::format("{}{}", doc, present == nullptr ? "" : " Off unless given.");
  add(name, std::move(schema));
}

void SchemaWriter::leftOut(const char* name, const char* what) {
  Json& schema = properties_[name];
  schema.erase("default");
  schema["description"] = fmt::format("{} Left out: {}.", schema.value("description", ""), what);
}

void SchemaWriter::listOf(const char* name, const char* doc, std::size_t maxItems, std::size_t items,
                          const std::function<void(std::size_t)>& resize,
                          const std::function<void(Fields&, std::size_t)>& describe) {
  Json standard = standardItems(items, resize, describe);
  SchemaWriter inner;
  describe(inner, 0);
  Json item = inner.object();
  if (const auto value = shorthands_.find(name); value != shorthands_.end())
    item = {{"anyOf", Json::array({shortFor(value->second, inner.properties_), std::move(item)})}};
  add(name, {{"type", "array"},
             {"items", std::move(item)},
             {"maxItems", maxItems},
             {"default", std::move(standard)},
             {"description", doc}});
}

void SchemaWriter::namedGroups(const char* name, const char* doc, const char* /*one*/, std::size_t maxItems,
                               const std::vector<std::string>& names,
                               const std::function<void(const std::vector<std::string>&)>& rename,
                               const std::function<void(Fields&, std::size_t)>& describe) {
  rename({"any"});
  SchemaWriter inner;
  describe(inner, 0);
  rename(names);
  Json group = inner.object();
  if (const auto value = shorthands_.find(name); value != shorthands_.end()) {
    group = {{"anyOf", Json::array({shortFor(value->second, inner.properties_), std::move(group)})}};
  }
  add(name, {{"type", "object"},
             {"propertyNames", {{"pattern", plainNamePattern}}},
             {"maxProperties", maxItems},
             {"additionalProperties", std::move(group)},
             {"description", doc}});
}

}  // namespace simreel::scene
