#include "draw/exact/occlusion/occlusion.hpp"

#include "draw/rows_at_once.hpp"
#include "gl/element_array.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Defines of kernels that read the picture. ROWS: number of half-resolution pixels that an invocation
/// handles.
struct SeenVariant {
  gl::Flag<"PARALLEL"> parallel;
  gl::Range<"ROWS", 1, 8> rows;
};

struct HalfNearness {
  static constexpr auto file = "draw/exact/occlusion/half_nearness.comp";
  struct Variant {
    SampleVariant samples;
    SeenVariant seen;
    gl::Flag<"GROUND"> ground;
    gl::Flag<"PIXELS"> pixels;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  SamplesRead samples;
  gl::Out<"NearnessBlock"> nearness;
  gl::Uniform<"firstPixel", int> firstPixel = {};
  gl::Out<"PixelNearnessBlock"> pixelNearness = {};
};

struct Horizons {
  static constexpr auto file = "draw/exact/occlusion/horizons.comp";
  struct Variant {
    SeenVariant seen;
    gl::Range<"SLICES", 1, 8> slices;
    gl::Range<"STEPS", 1, 16> steps;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::Uniform<"reach", glm::vec3> reach;
  gl::In<"nearness"> nearness;
  gl::Out<"ArcBlock"> arcs;
};

struct SmoothArcs {
  static constexpr auto file = "draw/exact/occlusion/smooth_arcs.comp";
  struct Variant {
    SeenVariant seen;
    gl::Flag<"DOWN"> down;
  };
  gl::Ambient<"ViewBlock"> view = {};
  gl::In<"nearness"> nearness;
  gl::In<"arcs"> arcs;
  gl::Out<"SmoothBlock"> smooth = {};
  gl::Out<"OpennessBlock"> openness = {};
};

Occlusion::HalfResolutionBuffer::HalfResolutionBuffer(const std::string& label, GLenum format,
                                                      std::size_t bytes, glm::ivec2 size)
    : buffer(label, static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * bytes),
      view(gl::Texture::view(label, format, buffer, bytes)) {}

glm::vec3 searchLimits(const shader::ExactView& view, float radius) {
  // The max distance in the picture is a third of the picture height, so that the result does not depend on
  // the resolution.
  const float maximum = static_cast<float>(view.size.y) / 6.0F;
  return {radius, maximum, 0.5F / glm::length(glm::vec3(view.rayAcross))};
}

Occlusion::Occlusion(glm::ivec2 size, const Visibility& visibility, bool ground) : half_((size + 1) / 2) {
  const int rows = rowsAtOnce();
  const bool parallel = visibility.layout().parallel;
  const gl::Defines none;
  HalfNearness::Variant nearest{.samples = visibility.variant(),
                                .seen = {.parallel = parallel, .rows = rows},
                                .ground = ground,
                                .pixels = false};
  nearest_ = gl::Kernel<HalfNearness>(none, nearest);
  nearest.pixels = true;
  nearestOfPixels_ = gl::Kernel<HalfNearness>(none, nearest);
  horizons_ = gl::Kernel<Horizons>(
      none, {.seen = {.parallel = parallel, .rows = rows}, .slices = slices, .steps = steps});
  across_ = gl::Kernel<SmoothArcs>(none, {.seen = {.parallel = parallel, .rows = rows}, .down = false});
  down_ = gl::Kernel<SmoothArcs>(none, {.seen = {.parallel = parallel, .rows = rows}, .down = true});
  nearness_ = HalfResolutionBuffer("nearness", GL_R32F, sizeof(float), half_);
  arcs_ = HalfResolutionBuffer("light that is lost", GL_RG32F, sizeof(glm::vec2), half_);
  smooth_ = HalfResolutionBuffer("light that is lost, along rows", GL_RG32F, sizeof(glm::vec2), half_);
  openness_ = HalfResolutionBuffer("openness", GL_RG32F, sizeof(glm::vec2), half_);
}

void Occlusion::add(const Visibility& visibility, const shader::ExactView& view,
                    const PixelNearness& pixels) const {
  gl::barrier();
  const int rows = (view.rows.y - view.rows.x + 1) / 2;
  const glm::ivec2 items(half_.x, (rows + rowsAtOnce() - 1) / rowsAtOnce());
  HalfNearness given{.samples = visibility.read(), .nearness = nearness_.buffer};
  if (pixels.buffer == nullptr) {
    nearest_.dispatch(items, given);
  } else {
    given.firstPixel = pixels.first;
    given.pixelNearness = *pixels.buffer;
    nearestOfPixels_.dispatch(items, given);
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

void Occlusion::find(const shader::ExactView& view, float radius) const {
  const int each = rowsAtOnce();
  const glm::ivec2 inColumns = {half_.x, (half_.y + each - 1) / each};
  horizons_.dispatch(
      inColumns, {.reach = searchLimits(view, radius), .nearness = nearness_.view, .arcs = arcs_.buffer});
  across_.dispatch({(half_.x + each - 1) / each, half_.y},
                   {.nearness = nearness_.view, .arcs = arcs_.view, .smooth = smooth_.buffer});
  down_.dispatch(inColumns,
                 {.nearness = nearness_.view, .arcs = smooth_.view, .openness = openness_.buffer});
  gl::barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace simreel::draw
