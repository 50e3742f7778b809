#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Output of a pass, or one part of the output. Row 0 is at the top.
struct PassArray {
  std::string pass;    ///< name of the pass, one of passNames()
  std::string part;    ///< name of the part: "keys" or "numbers" of visibility; "sun", "lamps" or
                       ///< "openness" of shadow; "lens" (mean over all views) of light; "glows" or "fields"
                       ///< of glow; "film" or "finished" of picture
  int width = 0;       ///< width in pixels, or in texels for shadow maps and the bloom texture
  int height = 0;      ///< height, in the same unit as the width
  int each = 1;        ///< number of 32-bit words per pixel: one for each sample, or four for RGBA light
  bool light = false;  ///< true if the words are floats; -0 is stored as 0
  std::vector<std::uint32_t> words;
};

/// An object, or part of an object, with a separate range of primitive ids.
struct DrawnThing {
  std::string object;  ///< name in the scene; empty if the object has no name
  std::string kind;    ///< kind of primitive: "triangle", "ball" or "instance"
  unsigned firstId = 0;
  unsigned each = 1;  ///< ids per instance: the triangle count of the mesh, or 1
};

/// Outputs of all passes of a picture.
struct PassPicture {
  std::vector<PassArray> arrays;   ///< outputs in the order of the passes
  std::vector<DrawnThing> things;  ///< objects with primitive ids, sorted by firstId

  // The keep functions append rows to an array, or create the array if it does not exist. They wait for the
  // GPU.

  /// Appends rows of 32-bit words. `words` may be longer than the rows; the surplus is ignored.
  void keep(const char* pass, const char* part, std::span<const std::uint32_t> words, glm::ivec2 size,
            int each);
  /// Appends the rows from rows.x (inclusive) to rows.y (exclusive) of an RGBA32F texture.
  void keepLight(const char* pass, const char* part, const gl::Texture& light, glm::ivec2 rows);
  /// Appends all rows of an RGBA8 texture.
  void keepBytes(const char* pass, const char* part, const gl::Texture& picture);

 private:
  /// Appends `size.y` rows to an array and returns the memory of the new rows.
  std::span<std::uint32_t> added(const char* pass, const char* part, glm::ivec2 size, int each,
                                 bool light = false);
};

}  // namespace simreel::draw
