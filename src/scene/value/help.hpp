#pragma once
#include "scene/value/fields.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace simreel::scene {

/// One parameter as printed by the help.
struct HelpRow {
  std::string name;      ///< `group.member`, or `list[].member`
  std::string standard;  ///< default as JSON or in words; "off" for a group that is absent by default
  std::string range, unit, doc;
  bool group = false;  ///< true if the parameter is a group of other parameters

  /// Returns default, range and unit in one line: "default 500; >= 0; N/m".
  [[nodiscard]] std::string facts() const;
};

/// Fields that collect the rows of the help.
class HelpWriter final : public Fields {
 public:
  /// `expandGroups`: false to show each group or list as a single row.
  explicit HelpWriter(bool expandGroups) : expandGroups_(expandGroups) {}
  void add(const std::string& name, std::string standard, std::string range, const char* unit,
           std::string doc);
  [[nodiscard]] const std::vector<HelpRow>& rows() const { return rows_; }

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
  bool expandGroups_;
  std::string prefix_;
  std::vector<HelpRow> rows_;
  std::map<std::string, std::string> shorthands_, shortNumbers_;
  std::set<std::string> switchable_;
};

}  // namespace simreel::scene
