#pragma once
#include "gl/handle.hpp"
#include "gl/limits.hpp"
#include "gl/shader_source.hpp"

#include <cstddef>
#include <memory>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::gl {

class Buffer;
class LinkedProgram;

/// A program of the driver with uniform values of its own. Programs of one source share what the driver
/// makes of it (LinkedProgram), which happens at the first use: compile and link errors throw
/// UserError(device) there, with file:line of the original shader files.
class Program {
 public:
  Program();
  ~Program();
  Program(Program&&) noexcept;
  Program& operator=(Program&&) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Throws UserError(device) where a file is missing.
  static Program compute(const std::string& path, const Defines& defines = {});
  /// Of a text in place of a file below glsl/, which it may include: for tests of what those files define.
  static Program computeText(const std::string& name, const std::string& text, const Defines& defines = {});
  static Program graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines = {});

  /// False for a default-constructed Program.
  explicit operator bool() const { return own_ != nullptr; }

  /// Makes it the current program, with its uniform values. The first use throws UserError(device) where
  /// the shader reads a uniform that has not been set.
  void use() const;
  /// Runs at least `items` (or x by y) invocations; shaders guard the rest. At most
  /// GL_MAX_COMPUTE_WORK_GROUP_COUNT groups in each direction: beyond it, UserError(device).
  void dispatch(int items) const { dispatch(items, 1); }
  void dispatch(int x, int y) const;
  /// Runs x by y by z work groups.
  void dispatchGroups(GLuint x, GLuint y, GLuint z) const;
  /// Runs as many work groups as the command at byte `offset` of `commands` says, which is behind a
  /// GL_COMMAND_BARRIER_BIT. On software drivers a kernel is not compiled for a command without groups.
  void dispatchIndirect(const Buffer& commands, std::size_t offset) const;

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

  /// Stops the program, at its first use, unless the uniform block has exactly `bytes` bytes, as the C++
  /// struct has.
  void checkUniformBlock(const char* block, std::size_t bytes) const;

  /// The driver's name of it, linked; 0 for a default-constructed Program.
  [[nodiscard]] GLuint name() const;

 private:
  struct Own;
  explicit Program(std::shared_ptr<LinkedProgram> linked);
  void link() const;
  template <class T>
  void assign(const char* uniform, const T& value) const;

  std::unique_ptr<Own> own_;
};

/// Throws UserError(device) where a dispatch of x by y work groups is beyond the limits.
void checkGroups(const std::string& label, int x, int y, const Limits& allowed);

}  // namespace simreel::gl
