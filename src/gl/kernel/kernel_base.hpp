#pragma once
#include "gl/access_log.hpp"
#include "gl/kernel/fields.hpp"
#include "gl/linked_program.hpp"
#include "gl/shader_source.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace simreel::gl {

/// Run-time description of the interface of a kernel (gl/kernel/kernel.hpp).
struct KernelNames {
  struct Number {
    const char* name;
    GLenum type;
    UniformSlot::Value zero;  ///< zero value of the number's type
  };
  struct Memory {
    const char* name;
    Access access;
    std::size_t blockBytes;  ///< size (bytes) of a uniform block; 0 if unknown
    bool ambient;            ///< true if the resource may stay bound between dispatches (gl::Ambient)
  };
  const char* file = "";
  std::vector<Number> numbers;
  std::vector<Memory> memories;
  std::vector<const char*> defines;
  std::vector<Defines> (*variants)() = nullptr;  ///< returns every possible set of defines
};

/// Returns the interfaces of all kernels of the program, for tools and tests.
[[nodiscard]] std::vector<const KernelNames*>& kernelInterfaces();
/// Throws UserError(device) that names the file, unless `text` declares all names of `names`.
void checkDeclared(const KernelNames& names, const std::string& text);

/// The part of a Kernel that does not depend on the type of its interface.
class KernelBase {
 public:
  /// Values of one dispatch, in the order of KernelNames.
  struct Given {
    std::span<const GivenNumber> numbers;
    std::span<const Resource* const> memories;
  };

  /// `text`: if not null, replaces the shader file. `generated`: true if `text` may lack declarations of
  /// the interface.
  KernelBase(const KernelNames& names, const Defines& defines, const char* text = nullptr,
             bool generated = false);
  ~KernelBase() { linked_->leave(this); }
  KernelBase(KernelBase&&) = delete;
  KernelBase(const KernelBase&) = delete;
  KernelBase& operator=(KernelBase&&) = delete;
  KernelBase& operator=(const KernelBase&) = delete;

  void dispatch(int x, int y, const Given& given);
  void dispatchGroups(GLuint x, GLuint y, GLuint z, const Given& given);
  void dispatchIndirect(const Buffer& commands, std::size_t offset, const Given& given);

 private:
  /// Binding point of a resource in the linked program.
  struct Slot {
    enum class Kind { storage, uniformBlock, texture, image };
    std::size_t memory = 0;  ///< index into KernelNames::memories
    Kind kind = Kind::storage;
    GLuint unit = 0;
  };

  [[nodiscard]] bool rehearsed(const Given& given) const;
  /// Links the program at the first use, and looks up the locations of all names.
  void resolve();
  void addSlots(std::size_t memory);
  void checkActive() const;
  void checkTypes() const;
  /// Issues the required barriers (`more`, and those for the given resources), then sets uniforms and binds
  /// resources.
  void prepare(const Given& given, GLbitfield more);
  void setNumbers(const Given& given);
  void bind(const Slot& slot, const Resource& resource) const;
  [[nodiscard]] AccessLog::AccessKind accessOf(const Slot& slot, const Resource& resource) const;
  [[noreturn]] void missing(const char* what, const std::string& name) const;

  const KernelNames& names_;
  std::string text_;
  bool generated_;
  std::shared_ptr<LinkedProgram> linked_;
  bool resolved_ = false;
  std::vector<UniformSlot> numbers_;
  std::vector<Slot> slots_;
};

}  // namespace simreel::gl
