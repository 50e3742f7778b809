#include "scene/value_writer.hpp"

#include "scene/default_text.hpp"

#include <utility>

namespace simreel::scene {

using Json = nlohmann::ordered_json;

void ValueWriter::boolean(const char* name, bool& value, const char* /*doc*/) {
  values_[name] = value;
}

void ValueWriter::integer(const char* name, int& value, Range /*range*/, const char* /*unit*/,
                          const char* /*doc*/) {
  values_[name] = value;
}

void ValueWriter::number(const char* name, float& value, Range /*range*/, const char* /*unit*/,
                         const char* /*doc*/) {
  values_[name] = shortest(value);
}

void ValueWriter::number(const char* name, double& value, Range /*range*/, const char* /*unit*/,
                         const char* /*doc*/) {
  values_[name] = shortest(value);
}

void ValueWriter::number(const char* name, Animated<float>& value, Range /*range*/, const char* /*unit*/,
                         const char* /*doc*/) {
  values_[name] = shortest(value);
}

void ValueWriter::optionalNumber(const char* name, std::optional<double>& value, Range /*range*/,
                                 const char* /*unit*/, const char* /*doc*/) {
  if (value) values_[name] = shortest(*value);
}

void ValueWriter::vector(const char* name, glm::vec3& value, Range /*range*/, const char* /*unit*/,
                         const char* /*doc*/) {
  values_[name] = shortest(value);
}

void ValueWriter::vector(const char* name, Animated<glm::vec3>& value, Range /*range*/,
                         const char* /*unit*/, const char* /*doc*/) {
  values_[name] = shortest(value);
}

void ValueWriter::pair(const char* name, glm::ivec2& value, Range /*range*/, const char* /*unit*/,
                       const char* /*doc*/) {
  values_[name] = shortest(value);
}

void ValueWriter::pairs(const char* name, std::vector<glm::ivec2>& value, Range /*range*/,
                        const char* /*unit*/, const char* /*doc*/) {
  Json& list = values_[name] = Json::array();
  for (const glm::ivec2& item : value) list.push_back(shortest(item));
}

void ValueWriter::text(const char* name, std::string& value, const char* /*doc*/) {
  values_[name] = value;
}

void ValueWriter::integerOr(const char* name, std::optional<int>& value, const char* word, Range /*range*/,
                            const char* /*unit*/, const char* /*doc*/) {
  values_[name] = value ? Json(*value) : Json(word);
}

void ValueWriter::integers(const char* name, std::vector<int>& value, Range /*range*/, const char* /*unit*/,
                           const char* /*doc*/) {
  values_[name] = value;
}

void ValueWriter::oneOf(const char* name, int& value, const std::vector<const char*>& names,
                        const char* /*doc*/) {
  if (value >= 0) values_[name] = names.at(static_cast<std::size_t>(value));
}

void ValueWriter::someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
                         const char* /*doc*/) {
  Json& list = values_[name] = Json::array();
  for (const int index : value) list.push_back(names.at(static_cast<std::size_t>(index)));
}

void ValueWriter::asset(const char* name, std::filesystem::path& value, const char* /*doc*/) {
  values_[name] = value.string();
}

void ValueWriter::group(const char* name, const char* /*doc*/,
                        const std::function<void(Fields&)>& describe) {
  ValueWriter inner;
  describe(inner);
  values_[name] = inner.values();
}

void ValueWriter::optionalGroup(const char* name, bool& present, const char* doc,
                                const std::function<void(Fields&)>& describe) {
  if (present) group(name, doc, describe);
}

void ValueWriter::listOf(const char* name, const char* /*doc*/, std::size_t /*mostItems*/,
                         std::size_t items, const std::function<void(std::size_t)>& /*resize*/,
                         const std::function<void(Fields&, std::size_t)>& describe) {
  Json& list = values_[name] = Json::array();
  for (std::size_t i = 0; i < items; ++i) {
    ValueWriter inner;
    describe(inner, i);
    list.push_back(inner.values());
  }
}

Json standardItems(std::size_t items, const std::function<void(std::size_t)>& resize,
                   const std::function<void(Fields&, std::size_t)>& describe) {
  ValueWriter all;
  all.listOf("items", "", items, items, resize, describe);
  resize(0);
  resize(1);
  ValueWriter fresh;
  describe(fresh, 0);
  Json list = Json::array();
  for (const Json& item : all.values()["items"]) {
    Json& told = list.emplace_back(Json::object());
    for (const auto& [key, value] : item.items())
      if (!fresh.values().contains(key) || fresh.values()[key] != value) told[key] = value;
  }
  return list;
}

}  // namespace simreel::scene
