#pragma once
#include "draw/exact/passes.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// By the name of a pass (draw::passNames()), 16 hexadecimal digits over all that it left.
using PassHashes = std::map<std::string, std::string>;
[[nodiscard]] PassHashes hashesOf(const draw::PassPicture& picture);
/// The first pass that is not the same on both sides; empty: none.
[[nodiscard]] std::string firstDifferentPass(const PassHashes& here, const PassHashes& there);

/// What a pixel shows.
struct SeenThing {
  std::string object;     ///< its name in the scene; empty for the ground, the sky, and where it has none
  std::string primitive;  ///< "triangle 12", "ball 3", "triangle 5 of instance 7", "ground", "sky"
  bool operator==(const SeenThing&) const = default;
  /// "triangle 12 of flag"
  [[nodiscard]] std::string name() const;
};
/// Of the number that a sample has.
[[nodiscard]] SeenThing thingOfNumber(const draw::PassPicture& picture, unsigned number);
/// At a pixel: what has the first of its samples that does not show the sky.
[[nodiscard]] SeenThing thingAt(const draw::PassPicture& picture, int x, int y);
/// Whether all samples of a pixel show one thing, so that what its light has is due to that.
[[nodiscard]] bool showsOneThing(const draw::PassPicture& picture, int x, int y);

/// All that passes left, as `simreel trace --dump FRAME:passes` writes it: a JSON line that says what, then
/// little-endian 32-bit words, array by array. Reading throws std::runtime_error saying what is wrong.
struct PassDump {
  int frame = 0;
  draw::PassPicture picture;
};
[[nodiscard]] std::vector<std::byte> encodePasses(const PassDump& dump);
[[nodiscard]] PassDump readPasses(std::span<const std::byte> bytes);

}  // namespace simreel::golden
