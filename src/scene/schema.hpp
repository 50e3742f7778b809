#pragma once
#include "scene/fields.hpp"

#include <nlohmann/json.hpp>

namespace simreel::scene {

/// Fields that write JSON Schema (draft 2020-12) of what is declared.
class SchemaWriter final : public Fields {
 public:
  /// Schema of the object described so far; unknown keys are not allowed in it.
  [[nodiscard]] nlohmann::ordered_json object() const;
  /// Adds a property that is not declared through Fields.
  void add(const char* name, nlohmann::ordered_json schema) { properties_[name] = std::move(schema); }

  void boolean(const char* name, bool& value, const char* doc) override;
  void integer(const char* name, int& value, Range range, const char* unit, const char* doc) override;
  void number(const char* name, float& value, Range range, const char* unit, const char* doc) override;
  void number(const char* name, double& value, Range range, const char* unit, const char* doc) override;
  void number(const char* name, Animated<float>& value, Range range, const char* unit,
              const char* doc) override;
  void optionalNumber(const char* name, std::optional<double>& value, Range range, const char* unit,
                      const char* doc) override;
  void vector(const char* name, glm::vec3& value, Range range, const char* unit, const char* doc) override;
  void vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit,
              const char* doc) override;
  void pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) override;
  void pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
             const char* doc) override;
  void text(const char* name, std::string& value, const char* doc) override;
  void integerOr(const char* name, std::optional<int>& value, const char* word, Range range,
                 const char* unit, const char* doc) override;
  void integers(const char* name, std::vector<int>& value, Range range, const char* unit,
                const char* doc) override;
  void oneOf(const char* name, int& value, const std::vector<const char*>& names, const char* doc) override;
  void someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
              const char* doc) override;
  void asset(const char* name, std::filesystem::path& value, const char* doc) override;
  void group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) override;
  void optionalGroup(const char* name, bool& present, const char* doc,
                     const std::function<void(Fields&)>& describe) override;
  void listOf(const char* name, const char* doc, std::size_t mostItems, std::size_t items,
              const std::function<void(std::size_t)>& resize,
              const std::function<void(Fields&, std::size_t)>& describe) override;
  void leftOut(const char* name, const char* what) override;
  void error(const char* /*name*/, const std::string& /*message*/) override {}
  [[nodiscard]] bool given(const char* /*name*/) const override { return false; }

 private:
  nlohmann::ordered_json properties_ = nlohmann::ordered_json::object();
};

}  // namespace simreel::scene
