#include "scene/value/value_writer.hpp"

#include <fmt/format.h>

namespace simreel::scene {

using Json = nlohmann::ordered_json;

namespace {

/// Writes each type of member as JSON.
class Writer {
 public:
  explicit Writer(const Spec& spec) : spec_(spec) {}

  Json operator()(bool value) const { return value; }
  Json operator()(int value) const { return spec_.words.empty() ? Json(value) : word(value); }
  Json operator()(float value) const { return shortest(value); }
  Json operator()(double value) const { return shortest(value); }
  Json operator()(const std::string& value) const { return value; }
  Json operator()(const std::filesystem::path& value) const { return value.string(); }
  Json operator()(const glm::vec3& v) const { return {shortest(v.x), shortest(v.y), shortest(v.z)}; }
  Json operator()(const glm::ivec2& v) const { return {v.x, v.y}; }
  Json operator()(const std::optional<int>& value) const { return value ? Json(*value) : Json(spec_.none); }
  Json operator()(const std::optional<double>& value) const {
    return value ? shortest(*value) : Json(spec_.none);
  }

  Json operator()(const Formula& value) const {
    if (value.moving) return keyframes(value);
    Json list = Json::array();
    for (const Formula::Part& part : value.parts)
      list.push_back(part.text.empty() ? shortest(part.number) : Json(part.text));
    return list.size() == 1 ? list[0] : list;
  }
  Json operator()(const Formulas& value) const {
    Json all = Json::object();
    for (const Formulas::Named& one : value.list) {
      if (one.name.empty()) return (*this)(one.formula);
      all[one.name] = (*this)(one.formula);
    }
    return all;
  }

  template <class T>
  Json operator()(const std::vector<T>& items) const {
    Json list = Json::array();
    for (const T& item : items) list.push_back((*this)(item));
    return list;
  }
  template <class T>
  Json operator()(const Animated<T>& value) const {
    if (!value.moves()) return (*this)(value.at(0.0));
    Json keys = Json::array();
    for (const auto& key : value.keys())
      keys.push_back(Json::array({shortest(key.time), (*this)(key.value)}));
    return {{"keys", keys}, {"ease", easeWords[static_cast<std::size_t>(value.ease())]}};
  }

 private:
  [[nodiscard]] static Json keyframes(const Formula& value) {
    Json keys = Json::array();
    for (const auto& key : value.moving->keys()) {
      Json numbers = Json::array();
      for (int i = 0; i < value.width; ++i) numbers.push_back(shortest(key.value[i]));
      keys.push_back(Json::array({shortest(key.time), value.width == 1 ? numbers[0] : numbers}));
    }
    return {{"keys", keys}, {"ease", easeWords[static_cast<std::size_t>(value.moving->ease())]}};
  }
  [[nodiscard]] Json word(int index) const {
    if (spec_.isSwitch() && index < 2) return index == 1;
    return spec_.words[static_cast<std::size_t>(index)];
  }

  const Spec& spec_;
};

bool isNone(const Member& member, const Spec& spec) {
  if (const auto* number = std::get_if<std::optional<double>*>(&member))
    return !**number && spec.none == nullptr;
  if (const auto* formula = std::get_if<Formula*>(&member)) return (*formula)->empty();
  if (const auto* formulas = std::get_if<Formulas*>(&member)) return (*formulas)->list.empty();
  const auto* index = std::get_if<int*>(&member);
  return index != nullptr && !spec.words.empty() && **index < 0;
}

}  // namespace

Json shortest(float value) {
  return Json::parse(fmt::format("{}", value));
}

Json shortest(double value) {
  return Json::parse(fmt::format("{}", value));
}

std::optional<Json> written(const Member& member, const Spec& spec) {
  if (isNone(member, spec)) return std::nullopt;
  return std::visit([&](const auto* value) { return Writer(spec)(*value); }, member);
}

void ValueWriter::field(const char* name, Member member, const Spec& spec) {
  if (auto value = written(member, spec)) values_[name] = std::move(*value);
}

void ValueWriter::section(const char* name, bool* present, const char* /*doc*/,
                          const std::function<void(Fields&)>& describe) {
  if (present != nullptr && !*present) return;
  ValueWriter inner;
  describe(inner);
  values_[name] = inner.values();
}

void ValueWriter::listOf(const char* name, const char* /*doc*/, std::size_t /*maxItems*/, std::size_t items,
                         const std::function<void(std::size_t)>& /*resize*/,
                         const std::function<void(Fields&, std::size_t)>& describe) {
  Json& list = values_[name] = Json::array();
  for (std::size_t i = 0; i < items; ++i) {
    ValueWriter inner;
    describe(inner, i);
    list.push_back(inner.values());
  }
}

void ValueWriter::namedGroups(const char* name, const char* /*doc*/, const char* /*one*/,
                              std::size_t /*maxItems*/, const std::vector<std::string>& names,
                              const std::function<void(const std::vector<std::string>&)>& /*rename*/,
                              const std::function<void(Fields&, std::size_t)>& describe) {
  Json& groups = values_[name] = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) {
    ValueWriter inner;
    describe(inner, i);
    groups[names[i]] = inner.values();
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
    Json& differing = list.emplace_back(Json::object());
    for (const auto& [key, value] : item.items())
      if (!fresh.values().contains(key) || fresh.values()[key] != value) differing[key] = value;
  }
  return list;
}

}  // namespace simreel::scene
