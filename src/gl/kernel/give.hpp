#pragma once
#include "gl/kernel/fields.hpp"
#include "gl/kernel/visit.hpp"
#include "gl/program.hpp"

#include <type_traits>

namespace simreel::gl {

/// Binds a resource where a linked program has a sampler or a block of that name, if it has one.
void bindByName(GLuint program, const char* name, const Resource& resource);

/// Gives fields, of which kernels have the same, to a program that draws. Names that the driver dropped are
/// ignored.
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

/// Program::checkUniformBlock for each block of the fields whose C++ struct is known.
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
