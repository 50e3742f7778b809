#include "gl/kernel/kernel_base.hpp"

#include "gl/context.hpp"
#include "gl/kernel/declared.hpp"
#include "gl/limits.hpp"
#include "gl/program.hpp"
#include "gl/rehearsal.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <unordered_set>
#include <variant>

namespace simreel::gl {

namespace {

/// Sets `value` to the bytes at `now`, which have the same type. Returns false if nothing changed. The
/// comparison is bitwise: -0 differs from 0, and a NaN equals itself.
bool change(UniformSlot::Value& value, const void* now) {
  return std::visit(
      [&](auto& one) {
        if (std::memcmp(&one, now, sizeof one) == 0) return false;
        std::memcpy(&one, now, sizeof one);
        return true;
      },
      value);
}

/// Returns the part of a name before the first '.' or '[': "a" for "a", "a.b" and "a[1]".
std::string_view rootOf(std::string_view name) {
  return name.substr(0, name.find_first_of("[."));
}

/// True if the uniform `given` is the active uniform `name` or an element of it.
bool namesNumber(std::string_view given, std::string_view name) {
  return given.starts_with(name) && (given.size() == name.size() || given[name.size()] == '[');
}

bool namesBlock(std::string_view given, const ProgramInterface::Block& block) {
  return block.name == given || std::ranges::find(block.members, given) != block.members.end();
}

GLbitfield barrierOf(bool storage, bool uniformBlock, bool image) {
  if (storage) return GL_SHADER_STORAGE_BARRIER_BIT;
  if (uniformBlock) return GL_UNIFORM_BARRIER_BIT;
  return image ? GL_SHADER_IMAGE_ACCESS_BARRIER_BIT : GL_TEXTURE_FETCH_BARRIER_BIT;
}

AccessLog::Memory memoryOf(const Resource& resource) {
  if (resource.buffer() != 0) return {resource.buffer(), false};
  const Texture& texture = *resource.texture();
  return texture.buffer() != 0 ? AccessLog::Memory{texture.buffer(), false}
                               : AccessLog::Memory{texture.name(), true};
}

GLenum imageAccess(const Resource& resource, Access access) {
  // If an array is bound as a buffer and a texel view, shaders read it through the image and write it
  // through the block.
  if (resource.buffer() != 0 || access == Access::read) return GL_READ_ONLY;
  return access == Access::write ? GL_WRITE_ONLY : GL_READ_WRITE;
}

/// True at the first call for each interface, so that each shader file is checked once.
bool firstCheck(const KernelNames& names) {
  static std::unordered_set<const KernelNames*> checked;
  return checked.insert(&names).second;
}

}  // namespace

std::vector<const KernelNames*>& kernelInterfaces() {
  static std::vector<const KernelNames*> all;
  return all;
}

void checkDeclared(const KernelNames& names, const std::string& text) {
  const auto declared = declaredNames(text);
  const auto check = [&](bool found, const char* what, const char* name) {
    if (!found)
      fail(ExitCode::device,
           "glsl/{} declares no {} \"{}\", which the program gives it; check its spelling", names.file,
           what, name);
  };
  for (const KernelNames::Number& number : names.numbers)
    check(declared.contains(rootOf(number.name)), "uniform", number.name);
  for (const KernelNames::Memory& memory : names.memories)
    check(declared.contains(std::string_view(memory.name)), "block, image or sampler", memory.name);
  for (const char* define : names.defines) check(mentions(text, define), "name for the define", define);
}

KernelBase::KernelBase(const KernelNames& names, const Defines& defines, const char* text, bool generated)
    : names_(names), text_(text != nullptr ? text : ""), generated_(generated) {
  linked_ = LinkedProgram::of(names.file, {{GL_COMPUTE_SHADER, names.file,
                                            text_.empty() ? loadShader(names.file, defines)
                                                          : loadShaderText(names.file, text_, defines)}});
  for (const KernelNames::Number& number : names.numbers) numbers_.push_back({number.name, number.zero});
}

void KernelBase::missing(const char* what, const std::string& name) const {
  fail(ExitCode::device,
       "glsl/{} reads the {} \"{}\", which the program does not give it; check its spelling", names_.file,
       what, name);
}

void KernelBase::addSlots(std::size_t memory) {
  using enum Slot::Kind;
  const KernelNames::Memory& named = names_.memories[memory];
  for (const auto& block : linked_->interface().blocks) {
    if (!namesBlock(named.name, block)) continue;
    if (named.blockBytes != 0 && block.bytes != named.blockBytes)
      fail(ExitCode::device, "the block \"{}\" of glsl/{} has {} bytes, the program gives it {}",
           block.name, names_.file, block.bytes, named.blockBytes);
    slots_.push_back({memory, block.storage ? storage : uniformBlock, block.binding});
  }
  for (const auto& view : linked_->interface().views)
    if (namesView(named.name, view.name))
      slots_.push_back({memory, view.image ? image : texture, view.unit});
}

void KernelBase::checkActive() const {
  const auto& interface = linked_->interface();
  const auto& numbers = names_.numbers;
  const auto& memories = names_.memories;
  for (const auto& number : interface.numbers)
    if (std::ranges::none_of(numbers, [&](const auto& one) { return namesNumber(one.name, number.name); }))
      missing("uniform", number.name);
  for (const auto& block : interface.blocks)
    if (std::ranges::none_of(memories, [&](const auto& one) { return namesBlock(one.name, block); }))
      missing("block", block.name);
  for (const auto& view : interface.views)
    if (std::ranges::none_of(memories, [&](const auto& one) { return namesView(one.name, view.name); }))
      missing(view.image ? "image" : "sampler", view.name);
}

void KernelBase::checkTypes() const {
  for (const auto& number : names_.numbers)
    for (const auto& [name, type] : linked_->interface().numbers)
      // Drivers accept an int value for a bool uniform.
      if (namesNumber(number.name, name) && type != number.type &&
          !(type == GL_BOOL && number.type == GL_INT))
        fail(ExitCode::device, "the uniform \"{}\" of glsl/{} has another type than the program gives it",
             name, names_.file);
}

void KernelBase::resolve() {
  if (resolved_) return;
  linked_->link();
  if (generated_)
    text_.clear();
  else if (!text_.empty())
    checkDeclared(names_, loadShaderText(names_.file, text_, {}).text);
  else if (firstCheck(names_))
    checkDeclared(names_, loadShader(names_.file, {}).text);
  checkActive();
  checkTypes();
  slots_.clear();
  for (std::size_t i = 0; i < names_.memories.size(); ++i) addSlots(i);
  for (UniformSlot& number : numbers_) number.locate(linked_->name());
  resolved_ = true;
}

bool KernelBase::rehearsed(const Given& given) const {
  if (!Rehearsal::now()) return false;
  BoundViews views;
  if (std::ranges::any_of(names_.memories, &KernelNames::Memory::ambient)) views = Rehearsal::bound();
  for (std::size_t i = 0; i < given.memories.size(); ++i) {
    const Resource& resource = *given.memories[i];
    if (const Texture* texture = resource.texture())
      views.named[names_.memories[i].name] = {texture->shape(), resource.level(),
                                              imageAccess(resource, names_.memories[i].access),
                                              resource.format()};
  }
  return Rehearsal::note(linked_, views);
}

void KernelBase::setNumbers(const Given& given) {
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i].location < 0) continue;
    if (!given.numbers[i].given) missing("uniform", numbers_[i].name);
    if (change(numbers_[i].value, given.numbers[i].value) && linked_->user() == this)
      numbers_[i].putInto(linked_->name());
  }
  if (linked_->user() != this) linked_->giveTo(this, numbers_);
}

