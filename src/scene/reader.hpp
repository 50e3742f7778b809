#pragma once
#include "scene/asset_path.hpp"
#include "scene/diagnostics.hpp"
#include "scene/fields.hpp"
#include "scene/json_node.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace simreel::scene {

/// What all readers of one scene share.
struct ReadContext {
  Diagnostics& diagnostics;
  const AssetFolders& assets;
};

/// Fields that read one object of a scene. A value with a mistake is reported and keeps its default,
/// so one pass finds every mistake.
class Reader final : public Fields {
 public:
  /// `object`: null when the scene does not give it. `place`: for messages about the object itself.
  Reader(const Node* object, Place place, ReadContext context);

  /// Reads a value that must be an object with what `describe` names and nothing else.
  static void readObject(const Node& node, ReadContext context,
                         const std::function<void(Reader&)>& describe);

  /// The member, which counts as known from here on; null when it is not given.
  [[nodiscard]] const Node* take(const char* name);
  /// Reports members that nobody asked for.
  void finish();

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
  void leftOut(const char* /*name*/, const char* /*what*/) override {}
  void error(const char* name, const std::string& message) override;
  [[nodiscard]] bool given(const char* name) const override;

 private:
  const Node* object_;
  Place place_;
  ReadContext context_;
  std::size_t errorsBefore_;
  std::vector<std::string> known_;
};

}  // namespace simreel::scene
