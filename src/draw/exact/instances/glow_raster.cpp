#include "draw/exact/instances/glow_raster.hpp"

#include "base/error.hpp"
#include "draw/exact/instances/instance_source.hpp"
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"

#include <cstdint>

namespace simreel::draw {

struct GlowKernel {
  static constexpr auto file = "draw/exact/instances/glows.comp";
  struct Variant {
    SampleVariant samples;
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"LARGE"> large;
    gl::Flag<"MEDIUM"> medium;
    gl::Flag<"BALL"> ball;
    gl::Flag<"HAZE"> haze;
    ListVariant list;
  };
  gl::Ambient<"ViewBlock"> view = {};
  SamplesRead samples;
  InstanceSource source;
  InstanceLook look;
  gl::Uniform<"draw_", int> draw;
  gl::Uniform<"firstLarge", int> firstLarge;
  gl::Uniform<"smallPixels", int> smallPixels;
  gl::Uniform<"mediumPixels", int> mediumPixels;
  gl::Uniform<"draws", int> draws;
  gl::Uniform<"roundPixels", float> roundPixels;
  gl::Shared<"GlowBlock"> sums;
  gl::Shared<"LargeBlock"> large;
  gl::Shared<"CounterBlock"> counters;
  gl::In<"largeList"> largeList;
  gl::In<"largeCounts"> largeCounts;
};

struct AddGlows {
  static constexpr auto file = "draw/exact/instances/add_glows.comp";
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::InOut<"sums"> light;
  gl::InOut<"GlowBlock"> sums;
};

namespace {

constexpr float glowRadius = 0.5F;    // radius of sprites and spheres of size 1
constexpr float roundPixels = 64.0F;  // max radius (pixels) of glows that are drawn as discs in the picture
                                      // plane, like the points of the driver's rasterizer

}  // namespace

GlowRaster::GlowRaster(int samples, int smallPixels, int mediumPixels)
    : samples_(samples), smallPixels_(smallPixels), mediumPixels_(mediumPixels) {}

void GlowRaster::prepare(glm::ivec2 size) {
  constexpr GLuint zero = 0;
  const std::int64_t bytes = sumBytes * size.x * size.y;
  if (bytes > gl::limits().storageBlockBytes)
    fail(ExitCode::device,
         "a picture of {}x{} pixels with glows needs {} bytes in one buffer, this device allows {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make the picture smaller",
         size.x, size.y, bytes, gl::limits().storageBlockBytes);
  if (!reserve(sums_, "glow sums", static_cast<std::size_t>(bytes))) return;
  glClearNamedBufferData(sums_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  add_ = gl::Kernel<AddGlows>(gl::Defines());
}

void GlowRaster::run(bool large, const Visibility& picture) {
  const unsigned parts = workgroupsFor(picture.size(), picture.samples());
  int firstLarge = 0;
  for (std::size_t i = 0; i < glows_.size(); ++i) {
    const sim::Instances& glows = *glows_[i];
    const gl::Kernel<GlowKernel>& kernel = kernels_.of({.samples = picture.variant(),
                                                        .parallel = picture.layout().parallel,
                                                        .large = large,
                                                        .medium = anyMedium(),
                                                        .ball = !isSprite(glows),
                                                        .haze = hazy_,
                                                        .list = listVariant()});
    const GlowKernel given{.samples = picture.read(),
                           .source = instanceSource(glows, glowRadius, minPixelsOf(glows), 0),
                           .look = colors_[i].look(glows),
                           .draw = static_cast<int>(i),
                           .firstLarge = firstLarge,
                           .smallPixels = smallPixels_,
                           .mediumPixels = mediumPixels_,
                           .draws = static_cast<int>(glows_.size()),
                           .roundPixels = glows.discs ? 0.0F : roundPixels,
                           .sums = sums_,
                           .large = large_,
                           .counters = counters_,
                           .largeList = largeView_,
                           .largeCounts = counterView_};
    firstLarge += glows.capacity;
    if (large && anyMedium())
      GroupCounts::dispatchFixed(kernel, parts, given);
    else if (large)
      GroupCounts::dispatchList(kernel, largeGroups_, i, parts, given);
    else
      kernel.dispatch(inRows(glows.capacity), given);
  }
}

void GlowRaster::draw(const std::vector<const sim::Instances*>& glows, const Visibility& picture) {
  constexpr GLuint zero = 0;
  glows_ = glows;
  if (glows_.empty()) return;
  const std::size_t count = glows_.size();
  colors_.resize(std::max(colors_.size(), count));
  std::size_t all = 0;
  for (std::size_t i = 0; i < count; ++i) {
    colors_[i].update(*glows_[i]);
    all += static_cast<std::size_t>(glows_[i]->capacity);
  }
  reserve(large_, largeView_, "large glows", all * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(counters_, counterView_, "counts of large glows", 2 * count * sizeof(GLuint), GL_R32UI,
          sizeof(GLuint));
  reserve(largeGroups_, "groups for large glows", count * GroupCounts::bytes);
  glClearNamedBufferData(counters_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  gl::barrier();
  run(false, picture);
  groups_.prepareLists(
      counters_,
      {.counts = static_cast<int>(count), .parts = workgroupsFor(picture.size(), picture.samples())},
      largeGroups_);
  run(true, picture);
}

void GlowRaster::addTo(glm::ivec2 size, const gl::Texture& light) const {
  add_.dispatch(size, {.light = light, .sums = sums_});
}

}  // namespace simreel::draw
