#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Output of a pass, or a part of it; rows from the top.
struct PassArray {
  std::string pass;  ///< one of passNames()
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
