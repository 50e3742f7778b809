#include "draw/glow_sums.hpp"

#include "draw/draw_state.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

namespace {

constexpr GLuint sumBinding = 1;
constexpr GLuint depthUnit = normalUnit;

/// Light in the middle of the brightest glow that a crowd can have.
double brightest(const sim::Instances& instances) {
  double most = 0;
  const auto grow = [&](const glm::vec3& color) {
    most = std::max({most, double{color.r}, double{color.g}, double{color.b}});
  };
  if (instances.colorBy == sim::Instances::ColorBy::material)
    grow(instances.material->color);
  else if (instances.colors == nullptr || instances.colors->empty())
    grow(glm::vec3(1));
  else
    for (const glm::vec3& stop : *instances.colors) grow(stop);
  return most * instances.brightness;
}

}  // namespace

bool GlowSums::used() {
  return gl::memoryPath() == gl::MemoryPath::storage;
}

bool GlowSums::takes(const sim::Instances& instances) {
  return used() && instances.additive && instances.shape == sim::Instances::Shape::sprite;
}

GlowSums::GlowSums(glm::ivec2 size, int samples)
    : sums_("glow sums", 12 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
  gl::Defines defines = {{"SAMPLES", std::to_string(samples)}};
  small_ = gl::Program::compute("draw/glow_sums.comp", defines);
  defines.emplace_back("LARGE", "1");
  defines.emplace_back("SLICES", std::to_string(slices));
  large_ = gl::Program::compute("draw/glow_sums.comp", defines);
}

void GlowSums::start(const sim::Drawables& drawables) {
  double whole = 0;
  double count = 0;
  for (const sim::Instances& instances : drawables.instances) {
    if (!takes(instances)) continue;
    whole += instances.capacity * brightest(instances);
    count += instances.capacity;
  }
  // Each is rounded up by at most half a unit.
  scale_ = static_cast<float>((4294967295.0 - count) * 0.999 / std::max(whole, 1e-9));
}

void GlowSums::add(bool large, const gl::Texture& depth, int capacity) const {
  constexpr int mostInvocations = 1 << 20;
  constexpr int mostGroups = 1 << 12;
  const gl::Program& program = kernel(large);
  bind(program);
  depth.bind(depthUnit);
  if (large) {
    const int groups = std::min(capacity, mostGroups);
    program.set("strides", groups);
    program.dispatch(8 * groups, 8 * slices);
  } else {
    const int invocations = std::min(capacity, mostInvocations);
    program.set("strides", (invocations + 63) / 64 * 64);
    program.dispatch(invocations);
  }
}

void GlowSums::bind(const gl::Program& program) const {
  program.set("glowScale", scale_);
  sums_.bindStorage(sumBinding);
}

}  // namespace simreel::draw
