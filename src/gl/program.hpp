#pragma once
#include "gl/handle.hpp"
#include "gl/limits.hpp"
#include "gl/shader_source.hpp"

#include <map>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::gl {

/// A linked program. Compile and link errors throw UserError(device) with file:line of the original
/// shader files.
class Program {
 public:
  Program() = default;
  static Program compute(const std::string& path, const Defines& defines = {});
  /// Of a text in place of a file below glsl/, which it may include: for tests of what those files define.
  static Program computeText(const std::string& name, const std::string& text, const Defines& defines = {});
  static Program graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines = {});

  void use() const { glUseProgram(name()); }
  /// Runs at least `items` (or x by y) invocations; shaders guard the rest. At most
  /// GL_MAX_COMPUTE_WORK_GROUP_COUNT groups in each direction: beyond it, UserError(device).
  void dispatch(int items) const { dispatch(items, 1); }
  void dispatch(int x, int y) const;

  /// Uniforms by name; a name the driver optimised away is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, unsigned value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::ivec2& value) const;
  void set(const char* uniform, const glm::ivec4& value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

  /// Stops the program unless the uniform block has exactly `bytes` bytes, as the C++ struct has.
  void checkUniformBlock(const char* block, std::size_t bytes) const;

  [[nodiscard]] GLuint name() const { return handle_.get(); }

 private:
  [[nodiscard]] GLint location(const char* uniform) const;
  void link(const std::string& label);
  static Program computeFrom(const std::string& label, const ShaderSource& source);

  Handle<DeleteProgram> handle_;
  std::string label_;
  GLint groupSize_[3] = {1, 1, 1};
  mutable std::map<std::string, GLint, std::less<>> locations_;
};

/// Throws UserError(device) where a dispatch of x by y work groups is beyond the limits.
void checkGroups(const std::string& label, int x, int y, const Limits& allowed);

}  // namespace simreel::gl
