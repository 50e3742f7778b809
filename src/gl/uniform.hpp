#pragma once
#include <string>
#include <variant>

#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::gl {

/// A uniform's value, and its place in a linked program once that has been looked up.
struct Uniform {
  using Value = std::variant<int, unsigned, float, glm::ivec2, glm::ivec4, glm::vec2, glm::vec3, glm::vec4,
                             glm::mat4>;

  std::string name;
  Value value;
  GLint location = -1;   ///< -1: the driver has optimised it away
  bool located = false;  ///< `location` has been looked up

  /// Sets it in a linked program.
  void putInto(GLuint program);
  /// The same uniform with zeros, as it is after linking.
  [[nodiscard]] Uniform zero() const;
};

}  // namespace simreel::gl
