#pragma once
#include <cstddef>
#include <map>
#include <string>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Properties of a bound texture that affect the machine code of a software driver.
struct TextureShape {
  GLenum format = GL_NONE;
  int width = 0;
  int height = 0;
  int levels = 0;                                          ///< 0 for a texel view of a buffer
  std::size_t bufferBytes = 0, offset = 0, viewBytes = 0;  ///< size of the buffer, and offset and size of
                                                           ///< the view; only for texel views of a buffer
  GLint filters[2] = {}, wraps[2] = {};                    ///< filters: min and mag filter; wraps: wrap
                                                           ///< modes in s and t
};

/// Shapes of the textures and images that are bound to texture units and image units.
struct BoundViews {
  struct Image {
    TextureShape shape;
    GLint level = 0;
    GLenum access = GL_READ_ONLY;
    GLenum format = GL_NONE;
  };
  std::map<GLuint, TextureShape> textures;
  std::map<GLuint, Image> images;
  /// Views passed to a gl::Kernel, by the name of the sampler or image (namesView()). The units of these
  /// views are unknown until the program is linked.
  std::map<std::string, Image> named;
};

}  // namespace simreel::gl
