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

/// An OpenGL program with separate uniform values. Programs with the same source share one LinkedProgram,
/// which is compiled and linked at the first use. Compile and link errors then throw UserError(device) with
/// file:line of the original shader files.
class Program {
 public:
  Program();
  ~Program();
  Program(Program&&) noexcept;
  Program& operator=(Program&&) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Creates a compute program. Throws UserError(device) if a file is missing.
  static Program compute(const std::string& path, const Defines& defines = {});
  /// Creates a program from a text instead of a file. The text may include files below glsl/. Used by tests
  /// of such files.
  static Program computeText(const std::string& name, const std::string& text, const Defines& defines = {});
  static Program graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines = {});

  /// False for a default-constructed Program.
  explicit operator bool() const { return own_ != nullptr; }

  /// Makes the program current and sets its uniform values. The first use throws UserError(device) if the
  /// shader reads a uniform that has not been set.
  void use() const;
  /// Runs at least `items` (or x by y) invocations. Shaders must ignore the surplus invocations. Throws
  /// UserError(device) if a dimension needs more than GL_MAX_COMPUTE_WORK_GROUP_COUNT groups.
  void dispatch(int items) const { dispatch(items, 1); }
  void dispatch(int x, int y) const;
  /// Runs x by y by z workgroups.
  void dispatchGroups(GLuint x, GLuint y, GLuint z) const;
  /// Runs as many workgroups as the indirect command at byte `offset` of `commands` says. The caller must
  /// first issue GL_COMMAND_BARRIER_BIT. On software drivers, a command without groups does not cause a
  /// compilation.
  void dispatchIndirect(const Buffer& commands, std::size_t offset) const;

  /// Sets a uniform by name. Names that the driver optimised away are ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, unsigned value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::ivec2& value) const;
  void set(const char* uniform, const glm::ivec4& value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

  /// Checks at the first use that the uniform block has exactly `bytes` bytes, the size of the C++ struct.
  /// If not, the first use throws.
  void checkUniformBlock(const char* block, std::size_t bytes) const;

  /// Returns the OpenGL name of the linked program, or 0 for a default-constructed Program.
  [[nodiscard]] GLuint name() const;

 private:
  struct Own;
  explicit Program(std::shared_ptr<LinkedProgram> linked);
  void link() const;
  template <class T>
  void assign(const char* uniform, const T& value) const;

  std::unique_ptr<Own> own_;
};

/// Throws UserError(device) if a dispatch of x by y workgroups exceeds the limits.
void checkGroups(const std::string& label, int x, int y, const Limits& allowed);

}  // namespace simreel::gl
