#include "draw/exact/instances/copy_raster.hpp"

#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>

namespace simreel::draw {

struct CullCopies {
  static constexpr auto file = "draw/exact/copies/cull_copies.comp";
  struct Variant {
    ListVariant list;
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"SUN_MAP"> sunMap;
  };
  gl::Ambient<"ViewBlock"> view = {};
  gl::Ambient<"light"> light = {};
  InstanceSource source;
  gl::Uniform<"draw_", int> draw;
  gl::Uniform<"firstListed", int> firstListed;
  gl::Uniform<"mapTexels", int> mapTexels;
  gl::Shared<"ListBlock"> listed;
  gl::Shared<"CounterBlock"> counters;
};

/// Uniforms, buffers and textures that glsl/draw/exact/copies/raster_copy.glsl declares.
struct RasterCopies {
  gl::Ambient<"light"> light = {};
  CopySource source;
  SampleTarget into;
  InstanceLook look;
  gl::Shared<"GlowBlock"> glows;
  gl::Uniform<"firstListed", int> firstListed;
  gl::Uniform<"skipped", int> skipped;
  gl::Uniform<"doubleSided", bool> doubleSided;
  gl::Uniform<"slopeOffset", float> slopeOffset;
  gl::In<"listedCopies"> listedCopies;
  gl::Uniform<"part", int> part;
};
struct CopyVariant {
  TargetVariant target;
  gl::Flag<"PARALLEL"> parallel;
  gl::Flag<"ADDS"> adds;
  gl::Flag<"HAZE"> haze;
};

struct SmallCopies {
  static constexpr auto file = "draw/exact/copies/copies.comp";
  struct Variant {
    CopyVariant copies;
    LaneVariant lanes;
  };
  RasterCopies copies;
  gl::Uniform<"draw_", int> draw;
  gl::Uniform<"copyLimit", int> copyLimit;
  gl::Uniform<"parts", int> parts;
  gl::Uniform<"listRoom", int> listRoom;
  gl::Uniform<"smallPixels", int> smallPixels;
  gl::Uniform<"mediumPixels", int> mediumPixels;
  gl::In<"listedCounts"> listedCounts;
  gl::Shared<"LargeBlock"> large;
  gl::Shared<"CounterBlock"> counters;
};

struct MediumCopies {
  static constexpr auto file = "draw/exact/copies/medium_copies.comp";
  using Variant = CopyVariant;
  RasterCopies copies;
  gl::Uniform<"parts", int> parts;
  gl::Uniform<"listRoom", int> listRoom;
  gl::In<"large"> large;
  gl::In<"counters"> counters;
};

struct LargeCopies {
  static constexpr auto file = "draw/exact/copies/large_copies.comp";
  using Variant = CopyVariant;
  RasterCopies copies;
  gl::In<"large"> large;
  gl::In<"counters"> counters;
};

namespace {

constexpr unsigned groupPairs = 64;

void clear(const gl::Buffer& counts) {
  constexpr GLuint zero = 0;
  glClearNamedBufferData(counts.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

}  // namespace

CopyRaster::CopyRaster(Into into, int samples, int smallPixels, unsigned pairs, int mediumPixels)
    : into_(into),
      samples_(samples),
      smallPixels_(smallPixels),
      mediumPixels_(mediumPixels),
      pairs_(pairs) {}

unsigned CopyRaster::pairsAtOnce() {
  return 1U << (gl::softwareDriver() ? 22U : 25U);
}

unsigned CopyRaster::Copies::triangles() const {
  const InstanceShape::Level& level = shape->levels()[0];
  return static_cast<unsigned>(level.indexCount / level.batch / 3);
}

CopySource CopyRaster::source(const Copies& copies, unsigned firstId) {
  gl::Texture& indices = indices_[copies.shape];
  if (!indices) indices = gl::Texture::view("indices", GL_R32UI, copies.shape->indices(), sizeof(GLuint));
  return {.source = instanceSource(*copies.instances, copies.shape->radius(), 0, firstId),
          .indices = indices,
          .shape = copies.shape->vertices(),
          .turns = turnsOf(*copies.instances),
          .turning = static_cast<int>(copies.instances->turning),
          .triangles = copies.triangles()};
}

void CopyRaster::list(const std::vector<Copies>& copies, const Visibility& into) {
  copies_ = copies;
  firstListed_.clear();
  parts_.clear();
  int all = 0;
  listRoom_ = 0;
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    firstListed_.push_back(all);
    const int capacity = copies_[i].instances->capacity;
    all += capacity;
    const unsigned triangles = std::max(copies_[i].triangles(), 1U);
    const int maximum = static_cast<int>(std::max(pairs_ / triangles, 1U));
    listRoom_ = std::max(listRoom_, static_cast<std::size_t>(std::min(maximum, capacity)) * triangles);
    for (int skipped = 0; skipped < capacity; skipped += maximum) parts_.push_back({i, skipped, maximum});
  }
  const auto words = [](std::size_t count) { return count * sizeof(GLuint); };
  const std::size_t parts = parts_.size();
  reserve(listed_, listedView_, "copies in sight", words(static_cast<std::size_t>(all)), GL_R32UI, 4);
  reserve(counts_, countView_, "counts of copies", words(copies_.size()), GL_R32UI, 4);
  reserve(large_, largeView_, "large triangles of copies", words(listRoom_), GL_R32UI, 4);
  reserve(largeCounts_, largeCountView_, "counts of large triangles", words(2 * parts), GL_R32UI, 4);
  reserve(smallGroups_, "groups for copies", parts * GroupCounts::bytes);
  reserve(largeGroups_, "groups for large triangles", parts * GroupCounts::bytes);
  if (!cull_)
    cull_ = gl::Kernel<CullCopies>(
        gl::Defines(),
        {.list = listVariant(), .parallel = into.layout().parallel, .sunMap = into_ == Into::sunMap});
  clear(counts_);
  gl::barrier();
  for (std::size_t i = 0; i < copies_.size(); ++i)
    cull_.dispatch(inRows(copies_[i].instances->capacity), {.source = source(copies_[i], 0).source,
                                                            .draw = static_cast<int>(i),
                                                            .firstListed = firstListed_[i],
                                                            .mapTexels = into.size().x,
                                                            .listed = listed_,
                                                            .counters = counts_});
  for (std::size_t part = 0; part < parts; ++part)
    groups_.fill(counts_,
                 {.first = static_cast<int>(part),
                  .firstCount = static_cast<int>(parts_[part].draw),
                  .skipped = static_cast<unsigned>(parts_[part].skipped),
                  .maximum = static_cast<unsigned>(parts_[part].maximum),
                  .times = copies_[parts_[part].draw].triangles(),
                  .each = groupPairs},
                 smallGroups_);
}

void CopyRaster::runPart(std::size_t number, Pass pass, const Visibility& into, const MapPart& map) {
  const Part& part = parts_[number];
  const Copies& copies = copies_[part.draw];
  const unsigned shares = workgroupsFor(into.size(), samples_);
  const CopyVariant variant{.target = into.variant(into_, pass == Pass::numbers ? 1 : 0),
                            .parallel = into.layout().parallel,
                            .adds = pass == Pass::light,
                            .haze = pass == Pass::light && hazy_};
  const RasterCopies raster{
      .source = source(copies, firstIds_[part.draw]),
      .into = into.target(map),
      .look = pass == Pass::light ? colors_[part.draw].look(*copies.instances) : InstanceLook(),
      .glows = pass == Pass::light ? gl::Resource(*glows_) : gl::Resource(),
      .firstListed = firstListed_[part.draw],
      .skipped = part.skipped,
      .doubleSided = true,
      .slopeOffset = map.slopeOffset,
      .listedCopies = listedView_,
      .part = static_cast<int>(number)};
  GroupCounts::dispatch(copyKernels_.of({.copies = variant, .lanes = laneVariant()}), smallGroups_, number,
                        {.copies = raster,
                         .draw = static_cast<int>(part.draw),
                         .copyLimit = part.maximum,
                         .parts = static_cast<int>(parts_.size()),
                         .listRoom = static_cast<int>(listRoom_),
                         .smallPixels = smallPixels_,
                         .mediumPixels = mediumPixels_,
                         .listedCounts = countView_,
                         .large = large_,
                         .counters = largeCounts_});
  groups_.prepareLists(
      largeCounts_,
      {.first = static_cast<int>(number), .firstCount = static_cast<int>(number), .parts = shares},
      largeGroups_);
  if (mediumPixels_ > smallPixels_)
    GroupCounts::dispatchFixed(mediumKernels_.of(variant), 1,
                               {.copies = raster,
                                .parts = static_cast<int>(parts_.size()),
                                .listRoom = static_cast<int>(listRoom_),
                                .large = largeView_,
                                .counters = largeCountView_});
  GroupCounts::dispatchList(largeKernels_.of(variant), largeGroups_, number, shares,
                            {.copies = raster, .large = largeView_, .counters = largeCountView_});
}

void CopyRaster::run(Pass pass, const Visibility& into, const MapPart& map) {
  clear(largeCounts_);
  gl::barrier();
  for (std::size_t part = 0; part < parts_.size(); ++part) runPart(part, pass, into, map);
  gl::barrier();
}

void CopyRaster::drawNearest(const std::vector<Copies>& copies, const std::vector<unsigned>& firstIds,
                             const Visibility& into, const MapPart& map) {
  copies_.clear();
  firstIds_ = firstIds;
  firstIds_.resize(copies.size());
  if (copies.empty()) return;
  list(copies, into);
  run(Pass::nearest, into, map);
}

void CopyRaster::drawIds(const Visibility& into) {
  if (!copies_.empty() && into.layout() != SampleLayout::wholes) run(Pass::numbers, into, {});
}

void CopyRaster::addLight(const std::vector<Copies>& copies, const Visibility& into,
                          const gl::Buffer& sums) {
  if (copies.empty()) return;
  glows_ = &sums;
  colors_.resize(std::max(colors_.size(), copies.size()));
  for (std::size_t i = 0; i < copies.size(); ++i) colors_[i].update(*copies[i].instances);
  firstIds_.assign(copies.size(), 0U);
  list(copies, into);
  run(Pass::light, into, {});
}

}  // namespace simreel::draw
