#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Passes of an exact picture, each made of those before it:
///
///     visibility  what is nearest at each sample: keys of depth, and numbers of primitives, ground
///                 included
///     shadow      the maps of the sun and of the lamps; with quality "standard", how open half the
///                 picture's pixels are, and how near
///     light       of what is opaque, per pixel; with quality "standard", reflections included
///     glow        the same with what adds light, then with fields that lie behind the scene
///     bloom       what is scattered around bright places
///     picture     bytes: after lens and film, then with fields, axes and charts over it
///
/// They have the same names in files, messages and documentation. A picture has those that it needs.
inline constexpr std::array<const char*, 6> passNames = {"visibility", "shadow", "light",
                                                         "glow",       "bloom",  "picture"};

/// What a pass left, or a part of it: rows from the top.
struct PassArray {
  std::string pass;
  std::string part;  ///< "keys", "numbers"; "sun", "lamps", "openness"; "lens", the mean of all its points;
                     ///< "glows", "fields"; "film", "finished"
  int width = 0;     ///< pixels; texels of a map or of what is scattered
  int height = 0;    ///< the same
  int each = 1;      ///< words of a pixel: one a sample, or RGBA of light
  bool light = false;  ///< words are floats; there is no -0
  std::vector<std::uint32_t> words;
};

/// What is drawn with numbers of its own.
struct DrawnThing {
  std::string object;  ///< its name in the scene; empty where nobody gave it one
  std::string kind;    ///< "triangle", "ball", "instance"
  unsigned firstId = 0;
  unsigned each = 1;  ///< numbers of an instance: its triangles
};

/// All passes of a picture.
struct PassPicture {
  std::vector<PassArray> arrays;   ///< pass by pass
  std::vector<DrawnThing> things;  ///< their first numbers ascend

  // What is kept of a part that is there already are its next rows. Waits for the device.

  /// 32-bit words, of which the first ones are these rows.
  void keep(const char* pass, const char* part, std::span<const std::uint32_t> words, glm::ivec2 size,
            int each);
  /// Rows, from the first up to the second, of an RGBA32F texture.
  void keepLight(const char* pass, const char* part, const gl::Texture& light, glm::ivec2 rows);
  /// An RGBA8 texture.
  void keepBytes(const char* pass, const char* part, const gl::Texture& picture);

 private:
  /// Adds rows to an array; the words are those that are added.
  std::span<std::uint32_t> added(const char* pass, const char* part, glm::ivec2 size, int each,
                                 bool light = false);
};

}  // namespace simreel::draw
