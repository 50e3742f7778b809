#include "draw/instances/glow_sums.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

struct SumGlows {
  static constexpr auto file = "draw/instances/glow_sums.comp";
  struct Variant {
    gl::Range<"SAMPLES", 1, 64> samples;
    gl::Flag<"LARGE"> large;
    gl::Range<"SLICES", 1, 64> slices = {};
  };
  gl::Ambient<"FrameBlock"> frame = {};
  GlowFields glows;
  gl::In<"sceneDepth"> depth;
  gl::Shared<"GlowBlock"> sums;
  gl::Uniform<"strides", int> strides;
};

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
  small_ = gl::Kernel<SumGlows>({}, {.samples = samples, .large = false});
  large_ = gl::Kernel<SumGlows>({}, {.samples = samples, .large = true, .slices = slices});
}

void GlowSums::add(bool large, const GlowFields& glows, const gl::Texture& depth, int capacity) const {
  constexpr int maxInvocations = 1 << 20;
  constexpr int maxGroups = 1 << 12;
  const int groups = std::min(capacity, maxGroups);
  const int invocations = std::min(capacity, maxInvocations);
  const SumGlows given{.glows = glows,
                       .depth = depth,
                       .sums = sums_,
                       .strides = large ? groups : (invocations + 63) / 64 * 64};
  if (large)
    large_.dispatch(glm::ivec2(8 * groups, 8 * slices), given);
  else
    small_.dispatch(invocations, given);
}

}  // namespace simreel::draw
