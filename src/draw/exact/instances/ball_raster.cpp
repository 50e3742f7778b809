#include "draw/exact/instances/ball_raster.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/instances/instance_values.hpp"
#include "gl/element_array.hpp"

namespace simreel::draw {

namespace {

constexpr float ballRadius = 0.5F;  // of sprites and spheres at size 1

}  // namespace

BallRaster::BallRaster(Into into, int samples, int smallPixels, int mediumPixels)
    : into_(into), samples_(samples), smallPixels_(smallPixels), mediumPixels_(mediumPixels) {}

const gl::Program& BallRaster::program(bool large, int pass, SampleKind layout) {
  const std::tuple<bool, int, SampleKind> key{large, pass, layout};
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = {{"SAMPLES", std::to_string(samples_)}, {"PASS", std::to_string(pass)}};
  for (const auto& define : definesOf(layout)) defines.push_back(define);
  if (!large)
    for (const auto& define : laneDefines()) defines.push_back(define);
  const bool map = into_ == Into::sunMap;
  if (map) defines.emplace_back("SUN_MAP", "1");
  if (into_ == Into::lampMap) defines.emplace_back("LAMP_MAP", "1");
  if (anyMedium()) defines.emplace_back("MEDIUM", "1");
  if (map && large) defines.emplace_back("LARGE", "1");
  const char* path = map     ? "draw/exact/instances/ball_shadows.comp"
                     : large ? "draw/exact/instances/large_balls.comp"
                             : "draw/exact/instances/balls.comp";
  return programs_.emplace(key, gl::Program::compute(path, defines)).first->second;
}

void BallRaster::prepare() {
  constexpr GLuint zero = 0;
  std::size_t all = 0;
  for (const sim::Instances* balls : balls_) all += static_cast<std::size_t>(balls->capacity);
  const std::size_t count = balls_.size();
  reserve(large_, largeView_, "large balls", all * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(counters_, counterView_, "counts of large balls", 2 * count * sizeof(GLuint), GL_R32UI,
          sizeof(GLuint));
  reserve(largeGroups_, "groups for large balls", count * GroupCounts::bytes);
  glClearNamedBufferData(counters_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

void BallRaster::run(bool large, int pass, const Visibility& into, const MapPart& part) {
  into.bind();
  large_.bindStorage(largeBinding);
  largeView_.bind(largeUnit);
  counters_.bindStorage(counterBinding);
  counterView_.bind(counterUnit);
  const gl::Program& kernel = program(large, pass, into.layout());
  int firstLarge = 0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const sim::Instances& balls = *balls_[i];
    setInstance(kernel, balls, ballRadius, into_ == Into::picture ? minPixelsOf(balls) : 0.0F);
    kernel.set("capacity", balls.capacity);
    kernel.set("firstId", firstIds_[i]);
    kernel.set("draw_", static_cast<int>(i));
    kernel.set("firstLarge", firstLarge);
    kernel.set("smallPixels", smallPixels_);
    kernel.set("mediumPixels", mediumPixels_);
    kernel.set("draws", static_cast<int>(balls_.size()));
    kernel.set("mapTexels", into.size().x);
    part.set(kernel);
    firstLarge += balls.capacity;
    if (large && anyMedium())
      GroupCounts::dispatchFixed(kernel, partsFor(into.size(), samples_));
    else if (large)
      GroupCounts::dispatchList(kernel, largeGroups_, i, partsFor(into.size(), samples_));
    else
      dispatchRows(kernel, balls.capacity);
  }
}

void BallRaster::drawNearest(const std::vector<const sim::Instances*>& balls,
                             const std::vector<unsigned>& firstIds, const Visibility& into,
                             const MapPart& part) {
  balls_ = balls;
  firstIds_ = firstIds;
  firstIds_.resize(balls_.size());
  if (balls_.empty()) return;
  prepare();
  gl::barrier();
  run(false, 0, into, part);
  groups_.prepareLists(
      counters_, {.counts = static_cast<int>(balls_.size()), .parts = partsFor(into.size(), samples_)},
      largeGroups_);
  run(true, 0, into, part);
  gl::barrier();
}

void BallRaster::drawNumbers(const Visibility& into) {
  if (balls_.empty() || into.layout() == SampleLayout::wholes) return;
  run(false, 1, into);
  run(true, 1, into);
  gl::barrier();
}

}  // namespace simreel::draw
