#include "gl/program_interface.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace simreel::gl {

namespace {

std::string nameOf(GLuint program, GLenum interface, GLuint index) {
  std::array<char, 256> name{};
  GLsizei length = 0;
  glGetProgramResourceName(program, interface, index, static_cast<GLsizei>(name.size()), &length,
                           name.data());
  return {name.data(), static_cast<std::size_t>(length)};
}

template <std::size_t count>
std::array<GLint, count> propertiesOf(GLuint program, GLenum interface, GLuint index,
                                      const std::array<GLenum, count>& wanted) {
  std::array<GLint, count> got{};
  constexpr auto size = static_cast<GLsizei>(count);
  glGetProgramResourceiv(program, interface, index, size, wanted.data(), size, nullptr, got.data());
  return got;
}

GLuint countOf(GLuint program, GLenum interface) {
  GLint count = 0;
  glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  return static_cast<GLuint>(count);
}

bool isNumber(GLenum type) {
  constexpr GLenum numbers[] = {
      GL_INT,        GL_INT_VEC2,          GL_INT_VEC3,          GL_INT_VEC4,
      GL_FLOAT,      GL_FLOAT_VEC2,        GL_FLOAT_VEC3,        GL_FLOAT_VEC4,
      GL_BOOL,       GL_UNSIGNED_INT,      GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3,
      GL_FLOAT_MAT3, GL_UNSIGNED_INT_VEC4, GL_FLOAT_MAT4};
  return std::ranges::find(numbers, type) != std::end(numbers);
}

bool isImage(GLenum type) {
  constexpr GLenum images[] = {GL_IMAGE_2D,      GL_INT_IMAGE_2D,     GL_UNSIGNED_INT_IMAGE_2D,
                               GL_IMAGE_BUFFER,  GL_INT_IMAGE_BUFFER, GL_UNSIGNED_INT_IMAGE_BUFFER,
                               GL_IMAGE_2D_ARRAY};
  return std::ranges::find(images, type) != std::end(images);
}

void addUniforms(ProgramInterface& all, GLuint program) {
  for (GLuint i = 0; i < countOf(program, GL_UNIFORM); ++i) {
    const auto [type, block, location] =
        propertiesOf<3>(program, GL_UNIFORM, i, {GL_TYPE, GL_BLOCK_INDEX, GL_LOCATION});
    if (block >= 0) continue;
    std::string name = nameOf(program, GL_UNIFORM, i);
    if (name.ends_with("[0]")) name.resize(name.size() - 3);
    if (isNumber(static_cast<GLenum>(type))) {
      all.numbers.push_back({name, static_cast<GLenum>(type)});
      continue;
    }
    GLint unit = 0;
    glGetUniformiv(program, location, &unit);
    all.views.push_back({name, static_cast<GLuint>(unit), isImage(static_cast<GLenum>(type))});
  }
}

void addMembers(ProgramInterface::Block& block, GLuint program, GLuint index) {
  const auto count = propertiesOf<1>(program, GL_SHADER_STORAGE_BLOCK, index, {GL_NUM_ACTIVE_VARIABLES})[0];
  std::vector<GLint> members(static_cast<std::size_t>(count));
  constexpr GLenum wanted = GL_ACTIVE_VARIABLES;
  glGetProgramResourceiv(program, GL_SHADER_STORAGE_BLOCK, index, 1, &wanted, count, nullptr,
                         members.data());
  for (const GLint member : members) {
    const std::string name = nameOf(program, GL_BUFFER_VARIABLE, static_cast<GLuint>(member));
    block.members.push_back(name.substr(0, name.find('[')));
  }
}

void addBlocks(ProgramInterface& all, GLuint program, bool storage) {
  const GLenum interface = storage ? GL_SHADER_STORAGE_BLOCK : GL_UNIFORM_BLOCK;
  for (GLuint i = 0; i < countOf(program, interface); ++i) {
    const auto [binding, bytes] =
        propertiesOf<2>(program, interface, i, {GL_BUFFER_BINDING, GL_BUFFER_DATA_SIZE});
    all.blocks.push_back({nameOf(program, interface, i),
                          static_cast<GLuint>(binding),
                          storage,
                          static_cast<std::size_t>(bytes),
                          {}});
    if (storage) addMembers(all.blocks.back(), program, i);
  }
}

/// Throws std::logic_error if two blocks of one kind share a binding point, since both would access the
/// buffer that was bound last.
void checkBindings(const std::vector<ProgramInterface::Block>& blocks) {
  std::map<std::pair<bool, GLuint>, std::string_view> names;
  for (const ProgramInterface::Block& block : blocks) {
    const auto [other, free] = names.emplace(std::pair(block.storage, block.binding), block.name);
    if (free) continue;
    throw std::logic_error(fmt::format("blocks {} and {} of a shader share binding point {}", other->second,
                                       block.name, block.binding));
  }
}

}  // namespace

ProgramInterface ProgramInterface::of(GLuint program) {
  ProgramInterface all;
  addUniforms(all, program);
  addBlocks(all, program, true);
  addBlocks(all, program, false);
  checkBindings(all.blocks);
  return all;
}

bool namesView(std::string_view given, std::string_view name) {
  if (!name.starts_with(given)) return false;
  const std::string_view rest = name.substr(given.size());
  return rest.empty() || rest == "Texels" || rest == "Image";
}

}  // namespace simreel::gl
