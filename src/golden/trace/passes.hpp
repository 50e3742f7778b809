#pragma once
#include "draw/exact/passes.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Hashes by pass name (draw::passNames()): 16 hexadecimal digits over everything that the pass wrote.
using PassHashes = std::map<std::string, std::string>;
[[nodiscard]] PassHashes hashesOf(const draw::PassPicture& picture);
/// Returns the first pass whose hashes differ, or an empty text.
[[nodiscard]] std::string firstDifferentPass(const PassHashes& here, const PassHashes& there);

/// The object and primitive that a pixel shows.
struct SeenThing {
  std::string object;     ///< object name; empty for ground, sky and objects without a name
  std::string primitive;  ///< "triangle 12", "ball 3", "triangle 5 of instance 7", "ground", "sky"
  bool operator==(const SeenThing&) const = default;
  /// Returns text like "triangle 12 of flag".
  [[nodiscard]] std::string name() const;
};
/// Returns the thing with the primitive number of a sample.
[[nodiscard]] SeenThing thingOfNumber(const draw::PassPicture& picture, unsigned number);
/// Returns the thing at the first sample of a pixel that shows something other than the sky.
[[nodiscard]] SeenThing thingAt(const draw::PassPicture& picture, int x, int y);
/// True if all samples of a pixel show the same thing, so that the pixel's light comes from that thing
/// alone.
[[nodiscard]] bool showsOneThing(const draw::PassPicture& picture, int x, int y);

/// Outputs of all passes, as written by `simreel trace --dump FRAME:passes`. Format: a JSON line that lists
/// the arrays, then the 32-bit little-endian words of all arrays in sequence. Reading throws
/// std::runtime_error that describes the mistake.
struct PassDump {
  int frame = 0;
  draw::PassPicture picture;
};
[[nodiscard]] std::vector<std::byte> encodePasses(const PassDump& dump);
[[nodiscard]] PassDump readPasses(std::span<const std::byte> bytes);

}  // namespace simreel::golden
