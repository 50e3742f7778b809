#include "draw/exact/triangles/triangle_raster.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace simreel::draw {

namespace {

constexpr const char* trianglesPath = "draw/exact/triangles/triangles.comp";
constexpr const char* mediumPath = "draw/exact/triangles/medium.comp";
constexpr const char* largePath = "draw/exact/triangles/large.comp";
constexpr const char* clipPath = "draw/exact/triangles/clip_large.comp";
constexpr unsigned groupTriangles = 64;
constexpr std::int64_t maxIds = 0xfffffff0;  // the last ones say ground, and nothing

/// Of the part that is drawn (pixels).
glm::ivec2 sizeOf(const Visibility& into, const MapPart& part) {
  return part.side > 0 ? glm::ivec2(part.side) : into.size();
}

constexpr std::size_t viewBytes = sizeof(shader::ExactView);

}  // namespace

TriangleRaster::TriangleRaster(Into into, int samples, int smallPixels, int fanRoom, int mediumPixels,
                               int binRoom)
    : into_(into),
      samples_(samples),
      smallPixels_(smallPixels),
      fanRoom_(fanRoom),
      mediumPixels_(mediumPixels),
      binRoom_(binRoom),
      bins_(intoDefines(), samples) {}

void TriangleRaster::number(const std::vector<const sim::Surface*>& surfaces, unsigned firstId) {
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  int fans = 0;
  drawn_.resize(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const sim::Surface* surface = surfaces[i];
    Drawn& next = drawn_[i];
    next.surface = surface;
    next.firstVertex = static_cast<int>(vertices);
    next.firstIndex = static_cast<int>(3 * triangles);
    next.maxTriangles = maxTrianglesOf(*surface);
    next.firstId = firstId + static_cast<unsigned>(triangles);
    if (next.indices)
      next.indices.show(*surface->indices, sizeof(GLuint));
    else
      next.indices = gl::Texture::view("indices", GL_R32UI, *surface->indices, sizeof(GLuint));
    next.firstFan = fans;
    next.fans = std::min(next.maxTriangles, fanRoom_ / static_cast<int>(surfaces.size()));
    fans += next.fans;
    vertices += verticesOf(*surface);
    triangles += next.maxTriangles;
    if (3 * triangles > INT32_MAX || vertices > INT32_MAX || firstId + triangles > maxIds)
      fail(ExitCode::device,
           "the exact rasterizer numbers {} triangles of one picture, and these are more; set "
           "\"rasterizer\" "
           "to \"driver\"",
           INT32_MAX / 3);
  }
  reserve(vertices_, vertexView_, "vertices on the picture", static_cast<std::size_t>(vertices) * 16,
          GL_RGBA32UI, 16);
  reserveLists(surfaces.size(), triangles, fans);
}

void TriangleRaster::number(const TriangleLists& lists, const std::vector<MapFace>& faces,
                            const gl::Buffer& views, int first) {
  number(lists, faces);
  faceViews_ = &views;
  firstView_ = first;
}

void TriangleRaster::number(const TriangleLists& lists, const std::vector<MapFace>& faces) {
  lists_ = lists;
  faceViews_ = nullptr;
  drawn_.resize(faces.size());
  const int fans = std::min(lists.room, fanRoom_ / std::max(static_cast<int>(faces.size()), 1));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const int number = static_cast<int>(i);
    Drawn& next = drawn_[i];
    next.list = number;
    next.firstIndex = 3 * number * lists.room;
    next.maxTriangles = lists.room;
    next.firstFan = number * fans;
    next.fans = fans;
    next.face = faces[i];
  }
  const auto count = static_cast<std::int64_t>(faces.size());
  reserveLists(faces.size(), count * lists.room, static_cast<int>(count) * fans);
}

void TriangleRaster::reserveLists(std::size_t draws, std::int64_t triangles, int fans) {
  reserve(large_, largeView_, "large triangles", static_cast<std::size_t>(triangles) * sizeof(GLuint),
          GL_R32UI, sizeof(GLuint));
  reserve(counters_, counterView_, "counts of large triangles", 2 * draws * sizeof(GLuint), GL_R32UI,
          sizeof(GLuint));
  reserve(largeGroups_, "groups for large triangles", draws * GroupCounts::bytes);
  reserve(surfaceGroups_, "groups for triangles", draws * GroupCounts::bytes);
  if (into_ == Into::sunMap) return;  // never clipped
  reserve(clipGroups_, "groups for clipping", draws * GroupCounts::bytes);
  reserve(roomlessGroups_, "groups for triangles not clipped", draws * GroupCounts::bytes);
  reserve(fans_, fanView_, "clipped triangles", static_cast<std::size_t>(fans) * 128, GL_RGBA32UI, 16);
}

