#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::golden {

/// A JSON object read member by member, where a member of the wrong type, a missing one, or one that nobody
/// asked for is a mistake. Mistakes throw std::runtime_error naming the member's path ("frames[2].pixels").
class StrictObject {
 public:
  using Json = nlohmann::ordered_json;
  StrictObject(const Json& object, std::string path);

  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] std::string text(const char* key);
  [[nodiscard]] std::string text(const char* key, const std::string& otherwise);
  [[nodiscard]] int integer(const char* key);
  [[nodiscard]] double number(const char* key);
  [[nodiscard]] std::vector<std::string> texts(const char* key);
  [[nodiscard]] StrictObject object(const char* key);
  /// Members of this object that are themselves objects or texts under free names.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// Throws when a member was not asked for. Call at the end.
  void finish() const;

 private:
  const Json& member(const char* key);
  [[noreturn]] void wrong(const char* key, const char* what) const;
  const Json& object_;
  std::string path_;
  std::set<std::string, std::less<>> asked_;
};

/// Parses a JSON text. Throws std::runtime_error ("not valid JSON at byte 17").
[[nodiscard]] StrictObject::Json parseStrictly(std::string_view text);

}  // namespace simreel::golden
