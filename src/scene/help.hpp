#pragma once
#include "scene/fields.hpp"

#include <string>
#include <vector>

namespace simreel::scene {

/// Fields that print a table for people: name, default, range, unit, sentence. Members of groups are
/// named `group.member`, of lists `list[].member`.
class HelpWriter final : public Fields {
 public:
  /// `expandGroups`: false shows a group or list as one line.
  explicit HelpWriter(bool expandGroups) : expandGroups_(expandGroups) {}
  void add(const std::string& name, std::string standard, std::string range, const char* unit,
           std::string doc);
  /// The table, columns aligned.
  [[nodiscard]] std::string table() const;

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
  struct Row {
    std::string name, standard, range, unit, doc;
  };
  void addGroup(const char* name, const char* doc, const char* standard,
                const std::function<void(Fields&)>& describe);

  bool expandGroups_;
  std::string prefix_;
  std::vector<Row> rows_;
};

}  // namespace simreel::scene
