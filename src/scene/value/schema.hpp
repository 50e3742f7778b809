#pragma once
#include "scene/value/fields.hpp"

#include <map>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace simreel::scene {

/// Fields that write a JSON Schema (draft 2020-12) of the declared fields.
class SchemaWriter final : public Fields {
 public:
  /// Returns the schema of the object described so far. It does not allow unknown keys.
  [[nodiscard]] nlohmann::ordered_json object() const;
  /// Adds a property that was not declared through Fields.
  void add(const char* name, nlohmann::ordered_json schema) { properties_[name] = std::move(schema); }

  void field(const char* name, Member member, const Spec& spec) override;
  void section(const char* name, bool* present, const char* doc,
               const std::function<void(Fields&)>& describe) override;
  void listOf(const char* name, const char* doc, std::size_t maxItems, std::size_t items,
              const std::function<void(std::size_t)>& resize,
              const std::function<void(Fields&, std::size_t)>& describe) override;
  void namedGroups(const char* name, const char* doc, const char* one, std::size_t maxItems,
                   const std::vector<std::string>& names,
                   const std::function<void(const std::vector<std::string>&)>& rename,
                   const std::function<void(Fields&, std::size_t)>& describe) override;
  void leftOut(const char* name, const char* what) override;
  void shorthand(const char* group, const char* field) override { shorthands_[group] = field; }
  void shortNumber(const char* group, const char* field) override { shortNumbers_[group] = field; }
  void switchable(const char* group) override { switchable_.insert(group); }

 private:
  nlohmann::ordered_json properties_ = nlohmann::ordered_json::object();
  std::map<std::string, std::string> shorthands_, shortNumbers_;
  std::set<std::string> switchable_;
};

}  // namespace simreel::scene
