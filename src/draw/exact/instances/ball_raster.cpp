#include "draw/exact/instances/ball_raster.hpp"

#include "draw/exact/instances/instance_source.hpp"
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/element_array.hpp"

namespace simreel::draw {

struct BallSource {
  SampleTarget into;
  InstanceSource source;
  gl::Uniform<"draw_", int> draw;
  gl::Uniform<"firstLarge", int> firstLarge;
};

struct SmallBalls {
  static constexpr auto file = "draw/exact/instances/balls.comp";
  struct Variant {
    TargetVariant target;
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"MEDIUM"> medium;
    ListVariant list;
  };
  BallSource balls;
  gl::Uniform<"smallPixels", int> smallPixels;
  gl::Uniform<"mediumPixels", int> mediumPixels;
  gl::Uniform<"draws", int> draws;
  gl::Shared<"LargeBlock"> large;
  gl::Shared<"CounterBlock"> counters;
};

struct LargeBalls {
  static constexpr auto file = "draw/exact/instances/large_balls.comp";
  struct Variant {
    TargetVariant target;
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"MEDIUM"> medium;
  };
  BallSource balls;
  gl::Uniform<"draws", int> draws;
  gl::In<"large"> large;
  gl::In<"counters"> counters;
};

struct BallShadows {
  static constexpr auto file = "draw/exact/instances/ball_shadows.comp";
  struct Variant {
    TargetVariant target;
    gl::Flag<"LARGE"> large;
    ListVariant list;
  };
  gl::Ambient<"light"> light = {};
  BallSource balls;
  gl::Uniform<"smallPixels", int> smallPixels;
  gl::Shared<"LargeBlock"> large;
  gl::Shared<"CounterBlock"> counters;
  gl::In<"largeList"> largeList;
  gl::In<"largeCounts"> largeCounts;
};

namespace {

constexpr float ballRadius = 0.5F;  // radius of sprites and spheres of size 1

}  // namespace

BallRaster::BallRaster(Into into, int samples, int smallPixels, int mediumPixels)
    : into_(into), samples_(samples), smallPixels_(smallPixels), mediumPixels_(mediumPixels) {}

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
  const TargetVariant target = into.variant(into_, pass);
  const bool parallel = into.layout().parallel;
  const unsigned parts = workgroupsFor(into.size(), samples_);
  const int draws = static_cast<int>(balls_.size());
  int firstLarge = 0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const sim::Instances& balls = *balls_[i];
    const float minPixels = into_ == Into::picture ? minPixelsOf(balls) : 0.0F;
    const BallSource source{.into = into.target(part),
                            .source = instanceSource(balls, ballRadius, minPixels, firstIds_[i]),
                            .draw = static_cast<int>(i),
                            .firstLarge = firstLarge};
    firstLarge += balls.capacity;
    if (into_ == Into::sunMap) {
      const auto& kernel = shadows_.of({.target = target, .large = large, .list = listVariant()});
      const BallShadows given{.balls = source,
                              .smallPixels = smallPixels_,
                              .large = large_,
                              .counters = counters_,
                              .largeList = largeView_,
                              .largeCounts = counterView_};
      if (large)
        GroupCounts::dispatchList(kernel, largeGroups_, i, parts, given);
      else
        kernel.dispatch(inRows(balls.capacity), given);
    } else if (large) {
      const auto& kernel = largeBalls_.of({.target = target, .parallel = parallel, .medium = anyMedium()});
      const LargeBalls given{
          .balls = source, .draws = draws, .large = largeView_, .counters = counterView_};
      if (anyMedium())
        GroupCounts::dispatchFixed(kernel, parts, given);
      else
        GroupCounts::dispatchList(kernel, largeGroups_, i, parts, given);
    } else {
      smallBalls_.of({.target = target, .parallel = parallel, .medium = anyMedium(), .list = listVariant()})
          .dispatch(inRows(balls.capacity), {.balls = source,
                                             .smallPixels = smallPixels_,
                                             .mediumPixels = mediumPixels_,
                                             .draws = draws,
                                             .large = large_,
                                             .counters = counters_});
    }
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
      counters_, {.counts = static_cast<int>(balls_.size()), .parts = workgroupsFor(into.size(), samples_)},
      largeGroups_);
  run(true, 0, into, part);
  gl::barrier();
}

void BallRaster::drawIds(const Visibility& into) {
  if (balls_.empty() || into.layout() == SampleLayout::wholes) return;
  run(false, 1, into);
  run(true, 1, into);
  gl::barrier();
}

}  // namespace simreel::draw
