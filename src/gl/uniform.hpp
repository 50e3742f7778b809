#pragma once
#include <string>
#include <string_view>
#include <variant>

#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::gl {

/// A uniform's value, and its place in a linked program once that has been looked up.
struct UniformSlot {
  using Value = std::variant<int, unsigned, float, glm::ivec2, glm::ivec4, glm::vec2, glm::vec3, glm::vec4,
                             glm::mat4>;

  std::string name;
  Value value;
  GLint location = -1;   ///< -1: the driver has optimised it away
  bool located = false;  ///< `location` has been looked up

  /// True if it is `whole`, an element of it ("a[0]") or a member ("a.b").
  [[nodiscard]] bool isPartOf(std::string_view whole) const {
    return name.starts_with(whole) &&
           (name.size() == whole.size() || name[whole.size()] == '[' || name[whole.size()] == '.');
  }
  /// Looks its place up in a linked program, once. False where the driver has optimised it away.
  bool locate(GLuint program);
  /// Sets it in a linked program.
  void putInto(GLuint program);
};

}  // namespace simreel::gl
