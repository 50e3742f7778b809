#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/value/asset_path.hpp"
#include "scene/value/fields.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simreel::scene {

/// State that all readers of one scene share.
struct ReadContext {
  Diagnostics& diagnostics;
  const AssetFolders& assets;
  int version = sceneVersion;  ///< version of the scene
};

/// Fields that read one object of a scene. A value with an error is reported and stays at its default, so
/// that one pass finds all errors.
class Reader final : public Fields {
 public:
  /// `object`: null if the scene does not give the object. `place`: place of messages about the object
  /// itself.
  Reader(const Node* object, Place place, ReadContext context);

  /// Reads a value that must be an object. Its members must be among those that `describe` declares.
  static void readObject(const Node& node, ReadContext context,
                         const std::function<void(Reader&)>& describe);

  /// Returns the member, or null if the scene does not give it. finish() then does not report the member as
  /// unknown.
  [[nodiscard]] const Node* consume(const char* name);
  /// Reports members that have not been declared or consumed as unknown keys.
  void finish();

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
  void formerly(const char* old, const char* name) override;
  void shorthand(const char* group, const char* field) override { shorthands_[group] = field; }
  void shortNumber(const char* group, const char* field) override { shortNumbers_[group] = field; }
  void switchable(const char* group) override { switchable_.insert(group); }
  void error(const char* name, const std::string& message) override;
  void errorIn(const std::vector<std::string>& path, std::size_t begin, std::size_t end,
               const std::string& message) override;
  void idle(const char* name, const char* ruler, const std::string& message) override;
  [[nodiscard]] bool given(const char* name) const override;
  [[nodiscard]] int version() const override { return context_.version; }

 private:
  /// Returns the member `name`, or the member with its former name. Returns null if the scene gives
  /// neither.
  [[nodiscard]] const Node* find(const std::string& name) const;
  /// Returns the node at a path "group.name", or null if it does not exist.
  [[nodiscard]] const Node* at(const std::string& path) const;

  const Node* object_;
  Place place_;
  ReadContext context_;
  std::size_t errorsBefore_;
  std::vector<std::string> known_;
  /// Maps the new name to the old name for members that the scene gives by their old name.
  std::map<std::string, std::string> formerNames_;
  /// Maps a group to the field that is set if the scene gives a plain value instead of the group.
  std::map<std::string, std::string> shorthands_;
  std::map<std::string, std::string> shortNumbers_;  ///< like `shorthands_`, for fields that are numbers
  std::set<std::string> switchable_;                 ///< names of groups that a scene may give as true
};

}  // namespace simreel::scene