AccessLog::AccessKind KernelBase::accessOf(const Slot& slot, const Resource& resource) const {
  using enum AccessLog::AccessKind;
  const Access access = names_.memories[slot.memory].access;
  if (access == Access::together) return together;
  const bool stores =
      slot.kind == Slot::Kind::storage || (slot.kind == Slot::Kind::image && resource.buffer() == 0);
  return access != Access::read && stores ? write : read;
}

void KernelBase::bind(const Slot& slot, const Resource& resource) const {
  using enum Slot::Kind;
  const auto offset = static_cast<GLintptr>(resource.offset());
  const auto bytes = static_cast<GLsizeiptr>(resource.bytes());
  switch (slot.kind) {
    case storage:
    case uniformBlock: {
      const GLenum target = slot.kind == storage ? GL_SHADER_STORAGE_BUFFER : GL_UNIFORM_BUFFER;
      if (bytes == 0)
        glBindBufferBase(target, slot.unit, resource.buffer());
      else
        glBindBufferRange(target, slot.unit, resource.buffer(), offset, bytes);
      break;
    }
    case texture:
      glBindTextureUnit(slot.unit, resource.texture()->name());
      break;
    case image:
      glBindImageTexture(slot.unit, resource.texture()->name(), resource.level(), GL_FALSE, 0,
                         imageAccess(resource, names_.memories[slot.memory].access), resource.format());
  }
}

