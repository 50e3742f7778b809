#include "draw/instances/glow_sums.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace simreel::draw {

namespace {

gl::Buffer sumsFor(glm::ivec2 size) {
  const std::int64_t bytes = std::int64_t{24} * size.x * size.y;
  if (bytes > gl::limits().storageBlockBytes)
    fail(ExitCode::device,
         "a picture of {}x{} pixels with glows needs {} bytes in one buffer, this device allows {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make the picture smaller",
         size.x, size.y, bytes, gl::limits().storageBlockBytes);
  return {"glow sums", static_cast<std::size_t>(bytes)};
}

}  // namespace

bool GlowSums::used() {
  return gl::memoryPath() == gl::MemoryPath::storage;
}

bool GlowSums::takes(const sim::Instances& instances) {
  return used() && instances.additive && instances.shape == sim::Instances::Shape::sprite;
}

GlowSums::GlowSums(glm::ivec2 size, int samples) : sums_(sumsFor(size)) {
  gl::Defines defines = {{"SAMPLES", std::to_string(samples)}};
  small_ = gl::Program::compute("draw/instances/glow_sums.comp", defines);
  defines.emplace_back("LARGE", "1");
  defines.emplace_back("SLICES", std::to_string(slices));
  large_ = gl::Program::compute("draw/instances/glow_sums.comp", defines);
}

void GlowSums::add(bool large, const gl::Texture& depth, int capacity) const {
  constexpr int maxInvocations = 1 << 20;
  constexpr int maxGroups = 1 << 12;
  const gl::Program& program = kernel(large);
  bind();
  depth.bind(depthUnit);
  if (large) {
    const int groups = std::min(capacity, maxGroups);
    program.set("strides", groups);
    program.dispatch(8 * groups, 8 * slices);
  } else {
    const int invocations = std::min(capacity, maxInvocations);
    program.set("strides", (invocations + 63) / 64 * 64);
    program.dispatch(invocations);
  }
}

void GlowSums::bind() const {
  sums_.bindStorage(glowBinding);
}

}  // namespace simreel::draw
