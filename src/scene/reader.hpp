#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "scene/diagnostics.hpp"
#include "scene/fields.hpp"
#include "scene/json_node.hpp"

namespace simreel::scene {

/// What every reader of one file shares.
struct ReadContext {
  Diagnostics& diagnostics;
  std::filesystem::path sceneFolder;
};

/// Reads the members of one JSON object into described values; every mistake goes to the diagnostics and the value
/// keeps its default. Call finish() after describing: what was not asked for is an unknown key.
class Reader : public Fields {
 public:
  Reader(const Node& object, ReadContext& context) : object_(object), context_(context) {}

  void boolean(const char* name, bool& value, const char* doc) override;
  void integer(const char* name, int& value, Range range, const char* unit, const char* doc) override;
  void number(const char* name, float& value, Range range, const char* unit, const char* doc) override;
  void number(const char* name, double& value, Range range, const char* unit, const char* doc) override;
  void number(const char* name, Animated<float>& value, Range range, const char* unit, const char* doc) override;
  void vector(const char* name, glm::vec3& value, Range range, const char* unit, const char* doc) override;
  void vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit, const char* doc) override;
  void pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) override;
  void pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
             const char* doc) override;
  void text(const char* name, std::string& value, const char* doc) override;
  void integerOr(const char* name, std::optional<int>& value, const char* word, Range range, const char* unit,
                 const char* doc) override;
  void integers(const char* name, std::vector<int>& value, Range range, const char* unit, const char* doc) override;
  void oneOf(const char* name, int& value, const std::vector<const char*>& names, const char* doc) override;
  void someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
              const char* doc) override;
  void asset(const char* name, std::filesystem::path& value, const char* doc) override;
  void group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) override;
  void optionalGroup(const char* name, bool& present, const char* doc,
                     const std::function<void(Fields&)>& describe) override;
  void listOf(const char* name, const char* doc, std::size_t mostItems, const std::function<void(std::size_t)>& resize,
              const std::function<void(Fields&, std::size_t)>& describe) override;
  void error(const char* name, const std::string& message) override;
  [[nodiscard]] bool given(const char* name) const override { return object_.find(name) != nullptr; }

  /// Marks a name as known; null when the scene does not give it.
  const Node* take(const char* name);
  /// Reports the keys nobody asked for.
  void finish();

 private:
  template <class T, class ReadValue>
  void animated(const char* name, Animated<T>& value, ReadValue readValue);
  bool readNumber(const Node& node, Range range, const char* unit, double& value);
  bool readInteger(const Node& node, Range range, const char* unit, int& value);
  bool readVector(const Node& node, Range range, const char* unit, glm::vec3& value);
  bool readPair(const Node& node, Range range, const char* unit, glm::ivec2& value);
  bool readName(const Node& node, const std::vector<const char*>& names, int& value);
  bool expect(const Node& node, Node::Kind kind, const char* wanted);
  void inside(const Node& node, const std::function<void(Fields&)>& describe);

  const Node& object_;
  ReadContext& context_;
  std::vector<std::string> known_;
};

}  // namespace simreel::scene
