#pragma once
#include <cstddef>
#include <map>
#include <string>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Properties of a bound texture that a software driver's machine code depends on.
struct TextureShape {
  GLenum format = GL_NONE;
  int width = 0;
  int height = 0;
  int levels = 0;                                          ///< 0: a view of a buffer
  std::size_t bufferBytes = 0, offset = 0, viewBytes = 0;  ///< of a view
  GLint filters[2] = {}, wraps[2] = {};                    ///< min and mag; s and t
};

/// Shapes of what is bound to the units of textures and of images.
struct BoundViews {
  struct Image {
    TextureShape shape;
    GLint level = 0;
    GLenum access = GL_READ_ONLY;
    GLenum format = GL_NONE;
  };
  std::map<GLuint, TextureShape> textures;
  std::map<GLuint, Image> images;
  /// Views given to a gl::Kernel, by the name of the sampler or image (namesView). The units are
  /// not known before the program is linked.
  std::map<std::string, Image> named;
};

}  // namespace simreel::gl
