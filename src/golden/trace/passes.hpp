#pragma once
#include "draw/exact/passes.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Hash of each pass by pass name (draw::passNames()): 16 hexadecimal digits over everything that the pass
/// wrote.
using PassHashes = std::map<std::string, std::string>;
[[nodiscard]] PassHashes hashesOf(const draw::PassPicture& picture);
/// Returns the first pass whose hashes differ, or an empty text.
[[nodiscard]] std::string firstDifferentPass(const PassHashes& here, const PassHashes& there);

/// The object and primitive that a pixel shows.
struct SeenThing {
  std::string object;     ///< object name; empty for ground, sky and objects without a name
  std::string primitive;  ///< text such as "triangle 12", "ball 3", "triangle 5 of instance 7", "ground" or
                          ///< "sky"
  bool operator==(const SeenThing&) const = default;
  /// Returns text like "triangle 12 of flag".
  [[nodiscard]] std::string name() const;
};
/// Returns the object and primitive with the primitive number of a sample.
[[nodiscard]] SeenThing thingOfNumber(const draw::PassPicture& picture, unsigned number);
/// Returns the object and primitive at the first sample of a pixel that shows something other than the sky.
[[nodiscard]] SeenThing thingAt(const draw::PassPicture& picture, int x, int y);
/// True if all samples of a pixel show the same object and primitive, so that the pixel's light comes only
/// from there.
[[nodiscard]] bool showsOneThing(const draw::PassPicture& picture, int x, int y);

/// Outputs of all passes, as written by `simreel trace --dump FRAME:passes`. The format is a JSON line that
/// lists the arrays, followed by the 32-bit little-endian words of all arrays in sequence. If reading
/// fails, throws std::runtime_error that describes the mistake.
struct PassDump {
  int frame = 0;
  draw::PassPicture picture;
};
[[nodiscard]] std::vector<std::byte> encodePasses(const PassDump& dump);
[[nodiscard]] PassDump readPasses(std::span<const std::byte> bytes);

}  // namespace simreel::golden
