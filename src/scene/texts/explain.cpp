#include "scene/texts/explain.hpp"

#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/override.hpp"
#include "scene/scene_source.hpp"
#include "scene/sections.hpp"
#include "scene/value/value_writer.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

using Json = nlohmann::ordered_json;

const Json* memberOf(const Json* values, const std::string& name) {
  if (values == nullptr || !values->is_object() || !values->contains(name)) return nullptr;
  return &values->at(name);
}

/// Fields that record each value and its origin.
class Explainer final : public Fields {
 public:
  struct Shared {
    const Diagnostics& diagnostics;
    std::string file;  ///< name of the scene file without folders
    std::vector<ExplainedValue>& values;
    int version;
  };
  /// `node`: the scene's node for these fields; null if the scene gives no value. `standard`: the default
  /// values; null if unknown. `derived`: origin of a value that the scene does not give and that differs
  /// from the default.
  Explainer(Shared& shared, std::string prefix, const Node* node, const Json* standard, std::string derived)
      : shared_(shared),
        prefix_(std::move(prefix)),
        node_(node),
        standard_(standard),
        derived_(std::move(derived)) {}

  void field(const char* name, Member member, const Spec& spec) override {
    const std::optional<Json> value = written(member, spec);
    add(name, value ? value->dump() : "off", find(name), value ? &*value : nullptr);
  }

  void section(const char* name, bool* present, const char* /*doc*/,
               const std::function<void(Fields&)>& describe) override {
    const Node* own = find(name);
    if (present != nullptr && !*present) return add(name, "off", own, nullptr);
    Explainer inner(shared_, prefix_ + name + ".", own, memberOf(standard_, name), derivedOf(name));
    if (const auto word = shorthands_.find(name); word != shorthands_.end())
      inner.shorthand_ = word->second;
    describe(inner);
  }

  void listOf(const char* name, const char* /*doc*/, std::size_t /*maxItems*/, std::size_t items,
              const std::function<void(std::size_t)>& /*resize*/,
              const std::function<void(Fields&, std::size_t)>& describe) override {
    const Node* own = find(name);
    if (items == 0) return add(name, "[]", own, nullptr);
    for (std::size_t i = 0; i < items; ++i) {
      const bool is = own != nullptr && own->kind == Node::Kind::list && i < own->children.size();
      Explainer inner(shared_, fmt::format("{}{}.{}.", prefix_, name, i), is ? &own->children[i] : nullptr,
                      nullptr, derivedOf(name));
      describe(inner, i);
    }
  }

  void namedGroups(const char* name, const char* /*doc*/, const char* /*one*/, std::size_t /*maxItems*/,
                   const std::vector<std::string>& names,
                   const std::function<void(const std::vector<std::string>&)>& /*rename*/,
                   const std::function<void(Fields&, std::size_t)>& describe) override {
    const Node* own = find(name);
    if (names.empty()) return add(name, "{}", own, nullptr);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Node* group = own == nullptr ? nullptr : own->find(names[i]);
      Explainer inner(shared_, fmt::format("{}{}.{}.", prefix_, name, names[i]), group, nullptr,
                      derivedOf(name));
      if (const auto word = shorthands_.find(name); word != shorthands_.end())
        inner.shorthand_ = word->second;
      describe(inner, i);
    }
  }

  void formerly(const char* old, const char* name) override { former_[name] = old; }
  void shorthand(const char* group, const char* field) override { shorthands_[group] = field; }
  void shortNumber(const char* group, const char* field) override { shorthands_[group] = field; }

  void leftOut(const char* name, const char* what) override {
    for (ExplainedValue& value : shared_.values)
      if (value.path == prefix_ + name && find(name) == nullptr &&
          (value.origin == followsText || value.value == "off"))
        value.origin = what;
  }

  [[nodiscard]] bool given(const char* name) const override { return find(name) != nullptr; }
  [[nodiscard]] int version() const override { return shared_.version; }

  /// Maps each section that the scene leaves out to where its values come from, for example "sky" to
  /// "stage".
  std::map<std::string, std::string> derivedSections = {};

 private:
  [[nodiscard]] const Node* find(const std::string& name) const {
    if (node_ == nullptr) return nullptr;
    if (node_->kind != Node::Kind::object) return name == shorthand_ ? node_ : nullptr;
    if (const Node* own = node_->find(name)) return own;
    const auto former = former_.find(name);
    return former == former_.end() ? nullptr : node_->find(former->second);
  }

  [[nodiscard]] std::string derivedOf(const std::string& name) const {
    const auto own = derivedSections.find(name);
    return own == derivedSections.end() ? derived_ : own->second;
  }

  [[nodiscard]] std::string whereOf(const Node& node) const {
    if (shared_.diagnostics.isOverride(node.source)) return "command line";
    const std::string where = shared_.diagnostics.where(node.place());  // The text of `where` has the form
                                                                        // file:line:column.
    const std::size_t column = where.rfind(':');
    const std::size_t line = where.rfind(':', column - 1);
    return shared_.file + where.substr(line, column - line);
  }

  void add(const std::string& name, std::string text, const Node* own, const Json* value) {
    if (name == "$schema") return;
    ExplainedValue one{prefix_ + name, std::move(text), "default", own == nullptr};
    const Json* standard = memberOf(standard_, name);
    if (own != nullptr) {
      one.origin = whereOf(*own);
    } else if (standard_ != nullptr && value != nullptr && (standard == nullptr || *standard != *value)) {
      one.origin = derivedOf(name);
      one.standard = false;
    } else if (standard_ == nullptr && !derived_.empty() && derived_ != followsText) {
      one.origin = derived_;
    }
    shared_.values.push_back(std::move(one));
  }

 public:
  static constexpr const char* followsText = "follows from other values";

 private:
  Shared& shared_;
  std::string prefix_;
  const Node* node_;
  const Json* standard_;
  std::string derived_;
  std::string shorthand_;
  std::map<std::string, std::string> former_, shorthands_;
};

