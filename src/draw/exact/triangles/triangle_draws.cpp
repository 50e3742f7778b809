// What a TriangleRaster runs, pass by pass.
#include "draw/exact/bindings.hpp"
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

/// Of the part that is drawn (pixels).
glm::ivec2 sizeOf(const Visibility& into, const MapPart& part) {
  return part.side > 0 ? glm::ivec2(part.side) : into.size();
}

}  // namespace

void TriangleRaster::clipLarge(const Visibility& into) {
  if (into_ == Into::sunMap || fanRoom_ == 0) return;
  gl::barrier();
  if (faceViews_ == nullptr) {
    groups_.fill(counters_, {.counts = static_cast<int>(asked_.size()), .each = groupTriangles},
                 clipGroups_);
    gl::barrier();
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  }
  fans_.bindStorage(fanBinding);
  run(clipPath, 0, into);
}

void TriangleRaster::tell(const gl::Program& kernel, const Visibility& into, const MapPart& part) const {
  kernel.set("draws", static_cast<int>(asked_.size()));
  kernel.set("smallPixels", smallPixels_);
  kernel.set("mediumPixels", mediumPixels_);
  kernel.set("mapTexels", into.size().x);
  part.set(kernel);
}

void TriangleRaster::run(const char* path, int pass, const Visibility& into, bool clips) {
  into.bind();
  const bool ofLeft = binned_ && into_ != Into::sunMap;
  (ofLeft && path == clipPath ? left_ : large_).bindStorage(largeBinding);
  (ofLeft && path == largePath ? leftView_ : largeView_).bind(largeUnit);
  counters_.bindStorage(counterBinding);
  counterView_.bind(counterUnit);
  if (into_ != Into::sunMap) fanView_.bind(fanUnit);
  const bool small = path == trianglesPath;
  const gl::Buffer& groups = small ? surfaceGroups_ : path == clipPath ? clipGroups_ : largeGroups_;
  if (joined_ != nullptr) joined_->bind();
  if (faceViews_ != nullptr) return runFaces(path, pass, into, clips);
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const Drawn& drawn = asked_[i];
    if (clips && drawn.fans == drawn.maxTriangles) continue;
    const MapPart& part = drawn.face.part;
    const bool counted = into_ == Into::lampMap || drawn.surface->arguments != nullptr;
    const bool doubleSided = into_ == Into::lampMap || drawn.surface->doubleSided;
    const bool bins = binned_ && path != mediumPath;
    const sim::Surface* const own = into_ == Into::lampMap ? fragments_.only : drawn.surface;
    const bool cuts = path == largePath && own != nullptr && fragments_.cut && fragments_.cut(*own);
    // Few plain triangles are large or cut by the near plane, and those kernels are dear to compile.
    if (gl::Rehearsal::now() && path != trianglesPath && !cuts && !fragments_.layers) continue;
    const gl::Program& kernel = program({.path = path,
                                         .pass = pass,
                                         .layout = into.layout(),
                                         .counted = counted,
                                         .clips = clips,
                                         .bins = bins,
                                         .joined = joined_ != nullptr,
                                         .cut = cuts,
                                         .grid = cuts && own->normals == nullptr,
                                         .layer = path == largePath && fragments_.layers});
    bind(drawn, kernel);
    if (cuts) fragments_.tell(*own, kernel);
    if (fragments_.layers && path == largePath) tellLayers(kernel);
    if (bins) bins_.bind(kernel, drawn.list);
    kernel.set("doubleSided", static_cast<int>(doubleSided));
    kernel.set("draw_", static_cast<int>(i));
    tell(kernel, into, part);
    if (small && !counted) {
      dispatchRows(kernel, drawn.maxTriangles);
      continue;
    }
    if (path == mediumPath) {
      GroupCounts::dispatchFixed(kernel);
    } else if (path == largePath) {
      GroupCounts::dispatchList(kernel, clips ? roomlessGroups_ : largeGroups_, i,
                                partsFor(sizeOf(into, part), samples_));
    } else {
      GroupCounts::dispatch(kernel, groups, i);
    }
  }
}

void TriangleRaster::runFaces(const char* path, int pass, const Visibility& into, bool clips) {
  // A card's processors hold some thousands at a time; faces differ much in what they show, and many groups
  // find nothing.
  constexpr unsigned groups = 24576;
  constexpr unsigned fewParts = 16;  // of a large triangle: most are small among those
  const Drawn& first = asked_.front();
  if (clips && first.fans == first.maxTriangles) return;
  const gl::Program& kernel = program({.path = path,
                                       .pass = pass,
                                       .layout = into.layout(),
                                       .counted = true,
                                       .clips = clips,
                                       .faces = true});
  bind(first, kernel);
  faceViews_->bindUniform(viewBinding, 0, faceViews_->bytes());
  kernel.set("firstView", firstView_);
  kernel.set("doubleSided", 1);
  tell(kernel, into, first.face.part);
  const auto faces = static_cast<GLuint>(asked_.size());
  const GLuint each = std::max(groups / faces, 1U);
  glm::ivec2 largest(0);
  for (const Drawn& drawn : asked_) largest = glm::max(largest, sizeOf(into, drawn.face.part));
  if (path == largePath) {
    const unsigned parts = std::max(fewParts, leastParts(largest, samples_));
    kernel.dispatchGroups(std::max(each / parts, 1U), faces, parts);
  } else {
    const auto needed = static_cast<GLuint>(first.maxTriangles) / groupTriangles + 1;
    kernel.dispatchGroups(std::min(each, needed), 1, faces);
  }
}

