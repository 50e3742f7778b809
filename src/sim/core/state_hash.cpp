#include "sim/core/state_hash.hpp"

#include "gl/context.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

struct StateHashKernel {
  static constexpr auto file = "common/state_hash.comp";
  struct Variant {
    gl::Flag<"GROUPED"> grouped;
    gl::Flag<"PLANES"> planes;
  };
  StateWordsPart state;
  gl::Uniform<"slot", int> slot;
  gl::Uniform<"salt", unsigned> salt;
  gl::Uniform<"invocations", int> invocations;
  gl::Uniform<"perInvocation", int> perInvocation;
  gl::InOut<"SumBlock"> sums;
};

namespace {

constexpr int texelsPerInvocation = 64;  // Number of texels that one invocation hashes if the state is read
                                         // through texel views.
constexpr int groupSize = 256;           // Workgroup size if the state is read through storage buffers.
constexpr int maxGroups = 1024;

bool grouped() {
  return gl::memoryPath() == gl::MemoryPath::storage;
}

}  // namespace

StateWords::StateWords(const StateArray& array) : array_(array) {
  if (array.planes.count == 0) view_ = gl::Texture::view("state words", GL_RGBA32UI, *array.buffer);
}

StateWordsPart StateWords::part() const {
  StateWordsPart part{.texels = static_cast<int>(array_.elements()),
                      .planes = array_.planes.count,
                      .words = view_,
                      .planeWords = {}};
  if (array_.planes.count > 0) part.planeWords = array_.planes.part;
  return part;
}

StateHash::StateHash() : kernel_(gl::Defines(), {.grouped = grouped(), .planes = false}) {}

void StateHash::add(const gl::Buffer& array, std::size_t number, const gl::Buffer& sums,
                    std::size_t place) const {
  add(StateArray{"", &array}, number, sums, place);
}

void StateHash::add(const StateArray& array, std::size_t number, const gl::Buffer& sums,
                    std::size_t place) const {
  const int texels = static_cast<int>(array.elements());
  const bool planes = array.planes.count > 0;
  if (planes && !ofPlanes_)
    ofPlanes_ = gl::Kernel<StateHashKernel>(gl::Defines(), {.grouped = grouped(), .planes = true});
  const StateWords words(array);
  const int each = grouped() ? groupSize : texelsPerInvocation, parts = (texels - 1) / each + 1;
  const int invocations = grouped() ? std::min(parts, maxGroups) * groupSize : parts;
  (planes ? ofPlanes_ : kernel_)
      .dispatch(invocations, {.state = words.part(),
                              .slot = static_cast<int>(place),
                              .salt = static_cast<unsigned>(number + 1) * 0x9e3779b9U,
                              .invocations = invocations,
                              .perInvocation = texelsPerInvocation,
                              .sums = sums});
}

std::string StateHash::text(const glm::uvec4& hash) {
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", hash.x, hash.y, hash.z, hash.w);
}

}  // namespace simreel::sim
