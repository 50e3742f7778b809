#pragma once
#include <cstddef>
#include <string_view>

namespace simreel {

/// Levels that JSON other than a scene may nest; our own files have a handful, and glTF not many more.
constexpr std::size_t mostJsonDepth = 100;

/// How deep objects and lists stand in one another in a JSON text (also one with comments): 1 for "{}".
/// Looks at the text alone, so that a million levels cost no memory, and stops counting at `enough`. Where
/// the text is no JSON, it counts all brackets that a parser would see before it finds that out, or more.
[[nodiscard]] std::size_t jsonDepth(std::string_view text, std::size_t enough = mostJsonDepth + 1);

/// How many objects and lists it holds, counted the same way up to `enough`.
[[nodiscard]] std::size_t jsonContainers(std::string_view text, std::size_t enough);

/// Throws std::runtime_error for a text deeper than mostJsonDepth. To be called before it is parsed: to
/// copy or write such a value would use up the stack.
void refuseDeepJson(std::string_view text);

}  // namespace simreel
