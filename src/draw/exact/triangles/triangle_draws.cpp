// Dispatches the kernels of TriangleRaster, pass by pass.
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_kernels.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "gl/rehearsal.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

constexpr unsigned groupTriangles = 64;

/// Returns the size (pixels) of the target: the shadow map of `part`, or the whole buffer.
glm::ivec2 sizeOf(const Visibility& into, const MapPart& part) {
  return part.side > 0 ? glm::ivec2(part.side) : into.size();
}

}  // namespace

void TriangleRaster::clipLarge(const Visibility& into) {
  if (into_ == Into::sunMap || fanRoom_ == 0) return;
  if (faceViews_ == nullptr)
    groups_.fill(counters_, {.counts = static_cast<int>(entries_.size()), .each = groupTriangles},
                 clipGroups_);
  run(Step::clip, 0, into);
}

RasterTriangles TriangleRaster::raster(const Drawn& drawn, const Visibility& into) const {
  const bool map = into_ == Into::lampMap;
  return {.into = into.target(drawn.face.part, viewOf(drawn.face)),
          .source = source(drawn),
          .firstId = drawn.firstId,
          .slopeOffset = drawn.face.part.slopeOffset,
          .doubleSided = map || drawn.surface->doubleSided,
          .draw = static_cast<int>(&drawn - entries_.data()),
          .draws = static_cast<int>(entries_.size())};
}

RasterVariant TriangleRaster::variant(const Visibility& into, int pass) const {
  return {.target = into.variant(into_, pass),
          .parallel = into.layout().parallel,
          .counted = into_ == Into::lampMap,
          .joined = joined_ != nullptr,
          .faces = {},
          .cut = false,
          .grid = false,
          .layer = false};
}

template <class Dispatch>
void TriangleRaster::runKernel(Step step, bool clips, const RasterVariant& variant,
                               const RasterTriangles& raster, const Drawn& drawn,
                               const Dispatch& dispatch) {
  const bool ofLeft = binned_ && into_ != Into::sunMap;
  const FanFields fan{.fanRoom = drawn.fans, .firstFan = drawn.firstFan};
  const BinFields bins = binned_ ? bins_.fields(drawn.list) : BinFields();
  switch (step) {
    case Step::small:
      return dispatch(small_.of({.raster = variant, .lanes = laneVariant(), .bins = binned_}),
                      SmallTriangles{.raster = raster,
                                     .bins = bins,
                                     .smallPixels = smallPixels_,
                                     .mediumPixels = mediumPixels_,
                                     .large = large_,
                                     .counters = counters_});
    case Step::medium:
      return dispatch(medium_.of(variant),
                      MediumTriangles{.raster = raster, .large = largeView_, .counters = counterView_});
    case Step::clip:
      return dispatch(clip_.of({.raster = variant, .bins = binned_}),
                      ClipTriangles{.raster = raster,
                                    .bins = bins,
                                    .fan = fan,
                                    .fans = fans_,
                                    .large = largeView_,
                                    .counters = counterView_,
                                    .left = left_,
                                    .leftCounts = counters_});
    case Step::large:
      return dispatch(largeOnes_.of({.raster = variant, .bins = binned_, .clips = clips}),
                      LargeTriangles{.raster = raster,
                                     .fan = fan,
                                     .fans = fanView_,
                                     .large = ofLeft ? leftView_ : largeView_,
                                     .counters = counterView_});
  }
}

const sim::Surface* TriangleRaster::surfaceOf(const Drawn& drawn) const {
  return into_ == Into::lampMap ? fragments_.only : drawn.surface;
}

bool TriangleRaster::hasHoles(const Drawn& drawn) const {
  const sim::Surface* const own = surfaceOf(drawn);
  return own != nullptr && fragments_.cut && fragments_.cut(*own);
}

bool TriangleRaster::anyHoles() const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Drawn& drawn) { return hasHoles(drawn); });
}

