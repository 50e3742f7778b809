#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>

namespace simreel::gl {

/// The interface of a linked program that the driver reports, without names that the driver optimised away.
struct ProgramInterface {
  /// A uniform outside blocks, named "a" or "a.b". An array of numbers is named "a", and its elements have
  /// consecutive locations.
  struct Number {
    std::string name;
    GLenum type = GL_NONE;
  };
  /// A sampler or an image.
  struct View {
    std::string name;
    GLuint unit = 0;
    bool image = false;
  };
  /// A storage block or a uniform block.
  struct Block {
    std::string name;
    GLuint binding = 0;
    bool storage = false;
    std::size_t bytes = 0;             ///< size in bytes, as declared in the shader
    std::vector<std::string> members;  ///< only for storage blocks: names of the members, such as "name"
                                       ///< for "name[]" and for "name[].x"
  };
  std::vector<Number> numbers;
  std::vector<View> views;
  std::vector<Block> blocks;

  [[nodiscard]] static ProgramInterface of(GLuint program);
};

/// True if the C++ resource `given` refers to the sampler or image `name`. An array of
/// glsl/common/memory.glsl or words.glsl has up to one sampler, nameTexels, and up to one image, nameImage.
[[nodiscard]] bool namesView(std::string_view given, std::string_view name);

}  // namespace simreel::gl
