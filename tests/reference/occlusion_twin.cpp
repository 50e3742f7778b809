#include "reference/occlusion_twin.hpp"

#include "draw/picture_code.hpp"

#include <algorithm>

namespace {

using namespace simreel::shader;  // NOLINT: the model uses GLSL's names

const simreel::shader::Frame noFrame{};

#define FUNCTION inline
#define precise
#define EXACT_PICTURE
#define SLICES twin.slices
#define STEPS twin.steps
/// Provides the inputs of the kernels, and includes the model files.
struct Kernel {
  const OcclusionTwin& twin;
  const ExactView& view = twin.view;
  const Frame& frame = noFrame;
  vec3 reach_ = twin.reach;
  std::vector<vec2> arcs = {};
  const std::vector<float>* open = nullptr;

  [[nodiscard]] std::size_t indexOf(ivec2 at) const {
    return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(twin.half().x) +
           static_cast<std::size_t>(at.x);
  }
  [[nodiscard]] bool within(ivec2 at) const { return at == clamp(at, ivec2(0), twin.half() - 1); }
  [[nodiscard]] float nearnessAt(ivec2 at) const { return within(at) ? twin.nearness[indexOf(at)] : 0.0F; }
  [[nodiscard]] vec2 opennessAt(ivec2 at) const { return {(*open)[indexOf(at)], nearnessAt(at)}; }
#include "glsl/draw/exact/occlusion/horizons.glsl"
#include "glsl/draw/exact/occlusion/open_place.glsl"
#include "glsl/draw/exact/occlusion/smooth_arcs.glsl"

  [[nodiscard]] vec2 smoothAlong(ivec2 at, ivec2 along) {
    ArcsBeside beside{};
    for (int k = 0; k < 7; ++k) {
      const ivec2 there = at + along * (k - 3);
      beside.of[k] = within(there) ? vec3(arcs[indexOf(there)], nearnessAt(there)) : vec3(0);
    }
    return nearnessAt(at) > 0.0F ? smoothArcs(beside) : vec2(0, 1);
  }

  template <class F>
  void each(const F& f) const {
    for (int y = 0; y < twin.half().y; ++y)
      for (int x = 0; x < twin.half().x; ++x) f(ivec2(x, y));
  }
};
#undef STEPS
#undef SLICES
#undef EXACT_PICTURE
#undef precise
#undef FUNCTION

}  // namespace

void OcclusionTwin::see(const simreel::shader::Frame& frame, int samples,
                        const std::vector<std::uint32_t>& keys, bool ground) {
  Kernel kernel{*this, view, frame};
  nearness.clear();
  kernel.each([&](ivec2 at) {
    std::uint32_t key = 0xffffffffU;
    for (int y = 2 * at.y; y < min(2 * at.y + 2, view.size.y); ++y)
      for (int x = 2 * at.x; x < min(2 * at.x + 2, view.size.x); ++x)
        for (int s = 0; s < samples; ++s)
          key = min(key, keys[static_cast<std::size_t>((y * view.size.x + x) * samples + s)]);
    float near = key <= 0x7fffffffU ? intBitsToFloat(static_cast<int>(0x7fffffffU - key)) : 0.0F;
    if (ground) {
      const float depth = kernel.groundDepth(kernel.rayThrough(vec2(2 * at + 1)));
      const float there = view.near * exactReciprocal(max(depth, 1e-6F));
      if (depth >= view.near && there >= view.nearOverFar) near = max(near, there);
    }
    nearness.push_back(near * exactReciprocal(view.near));
  });
}

std::vector<float> OcclusionTwin::openness() const {
  Kernel kernel{*this};
  std::vector<vec2> found;
  kernel.each([&](ivec2 at) {
    const float here = kernel.nearnessAt(at);
    const Kernel::Arcs arcs =
        here > 0.0F ? kernel.arcsOf(kernel.halfPlaceOf(at, here)) : Kernel::Arcs{0.0F, 0.0F};
    found.emplace_back(arcs.lost, arcs.all_);
  });
  kernel.arcs = found;
  std::vector<vec2> across;
  kernel.each([&](ivec2 at) { across.push_back(kernel.smoothAlong(at, {1, 0})); });
  kernel.arcs = across;
  std::vector<float> open;
  kernel.each([&](ivec2 at) { open.push_back(kernel.opennessOf(kernel.smoothAlong(at, {0, 1}))); });
  return open;
}

float OcclusionTwin::opennessOn(const std::vector<float>& openness, glm::ivec2 pixel, glm::vec3 p) const {
  Kernel kernel{*this};
  kernel.open = &openness;
  return kernel.opennessOn(pixel, p);
}
