#include "draw/exact/instances/glow_raster.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"

#include <cstdint>

namespace simreel::draw {

namespace {

constexpr float glowRadius = 0.5F;    // of sprites and spheres at size 1
constexpr float roundPixels = 64.0F;  // as the driver's points

}  // namespace

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
  add_ = gl::Program::compute("draw/exact/instances/add_glows.comp");
}

const gl::Program& GlowRaster::program(bool large, bool ball, SampleKind layout) {
  const std::tuple<bool, bool, SampleKind> key{large, ball, layout};
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = {{"SAMPLES", std::to_string(samples_)}};
  for (const auto& define : definesOf(layout)) defines.push_back(define);
  if (!large)
    for (const auto& define : laneDefines()) defines.push_back(define);
  if (large) defines.emplace_back("LARGE", "1");
  if (anyMedium()) defines.emplace_back("MEDIUM", "1");
  if (ball) defines.emplace_back("BALL", "1");
  return programs_.emplace(key, gl::Program::compute("draw/exact/instances/glows.comp", defines))
      .first->second;
}

void GlowRaster::run(bool large, const Visibility& picture) {
  picture.bind();
  bindSums();
  large_.bindStorage(largeBinding);
  largeView_.bind(largeUnit);
  counters_.bindStorage(counterBinding);
  counterView_.bind(counterUnit);
  int firstLarge = 0;
  for (std::size_t i = 0; i < glows_.size(); ++i) {
    const sim::Instances& glows = *glows_[i];
    const gl::Program& kernel = program(large, !isSprite(glows), picture.layout());
    setInstance(kernel, glows, glowRadius, minPixelsOf(glows));
    colors_[i].set(kernel, glows);
    kernel.set("capacity", glows.capacity);
    kernel.set("draw_", static_cast<int>(i));
    kernel.set("firstLarge", firstLarge);
    kernel.set("smallPixels", smallPixels_);
    kernel.set("mediumPixels", mediumPixels_);
    kernel.set("draws", static_cast<int>(glows_.size()));
    kernel.set("roundPixels", glows.discs ? 0.0F : roundPixels);
    firstLarge += glows.capacity;
    if (large && anyMedium())
      GroupCounts::dispatchFixed(kernel, partsFor(picture.size(), picture.samples()));
    else if (large)
      GroupCounts::dispatchList(kernel, largeGroups_, i, partsFor(picture.size(), picture.samples()));
    else
      dispatchRows(kernel, glows.capacity);
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
      counters_, {.counts = static_cast<int>(count), .parts = partsFor(picture.size(), picture.samples())},
      largeGroups_);
  run(true, picture);
  gl::barrier();
}

void GlowRaster::bindSums() const {
  sums_.bindStorage(glowBinding);
}

void GlowRaster::addTo(glm::ivec2 size) const {
  bindSums();
  add_.dispatch(size.x, size.y);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace simreel::draw