void TriangleRaster::run(Step step, int pass, const Visibility& into, bool clips) {
  if (faceViews_ != nullptr) return runFaces(step, pass, into, clips);
  const bool anyCut = anyHoles();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Drawn& drawn = entries_[i];
    if (clips && drawn.fans == drawn.maxTriangles) continue;
    const sim::Surface* const own = surfaceOf(drawn);
    const bool draws = step == Step::small || step == Step::large;  // others prepare, or have no fragments
    const bool cuts = draws && hasHoles(drawn);
    // These kernels are not compiled in advance: they take long to compile, and few plain triangles are
    // large or cross the near plane.
    if (gl::Rehearsal::now() && step != Step::small && !cuts && !fragments_.layers) continue;
    RasterVariant kind = variant(into, pass);
    RasterTriangles triangles = raster(drawn, into);
    if (into_ != Into::lampMap) kind.counted = drawn.surface->arguments != nullptr;
    if (joined_ != nullptr) triangles.owners = joined_->owners();
    if (cuts) {
      kind.cut = true;
      kind.grid = own->normals == nullptr;
      triangles.cutout = fragments_.holes(*own);
    }
    if (fragments_.layers && draws) {
      const Visibility& before = fragments_.before != nullptr ? *fragments_.before : *fragments_.behind;
      kind.layer = true;
      triangles.firstLayer = fragments_.before == nullptr;
      triangles.layerKeys = before.nearKeys();
      triangles.layerIds = before.numbers();
      triangles.opaqueKeys = fragments_.behind->nearKeys();
    }
    runKernel(step, clips, kind, triangles, drawn, [&](const auto& kernel, const auto& given) {
      if (step == Step::small && !kind.counted.on)
        kernel.dispatch(inRows(drawn.maxTriangles), given);
      else if (step == Step::medium)
        GroupCounts::dispatchFixed(kernel, 1, given);
      else if (step == Step::large)
        GroupCounts::dispatchList(kernel, clips ? roomlessGroups_ : largeGroups_, i,
                                  workgroupsFor(sizeOf(into, drawn.face.part), samples_, anyCut), given);
      else
        GroupCounts::dispatch(kernel, step == Step::small ? surfaceGroups_ : clipGroups_, i, given);
    });
  }
}

void TriangleRaster::runFaces(Step step, int pass, const Visibility& into, bool clips) {
  // A GPU runs some thousands of workgroups at the same time. This number is higher, because the number of
  // triangles differs much between faces and many workgroups therefore have no work.
  constexpr unsigned groups = 24576;
  constexpr unsigned fewParts = 16;  // workgroups per large triangle; most of these triangles are small
  const Drawn& first = entries_.front();
  if (clips && first.fans == first.maxTriangles) return;
  RasterVariant kind = variant(into, pass);
  kind.faces = step == Step::large ? 1 : 2;
  RasterTriangles triangles = raster(first, into);
  triangles.into.view = *faceViews_;
  triangles.firstView = firstView_;
  const auto faces = static_cast<GLuint>(entries_.size());
  const GLuint each = std::max(groups / faces, 1U);
  glm::ivec2 largest(0);
  for (const Drawn& drawn : entries_) largest = glm::max(largest, sizeOf(into, drawn.face.part));
  const unsigned parts = std::max(fewParts, minWorkgroups(largest, samples_));
  const auto needed = static_cast<GLuint>(first.maxTriangles) / groupTriangles + 1;
  runKernel(step, clips, kind, triangles, first, [&](const auto& kernel, const auto& given) {
    if (step == Step::large)
      kernel.dispatchGroups({std::max(each / parts, 1U), faces, parts}, given);
    else
      kernel.dispatchGroups({std::min(each, needed), 1U, faces}, given);
  });
}

void TriangleRaster::prepareLarge(glm::ivec2 size) {
  const bool cuts = anyHoles();
  const unsigned parts = workgroupsFor(size, samples_, cuts);
  const int draws = static_cast<int>(entries_.size());
  GroupCounts::CountConversion order{
      .firstCount = binned_ && into_ != Into::sunMap ? draws : 0,
      .counts = draws,
      .parts = parts,
      .minGroupsZ = gl::softwareDriver() ? minWorkgroups(size, samples_, cuts) : parts};
  if (into_ != Into::sunMap && fanRoom_ > 0) {
    // Splits each list into the entries that have a clipped triangle (fan) and the entries that have none.
    const auto room = static_cast<unsigned>(fanRoom_ / static_cast<int>(entries_.size()));
    order.maximum = room;
    GroupCounts::CountConversion others = order;
    others.maximum = ~0U;
    others.skipped = room;
    groups_.prepareLists(counters_, others, roomlessGroups_);
  }
  groups_.prepareLists(counters_, order,
                       into_ != Into::sunMap && fanRoom_ == 0 ? roomlessGroups_ : largeGroups_);
}