const gl::Program& TriangleRaster::vertexProgram(const sim::Surface& surface, bool parallel) {
  const std::array<bool, 3> key{surface.normals == nullptr, surface.deform != nullptr, parallel};
  const auto found = vertexPrograms_.find(key);
  if (found != vertexPrograms_.end()) return found->second;
  gl::Defines defines;
  if (key[0]) defines.emplace_back("GRID", "1");
  if (key[1]) defines.emplace_back("DEFORMED", "1");
  if (parallel) defines.emplace_back("PARALLEL", "1");
  if (into_ == Into::sunMap) defines.emplace_back("SUN_MAP", "1");
  return vertexPrograms_.emplace(key, gl::Program::compute("draw/exact/triangles/vertices.comp", defines))
      .first->second;
}

gl::Defines TriangleRaster::intoDefines() const {
  if (into_ == Into::picture) return {};
  return {{into_ == Into::sunMap ? "SUN_MAP" : "LAMP_MAP", "1"}};
}

const gl::Program& TriangleRaster::program(const Variant& variant) {
  const auto found = programs_.find(variant);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = {{"SAMPLES", std::to_string(samples_)}, {"PASS", std::to_string(variant.pass)}};
  for (const auto& define : definesOf(variant.layout)) defines.push_back(define);
  if (variant.path == trianglesPath)
    for (const auto& define : laneDefines()) defines.push_back(define);
  if (variant.counted) defines.emplace_back("COUNTED", "1");
  if (variant.clips) defines.emplace_back("CLIPS", "1");
  if (variant.bins) defines.emplace_back("BINS", "1");
  if (variant.joined) defines.emplace_back("JOINED", "1");
  if (variant.faces)
    defines.emplace_back("FACES", variant.path == largePath ? "gl_WorkGroupID.y" : "gl_WorkGroupID.z");
  if (variant.cut) defines.emplace_back("CUTOUT", "1");
  if (variant.cut && variant.grid) defines.emplace_back("GRID", "1");
  if (variant.layer) defines.emplace_back("LAYER", "1");
  for (const auto& define : intoDefines()) defines.push_back(define);
  return programs_.emplace(variant, gl::Program::compute(variant.path, defines)).first->second;
}

void TriangleRaster::makeVertices(const Visibility& into) {
  vertices_.bindStorage(outVertexBinding);
  for (const Drawn& drawn : asked_) {
    const sim::Surface& surface = *drawn.surface;
    const gl::Program& program = vertexProgram(surface, into.layout().parallel);
    program.set("model", surface.model);
    program.set("grid", surface.grid);
    program.set("vertexCount", verticesOf(surface));
    program.set("firstVertex", drawn.firstVertex);
    program.set("mapTexels", static_cast<float>(into.size().x));
    bindPositions(surface, program);
    if (surface.normals != nullptr) surface.normals->bind(normalUnit);
    bindDeformation(surface);
    dispatchRows(program, verticesOf(surface));
  }
}

void TriangleRaster::bind(const Drawn& drawn, const gl::Program& program) const {
  if (into_ == Into::lampMap) {
    lists_.places->bind(vertexUnit);
    lists_.indices->bind(indexUnit);
    lists_.numbers->bind(tileListUnit);
    lists_.counts->bindStorage(drawArgumentBinding);
    drawn.face.views->bindUniform(viewBinding, drawn.face.view, viewBytes);
    program.set("list", drawn.list);
  } else {
    vertexView_.bind(vertexUnit);
    drawn.indices.bind(indexUnit);
    if (drawn.surface->arguments != nullptr) drawn.surface->arguments->bindStorage(drawArgumentBinding);
  }
  program.set("rowOf", into_ == Into::lampMap ? glm::ivec2(0) : rowOf(*drawn.surface));
  program.set("firstVertex", drawn.firstVertex);
  program.set("firstIndex", drawn.firstIndex);
  program.set("triangleCount", drawn.maxTriangles);
  program.set("firstId", drawn.firstId);
  program.set("firstFan", drawn.firstFan);
  program.set("fanRoom", drawn.fans);
}

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
      kernel.use();
      GroupCounts::dispatch(groups, i);
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
  kernel.use();
  const auto faces = static_cast<GLuint>(asked_.size());
  const GLuint each = std::max(groups / faces, 1U);
  glm::ivec2 largest(0);
  for (const Drawn& drawn : asked_) largest = glm::max(largest, sizeOf(into, drawn.face.part));
  if (path == largePath) {
    const unsigned parts = std::max(fewParts, leastParts(largest, samples_));
    glDispatchCompute(std::max(each / parts, 1U), faces, parts);
  } else {
    const auto needed = static_cast<GLuint>(first.maxTriangles) / groupTriangles + 1;
    glDispatchCompute(std::min(each, needed), 1, faces);
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
