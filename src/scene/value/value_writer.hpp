#pragma once
#include "scene/value/fields.hpp"

#include <optional>

#include <nlohmann/json.hpp>

namespace simreel::scene {

/// Returns a number as JSON with the fewest digits that identify it: 0.05F gives 0.05, not
/// 0.05000000074505806.
[[nodiscard]] nlohmann::ordered_json shortest(float value);
[[nodiscard]] nlohmann::ordered_json shortest(double value);

/// Returns the value in the form that a scene would use. Returns nullopt if the member is empty.
[[nodiscard]] std::optional<nlohmann::ordered_json> written(const Member& member, const Spec& spec);

/// Fields that write the values in the form that a scene would use.
class ValueWriter final : public Fields {
 public:
  [[nodiscard]] const nlohmann::ordered_json& values() const { return values_; }

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

 private:
  nlohmann::ordered_json values_ = nlohmann::ordered_json::object();
};

/// Returns the default items of a list as a scene would give them. Each item contains only the members
/// whose values differ from the defaults of a new item. Leaves one new item in the list.
[[nodiscard]] nlohmann::ordered_json standardItems(
    std::size_t items, const std::function<void(std::size_t)>& resize,
    const std::function<void(Fields&, std::size_t)>& describe);

}  // namespace simreel::scene
