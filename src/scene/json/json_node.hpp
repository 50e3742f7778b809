#pragma once
#include "scene/json/diagnostics.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// What a hostile scene may make us hold.
inline constexpr std::size_t maxSceneBytes = std::size_t{4} << 20;
inline constexpr std::size_t maxDepth = 64;
inline constexpr std::size_t maxValues = 1'000'000;

/// One JSON value that knows where it was written.
struct Node {
  enum class Kind : std::uint8_t { null, boolean, number, text, list, object };

  Kind kind = Kind::null;
  bool boolean = false;
  int source = 0;  ///< which text (see Place)
  double number = 0.0;
  std::string text;
  std::vector<Node> children;  ///< of a list or object, in file order
  std::string key;             ///< of an object's member
  std::uint32_t begin = 0, end = 0;
  std::uint32_t keyBegin = 0, keyEnd = 0;  ///< the quotes included; both 0 for a value without key

  [[nodiscard]] const Node* find(std::string_view name) const;
  [[nodiscard]] Node* find(std::string_view name);
  [[nodiscard]] Place place() const { return {source, begin, end}; }
  /// Of the key; of the first byte when there is no key. Good for messages about a whole group.
  [[nodiscard]] Place headPlace() const;
  /// "a number", "a string", ...
  [[nodiscard]] const char* kindText() const;
};

/// Parses `text`, all of source `source` from byte `base` on; `//` and `/* */` comments are skipped.
/// Mistakes go to `diagnostics`; nothing is returned when the text cannot be read to its end.
[[nodiscard]] std::optional<Node> parseJson(std::string_view text, int source, std::size_t base,
                                            Diagnostics& diagnostics);

}  // namespace simreel::scene
