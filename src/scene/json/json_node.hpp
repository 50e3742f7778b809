#pragma once
#include "scene/json/diagnostics.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Limits on a scene's text. They bound the memory that an untrusted scene can use.
inline constexpr std::size_t maxSceneBytes = std::size_t{4} << 20;
inline constexpr std::size_t maxDepth = 64;
inline constexpr std::size_t maxValues = 1'000'000;

/// JSON value with its position in the source text.
struct Node {
  enum class Kind : std::uint8_t { null, boolean, number, text, list, object };

  Kind kind = Kind::null;
  bool boolean = false;
  int source = 0;  ///< source number, as in Place
  double number = 0.0;
  std::string text;
  std::vector<Node> children;  ///< items of a list or members of an object, in file order
  std::string key;             ///< key of the value if the value is a member of an object
  std::uint32_t begin = 0, end = 0;
  /// Byte range of the key including its quotes; both are 0 for a value without a key.
  std::uint32_t keyBegin = 0, keyEnd = 0;

  [[nodiscard]] const Node* find(std::string_view name) const;
  [[nodiscard]] Node* find(std::string_view name);
  [[nodiscard]] Place place() const { return {source, begin, end}; }
  /// Returns the place of the key, or of the value's first byte if there is no key. Messages about a whole
  /// group use it.
  [[nodiscard]] Place headPlace() const;
  /// Returns the kind in words: "a number", "a string", ...
  [[nodiscard]] const char* kindText() const;
};

/// Parses the part of `text` from byte `base` to the end. `source` is the source number for places. Skips
/// `//` and `/* */` comments. Reports errors to `diagnostics`. Returns nullopt if the text cannot be parsed
/// to the end.
[[nodiscard]] std::optional<Node> parseJson(std::string_view text, int source, std::size_t base,
                                            Diagnostics& diagnostics);

}  // namespace simreel::scene