void TriangleRaster::runLists(int pass, const Visibility& into) {
  if (mediumPixels_ > smallPixels_) run(Step::medium, pass, into);
  if (into_ == Into::sunMap || fanRoom_ > 0) run(Step::large, pass, into);
  if (into_ != Into::sunMap) run(Step::large, pass, into, true);
}

void TriangleRaster::fillGroups() {
  if (faceViews_ != nullptr) return;
  if (into_ == Into::lampMap) {
    groups_.fill(*lists_.counts, {.counts = static_cast<int>(entries_.size()), .each = groupTriangles},
                 surfaceGroups_);
    return;
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const sim::Surface& surface = *entries_[i].surface;
    if (surface.arguments == nullptr) continue;
    groups_.fill(*surface.arguments, {.first = static_cast<int>(i), .each = 3 * groupTriangles},
                 surfaceGroups_);
  }
}

void TriangleRaster::drawBinned(const Visibility& into) {
  if (into_ != Into::lampMap) return bins_.draw(into_, into);
  bins_.draw(into_, into,
             [&](int face) -> const MapFace& { return entries_[static_cast<std::size_t>(face)].face; });
}

void TriangleRaster::draw(const Visibility& into, const MapPart& part) {
  entries_ = drawn_;
  joined_ = nullptr;
  drawEntries(into, part);
}

void TriangleRaster::drawJoined(const Visibility& into, const JoinedSurfaces& joined) {
  const sim::Surface& surface = joined.surface();
  joinedEntry_.surface = &surface;
  joinedEntry_.maxTriangles = maxTrianglesOf(surface);
  if (joinedEntry_.indices)
    joinedEntry_.indices.attach(*surface.indices, sizeof(GLuint));
  else
    joinedEntry_.indices = gl::Texture::view("joined indices", GL_R32UI, *surface.indices, sizeof(GLuint));
  joinedEntry_.fans = std::min(joinedEntry_.maxTriangles, fanRoom_);
  reserveLists(1, joinedEntry_.maxTriangles, joinedEntry_.fans);
  entries_ = {&joinedEntry_, 1};
  joined_ = &joined;
  drawEntries(into, {});
}

void TriangleRaster::drawNearest(const Visibility& into) {
  entries_ = drawn_;
  joined_ = nullptr;
  if (!entries_.empty()) drawNearestOfEntries(into, {});
}

void TriangleRaster::drawIds(const Visibility& into) {
  if (!entries_.empty()) drawIdsOfEntries(into);
}

void TriangleRaster::drawEntries(const Visibility& into, const MapPart& part) {
  if (entries_.empty()) return;
  drawNearestOfEntries(into, part);
  drawIdsOfEntries(into);
}

void TriangleRaster::drawNearestOfEntries(const Visibility& into, const MapPart& part) {
  constexpr GLuint zero = 0;
  glClearNamedBufferData(counters_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  glm::ivec2 largest(0);
  if (into_ != Into::lampMap) {
    for (Drawn& drawn : entries_) drawn.face.part = part;
    makeVertices(into);
  }
  for (const Drawn& drawn : entries_) largest = glm::max(largest, sizeOf(into, drawn.face.part));
  const Drawn& last = entries_.back();
  const int faces = into_ == Into::lampMap ? static_cast<int>(entries_.size()) : 0;
  const int triangles = faces > 0 ? last.maxTriangles : last.firstIndex / 3 + last.maxTriangles;
  binned_ = binRoom_ > 0 && (into_ == Into::sunMap || fanRoom_ > 0) && mediumPixels_ <= smallPixels_ &&
            faceViews_ == nullptr && into.layout() == SampleLayout::separate &&
            TriangleBins::holds(triangles, faces);
  if (binned_ && into_ != Into::sunMap)
    reserve(left_, leftView_, "large triangles left", large_.bytes(), GL_R32UI, sizeof(GLuint));
  if (binned_) bins_.begin(largest, triangles, binRoom_, faces);
  fillGroups();
  run(Step::small, 0, into);
  clipLarge(into);
  prepareLarge(largest);
  runLists(0, into);
  gl::barrier();
  if (binned_) drawBinned(into);
}

void TriangleRaster::drawIdsOfEntries(const Visibility& into) {
  if (into_ != Into::picture || into.layout() == SampleLayout::wholes) return;
  if (!binned_) run(Step::small, 1, into);
  runLists(1, into);
  gl::barrier();
}

}  // namespace simreel::draw