void KernelBase::prepare(const Given& given, GLbitfield more) {
  using enum Slot::Kind;
  GLbitfield barriers = more;
  const auto staysBound = [&](const Slot& slot) {
    return names_.memories[slot.memory].ambient && given.memories[slot.memory]->empty();
  };
  for (const Slot& slot : slots_) {
    if (staysBound(slot)) continue;
    const Resource& resource = *given.memories[slot.memory];
    const bool view = slot.kind == texture || slot.kind == image;
    if (view ? resource.texture() == nullptr : resource.buffer() == 0)
      missing(view ? "image or sampler" : "block", names_.memories[slot.memory].name);
    barriers |= AccessLog::needed(
        memoryOf(resource), barrierOf(slot.kind == storage, slot.kind == uniformBlock, slot.kind == image),
        accessOf(slot, resource));
  }
  setNumbers(given);
  if (barriers != 0) AccessLog::barrier(barriers);
  for (const Slot& slot : slots_) {
    if (staysBound(slot)) continue;
    const Resource& resource = *given.memories[slot.memory];
    bind(slot, resource);
    AccessLog::note(memoryOf(resource), accessOf(slot, resource));
  }
  glUseProgram(linked_->name());
}

void KernelBase::dispatch(int x, int y, const Given& given) {
  if (x <= 0 || y <= 0 || rehearsed(given)) return;
  resolve();
  const GLint* size = linked_->groupSize();
  const GLint groupsX = (x - 1) / size[0] + 1;
  const GLint groupsY = (y - 1) / size[1] + 1;
  checkGroups(linked_->label(), groupsX, groupsY, limits());
  dispatchGroups(static_cast<GLuint>(groupsX), static_cast<GLuint>(groupsY), 1, given);
}

void KernelBase::dispatchGroups(GLuint x, GLuint y, GLuint z, const Given& given) {
  if (rehearsed(given)) return;
  resolve();
  prepare(given, 0);
  linked_->dispatch([&] { glDispatchCompute(x, y, z); });
}

void KernelBase::dispatchIndirect(const Buffer& commands, std::size_t offset, const Given& given) {
  if (rehearsed(given)) return;
  // A command without groups must not cause a compilation (as in Program::dispatchIndirect).
  if (softwareDriver() && !linked_->dispatched()) {
    std::array<GLuint, 3> groups{};
    commands.read(offset, std::as_writable_bytes(std::span(groups)));
    if (groups[0] == 0 || groups[1] == 0 || groups[2] == 0) return;
  }
  resolve();
  const AccessLog::Memory memory{commands.name(), false};
  prepare(given, AccessLog::needed(memory, GL_COMMAND_BARRIER_BIT, AccessLog::AccessKind::read));
  AccessLog::note(memory, AccessLog::AccessKind::read);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands.name());
  linked_->dispatch([&] { glDispatchComputeIndirect(static_cast<GLintptr>(offset)); });
}

}  // namespace simreel::gl
