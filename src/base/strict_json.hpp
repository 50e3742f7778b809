#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace simreel {

// JSON other than scenes (those have their own reader, which knows lines and columns): our own files and
// glTF. Objects are sorted by key, so that one with a million keys costs no more than its bytes.

/// A mistake in a JSON text: "frames[2].pixels must be text".
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a JSON text may hold.
struct JsonLimits {
  std::size_t depth = 100;  ///< levels; to copy or write what is deeper by far would use up the stack
  std::size_t containers = std::numeric_limits<std::size_t>::max();  ///< objects and lists
  bool comments = false;                                             ///< may stand in it
};

/// Throws JsonError for text that is no JSON, that holds more than the limits, a number that no double
/// holds, or a key twice in one object.
[[nodiscard]] nlohmann::json parseStrictJson(std::string_view text, const JsonLimits& limits = {});

/// A value of a parsed text, which has to live longer, and the path by which mistakes name it. Throws
/// JsonError where the value is not what it is asked for.
class JsonValue {
 public:
  explicit JsonValue(const nlohmann::json& json, std::string path = {})
      : json_(&json), path_(std::move(path)) {}

  [[nodiscard]] const nlohmann::json& json() const { return *json_; }
  [[nodiscard]] bool isNull() const;
  /// Whether it is this text. (The library's own comparison takes memory and is noexcept.)
  [[nodiscard]] bool is(std::string_view text) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number() const;
  /// A whole number that Int holds, and from `min` to `max`.
  template <std::integral Int = int>
  [[nodiscard]] Int integer(std::type_identity_t<Int> min = std::numeric_limits<Int>::min(),
                            std::type_identity_t<Int> max = std::numeric_limits<Int>::max()) const {
    static_assert(sizeof(Int) < sizeof(std::int64_t) || std::signed_integral<Int>);
    return static_cast<Int>(integerBetween(min, max));
  }

  /// Items of a list.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] JsonValue at(std::size_t index) const;
  void eachItem(const std::function<void(const JsonValue& item)>& visit) const;
  [[nodiscard]] std::vector<std::string> texts() const;

  /// Members of an object.
  [[nodiscard]] bool has(const std::string& key) const { return find(key).has_value(); }
  [[nodiscard]] JsonValue at(const std::string& key) const;
  [[nodiscard]] std::optional<JsonValue> find(const std::string& key) const;
  void eachMember(const std::function<void(const std::string& key, const JsonValue& member)>& visit) const;

  /// Throws JsonError: the path, then `what`.
  [[noreturn]] void wrong(std::string_view what) const;

 private:
  [[nodiscard]] std::int64_t integerBetween(std::int64_t min, std::int64_t max) const;
  [[nodiscard]] JsonValue member(const std::string& key, const nlohmann::json& json) const;
  void expect(bool kind, std::string_view what) const;

  const nlohmann::json* json_;
  std::string path_;  ///< empty: the whole text
};

/// An object of which every member has to be asked for.
class JsonObject {
 public:
  explicit JsonObject(JsonValue value) : value_(std::move(value)) {}
  [[nodiscard]] JsonValue at(const std::string& key);
  [[nodiscard]] std::optional<JsonValue> find(const std::string& key);
  /// Throws JsonError for a member that was not asked for. Call at the end.
  void finish() const;

 private:
  JsonValue value_;
  std::set<std::string> asked_;
};

/// Of an object's member; empty where there is none.
template <class Object>
[[nodiscard]] std::string textIfThere(Object& object, const std::string& key) {
  const auto found = object.find(key);
  return found ? found->text() : std::string();
}

}  // namespace simreel
