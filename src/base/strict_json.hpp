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

// Reader of JSON other than scenes, which are files of this program, and glTF. (Scenes have a separate
// reader, which records lines and columns.) The members of an object are sorted by key, so that reading an
// object with a million keys does not take quadratic time.

/// Error in a JSON text: "frames[2].pixels must be text".
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Limits on a JSON text.
struct JsonLimits {
  /// Max nesting depth. Copying or writing much deeper values would overflow the stack.
  std::size_t depth = 100;
  /// Max number of objects and lists.
  std::size_t containers = std::numeric_limits<std::size_t>::max();
  bool comments = false;  ///< true if comments are allowed
};

/// Parses a JSON text. Throws JsonError if the text is not JSON, exceeds the limits, contains a number too
/// large for a double, or contains the same key twice in one object.
[[nodiscard]] nlohmann::json parseStrictJson(std::string_view text, const JsonLimits& limits = {});

/// Value in a parsed JSON text, with the path that names it in error messages. The parsed text must outlive
/// this object. Functions throw JsonError if the value has another type.
class JsonValue {
 public:
  explicit JsonValue(const nlohmann::json& json, std::string path = {})
      : json_(&json), path_(std::move(path)) {}

  [[nodiscard]] const nlohmann::json& json() const { return *json_; }
  [[nodiscard]] bool isNull() const;
  /// True if the value is a string equal to `text`. (The library's own comparison allocates memory although
  /// it is noexcept.)
  [[nodiscard]] bool is(std::string_view text) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number() const;
  /// Returns a whole number from `min` to `max`.
  template <std::integral Int = int>
  [[nodiscard]] Int integer(std::type_identity_t<Int> min = std::numeric_limits<Int>::min(),
                            std::type_identity_t<Int> max = std::numeric_limits<Int>::max()) const {
    static_assert(sizeof(Int) < sizeof(std::int64_t) || std::signed_integral<Int>);
    return static_cast<Int>(integerBetween(min, max));
  }

  /// The following functions are for the items of a list.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] JsonValue at(std::size_t index) const;
  void eachItem(const std::function<void(const JsonValue& item)>& visit) const;
  [[nodiscard]] std::vector<std::string> texts() const;

  /// The following functions are for the members of an object.
  [[nodiscard]] bool has(const std::string& key) const { return find(key).has_value(); }
  [[nodiscard]] JsonValue at(const std::string& key) const;
  [[nodiscard]] std::optional<JsonValue> find(const std::string& key) const;
  void eachMember(const std::function<void(const std::string& key, const JsonValue& member)>& visit) const;

  /// Throws JsonError with the path, followed by `what`.
  [[noreturn]] void wrong(std::string_view what) const;

 private:
  [[nodiscard]] std::int64_t integerBetween(std::int64_t min, std::int64_t max) const;
  [[nodiscard]] JsonValue member(const std::string& key, const nlohmann::json& json) const;
  void expect(bool kind, std::string_view what) const;

  const nlohmann::json* json_;
  std::string path_;  ///< path of the value; empty for the whole text
};

/// Object whose members must all be read. finish() reports unread members as errors.
class JsonObject {
 public:
  explicit JsonObject(JsonValue value) : value_(std::move(value)) {}
  [[nodiscard]] JsonValue at(const std::string& key);
  [[nodiscard]] std::optional<JsonValue> find(const std::string& key);
  /// Throws JsonError if a member has not been read. Must be called last.
  void finish() const;

 private:
  JsonValue value_;
  std::set<std::string> asked_;
};

/// Returns the text of an object's member, or an empty text if the member does not exist.
template <class Object>
[[nodiscard]] std::string textIfThere(Object& object, const std::string& key) {
  const auto found = object.find(key);
  return found ? found->text() : std::string();
}

}  // namespace simreel
