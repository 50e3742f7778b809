#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Interface of a linked program, as the driver reports it; without what the driver dropped.
struct ProgramInterface {
  /// A uniform outside blocks: "a", "a.b"; of an array of numbers "a", whose elements follow each other.
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
    std::size_t bytes = 0;             ///< as the shader declares it
    std::vector<std::string> members;  ///< of storage blocks: "name" of "name[]" and of "name[].x"
  };
  std::vector<Number> numbers;
  std::vector<View> views;
  std::vector<Block> blocks;

  [[nodiscard]] static ProgramInterface of(GLuint program);
};

/// True where the resource called `given` in C++ is the sampler or image `name`: an array of
/// glsl/common/memory.glsl and words.glsl has up to one of each, nameTexels and nameImage.
[[nodiscard]] bool namesView(std::string_view given, std::string_view name);

}  // namespace simreel::gl