void TriangleRaster::prepareLarge(glm::ivec2 size) {
  const unsigned parts = partsFor(size, samples_);
  const int draws = static_cast<int>(asked_.size());
  GroupCounts::Order order{.firstCount = binned_ && into_ != Into::sunMap ? draws : 0,
                           .counts = draws,
                           .parts = parts,
                           .fewerParts = gl::softwareDriver() ? leastParts(size, samples_) : parts};
  if (into_ != Into::sunMap && fanRoom_ > 0) {
    // Of each list those that have a fan, and the others apart.
    const auto room = static_cast<unsigned>(fanRoom_ / static_cast<int>(asked_.size()));
    order.most = room;
    GroupCounts::Order others = order;
    others.most = ~0U;
    others.skipped = room;
    groups_.prepareLists(counters_, others, roomlessGroups_);
  }
  groups_.prepareLists(counters_, order,
                       into_ != Into::sunMap && fanRoom_ == 0 ? roomlessGroups_ : largeGroups_);
}

void TriangleRaster::runLists(int pass, const Visibility& into) {
  if (mediumPixels_ > smallPixels_) run(mediumPath, pass, into);
  if (into_ == Into::sunMap || fanRoom_ > 0) run(largePath, pass, into);
  if (into_ != Into::sunMap) run(largePath, pass, into, true);
}

void TriangleRaster::fillGroups() {
  if (faceViews_ != nullptr) return;
  if (into_ == Into::lampMap) {
    groups_.fill(*lists_.counts, {.counts = static_cast<int>(asked_.size()), .each = groupTriangles},
                 surfaceGroups_);
    return;
  }
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const sim::Surface& surface = *asked_[i].surface;
    if (surface.arguments == nullptr) continue;
    groups_.fill(*surface.arguments, {.first = static_cast<int>(i), .each = 3 * groupTriangles},
                 surfaceGroups_);
  }
}

void TriangleRaster::drawBinned(const Visibility& into) {
  if (into_ != Into::lampMap) return bins_.draw(into);
  bins_.draw(into, [&](int face, const gl::Program& program) {
    const MapFace& map = asked_[static_cast<std::size_t>(face)].face;
    map.views->bindUniform(viewBinding, map.view, viewBytes);
    map.part.set(program);
  });
}

void TriangleRaster::draw(const Visibility& into, const MapPart& part) {
  asked_ = drawn_;
  joined_ = nullptr;
  drawAsked(into, part);
}

void TriangleRaster::drawJoined(const Visibility& into, const JoinedSurfaces& joined) {
  const sim::Surface& surface = joined.surface();
  whole_.surface = &surface;
  whole_.maxTriangles = maxTrianglesOf(surface);
  if (whole_.indices)
    whole_.indices.show(*surface.indices, sizeof(GLuint));
  else
    whole_.indices = gl::Texture::view("joined indices", GL_R32UI, *surface.indices, sizeof(GLuint));
  whole_.fans = std::min(whole_.maxTriangles, fanRoom_);
  reserveLists(1, whole_.maxTriangles, whole_.fans);
  asked_ = {&whole_, 1};
  joined_ = &joined;
  drawAsked(into, {});
}

void TriangleRaster::tellLayers(const gl::Program& kernel) const {
  kernel.set("firstLayer", static_cast<int>(fragments_.before == nullptr));
  const Visibility& before = fragments_.before != nullptr ? *fragments_.before : *fragments_.behind;
  before.nearKeys().bind(layerNearUnit);
  if (before.layout() == SampleLayout::apart) before.numbers().bind(layerIdUnit);
  fragments_.behind->nearKeys().bind(behindUnit);
}

void TriangleRaster::drawNearest(const Visibility& into) {
  asked_ = drawn_;
  joined_ = nullptr;
  if (!asked_.empty()) drawNearestAsked(into, {});
}

void TriangleRaster::drawNumbers(const Visibility& into) {
  if (!asked_.empty()) drawNumbersAsked(into);
}

void TriangleRaster::drawAsked(const Visibility& into, const MapPart& part) {
  if (asked_.empty()) return;
  drawNearestAsked(into, part);
  drawNumbersAsked(into);
}

void TriangleRaster::drawNearestAsked(const Visibility& into, const MapPart& part) {
  constexpr GLuint zero = 0;
  glClearNamedBufferData(counters_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  glm::ivec2 largest(0);
  if (into_ != Into::lampMap) {
    for (Drawn& drawn : asked_) drawn.face.part = part;
    makeVertices(into);
  }
  for (const Drawn& drawn : asked_) largest = glm::max(largest, sizeOf(into, drawn.face.part));
  const Drawn& last = asked_.back();
  const int faces = into_ == Into::lampMap ? static_cast<int>(asked_.size()) : 0;
  const int triangles = faces > 0 ? last.maxTriangles : last.firstIndex / 3 + last.maxTriangles;
  binned_ = binRoom_ > 0 && (into_ == Into::sunMap || fanRoom_ > 0) && mediumPixels_ <= smallPixels_ &&
            faceViews_ == nullptr && into.layout() == SampleLayout::apart &&
            TriangleBins::holds(triangles, faces);
  if (binned_ && into_ != Into::sunMap)
    reserve(left_, leftView_, "large triangles left", large_.bytes(), GL_R32UI, sizeof(GLuint));
  if (binned_) bins_.begin(largest, triangles, binRoom_, faces);
  fillGroups();
  gl::barrier();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  run(trianglesPath, 0, into);
  clipLarge(into);
  prepareLarge(largest);
  runLists(0, into);
  gl::barrier();
  if (binned_) drawBinned(into);
}

void TriangleRaster::drawNumbersAsked(const Visibility& into) {
  if (into_ != Into::picture || into.layout() == SampleLayout::wholes) return;
  if (!binned_) run(trianglesPath, 1, into);
  runLists(1, into);
  gl::barrier();
}

}  // namespace simreel::draw
