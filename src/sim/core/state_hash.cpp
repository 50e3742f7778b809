#include "sim/core/state_hash.hpp"

#include "gl/context.hpp"
#include "gl/texture.hpp"
#include "glsl/common/cpp.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int texelsPerInvocation = 64;  // of the texel path
constexpr int groupSize = 256;           // of the storage path
constexpr int maxGroups = 1024;

bool grouped() {
  return gl::memoryPath() == gl::MemoryPath::storage;
}

}  // namespace

StateHash::StateHash()
    : program_(gl::Program::compute("common/state_hash.comp",
                                    grouped() ? gl::Defines{{"GROUPED", "1"}} : gl::Defines{})) {}

void StateHash::add(const gl::Buffer& array, std::size_t number, const gl::Buffer& sums,
                    std::size_t place) const {
  const gl::Texture words = gl::Texture::view("state words", GL_RGBA32UI, array);
  const int texels = static_cast<int>(array.bytes() / 16);
  words.bind(shader::wordsBinding);
  sums.bindStorage(shader::sumsBinding);
  program_.set("texels", texels);
  program_.set("slot", static_cast<int>(place));
  program_.set("salt", static_cast<unsigned>(number + 1) * 0x9e3779b9U);
  if (grouped()) {
    const int invocations = std::min((texels - 1) / groupSize + 1, maxGroups) * groupSize;
    program_.set("invocations", invocations);
    program_.dispatch(invocations);
  } else {
    program_.set("perInvocation", texelsPerInvocation);
    program_.dispatch((texels - 1) / texelsPerInvocation + 1);
  }
}

std::string StateHash::text(const glm::uvec4& hash) {
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", hash.x, hash.y, hash.z, hash.w);
}

}  // namespace simreel::sim