template <class Describe>
Json standardOf(Describe describe) {
  ValueWriter writer;
  describe(writer);
  return writer.values();
}

std::map<std::string, std::string> sectionOrigins(const Scene& scene) {
  std::map<std::string, std::string> origins;
  if (!scene.camera.gltf)
    origins["camera"] = scene.surveyed ? "placed to show all motion" : "placed to show all objects";
  if (!scene.staged) return origins;
  for (const char* name : {"sun", "sky", "ground", "lights"}) origins[name] = "stage";
  origins["render"] = "stage";
  return origins;
}

}  // namespace

std::vector<ExplainedValue> explainScene(Scene& scene, const std::filesystem::path& file,
                                         std::span<const Override> overrides, const Kinds& kinds) {
  const auto [text, name] = readSceneSource(file, kinds);
  Diagnostics diagnostics(name.string(), text);
  std::optional<Node> root = parseJson(text, 0, 0, diagnostics);
  std::vector<ExplainedValue> values;
  if (!root) return values;  // The root always exists, because the same text was parsed before.
  for (const Override& change : overrides) applyOverride(*root, change, diagnostics);
  const Node* version = root->find("version");
  Explainer::Shared shared{diagnostics, name.filename().string(), values,
                           version == nullptr ? sceneVersion : static_cast<int>(version->number)};

  const Json standard = standardOf([](Fields& fields) {
    Scene fresh;
    describeScene(fields, fresh);
  });
  Explainer top(shared, "", &*root, &standard, Explainer::followsText);
  top.derivedSections = sectionOrigins(scene);
  describeScene(top, scene);

  const Node* objects = root->find("objects");
  for (Object& object : scene.objects) {
    const Node* own = objects == nullptr ? nullptr : objects->find(object.name);
    const auto kind = std::find_if(kinds.list.begin(), kinds.list.end(),
                                   [&](const Kind& one) { return object.kind == one.name; });
    if (own == nullptr || kind == kinds.list.end()) continue;
    const std::string path = "objects." + object.name + ".";
    const Json fresh = standardOf([&](Fields& fields) { kind->makeParameters()->describe(fields); });
    Explainer inner(shared, path + object.kind + ".", own->find(object.kind), &fresh,
                    Explainer::followsText);
    object.parameters->describe(inner);
    if (object.parameters->drawnWith() != nullptr) continue;
    const Json plain = standardOf([](Fields& fields) { Material().describe(fields); });
    Explainer look(shared, path + "material.", own->find("material"), &plain,
                   scene.staged ? "stage" : Explainer::followsText);
    object.material.describe(look);
  }
  Explainer tests(shared, "", &*root, nullptr, Explainer::followsText);
  describeTests(tests, scene, std::nullopt);
  return values;
}

}  // namespace simreel::scene
