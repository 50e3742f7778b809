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

/// A uniform's value, and its location in a linked program.
struct UniformSlot {
  using Value = std::variant<int, unsigned, float, glm::ivec2, glm::ivec4, glm::vec2, glm::vec3, glm::vec4,
                             glm::mat4>;

  std::string name;
  Value value;
  GLint location = -1;   ///< -1 if the driver optimised the uniform away
  bool located = false;  ///< true if `location` has been looked up

  /// True if the uniform is `whole`, an element of it ("a[0]") or a member of it ("a.b").
  [[nodiscard]] bool isPartOf(std::string_view whole) const {
    return name.starts_with(whole) &&
           (name.size() == whole.size() || name[whole.size()] == '[' || name[whole.size()] == '.');
  }
  /// Looks up the location in a linked program at the first call. Returns false if the driver optimised the
  /// uniform away.
  bool locate(GLuint program);
  /// Sets the value in a linked program.
  void putInto(GLuint program);
};

}  // namespace simreel::gl
