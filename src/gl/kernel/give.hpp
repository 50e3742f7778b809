#pragma once
#include "gl/kernel/fields.hpp"
#include "gl/kernel/visit.hpp"
#include "gl/program.hpp"

#include <type_traits>

namespace simreel::gl {

/// Binds a resource to the sampler or block of that name. Does nothing if a linked program has no such
/// sampler or block.
void bindByName(GLuint program, const char* name, const Resource& resource);

/// Passes kernel fields (uniforms, resources) to a graphics program. Names that the driver optimised away
/// are ignored.
template <class Fields>
void give(const Program& program, const Fields& fields) {
  visitFields(fields, [&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_base_of_v<Resource, Field>)
      bindByName(program.name(), Field::name, field);
    else if (field.given)
      program.set(Field::name, field.value);
  });
}

/// Calls Program::checkUniformBlock() for each uniform block among the fields that has a corresponding C++
/// struct.
template <class Fields>
void checkBlocks(const Program& program) {
  const Fields none{};
  visitFields(none, [&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_base_of_v<Resource, Field>)
      if constexpr (Field::blockBytes != 0) program.checkUniformBlock(Field::name, Field::blockBytes);
  });
}

}  // namespace simreel::gl
