#include "sim/core/state_hash.hpp"

#include "gl/context.hpp"
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

gl::Defines defines() {
  return grouped() ? gl::Defines{{"GROUPED", "1"}} : gl::Defines{};
}

}  // namespace

StateWords::StateWords(const StateArray& array) : array_(array) {
  if (array.planes.count == 0) view_ = gl::Texture::view("state words", GL_RGBA32UI, *array.buffer);
}

void StateWords::bind(const gl::Program& program) const {
  if (array_.planes.count == 0) return view_.bind(shader::wordsBinding);
  array_.planes.part.bindStorage(shader::planesBinding);
  program.set("planes", array_.planes.count);
}

StateHash::StateHash() : program_(gl::Program::compute("common/state_hash.comp", defines())) {}

void StateHash::add(const gl::Buffer& array, std::size_t number, const gl::Buffer& sums,
                    std::size_t place) const {
  add(StateArray{"", &array}, number, sums, place);
}

void StateHash::add(const StateArray& array, std::size_t number, const gl::Buffer& sums,
                    std::size_t place) const {
  const int texels = static_cast<int>(array.elements());
  if (array.planes.count > 0 && !ofPlanes_) {
    gl::Defines with = defines();
    with.emplace_back("PLANES", "1");
    ofPlanes_ = gl::Program::compute("common/state_hash.comp", with);
  }
  const gl::Program& program = array.planes.count > 0 ? ofPlanes_ : program_;
  const StateWords words(array);
  words.bind(program);
  sums.bindStorage(shader::sumsBinding);
  program.set("texels", texels);
  program.set("slot", static_cast<int>(place));
  program.set("salt", static_cast<unsigned>(number + 1) * 0x9e3779b9U);
  if (grouped()) {
    const int invocations = std::min((texels - 1) / groupSize + 1, maxGroups) * groupSize;
    program.set("invocations", invocations);
    program.dispatch(invocations);
  } else {
    program.set("perInvocation", texelsPerInvocation);
    program.dispatch((texels - 1) / texelsPerInvocation + 1);
  }
}

std::string StateHash::text(const glm::uvec4& hash) {
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", hash.x, hash.y, hash.z, hash.w);
}

}  // namespace simreel::sim
