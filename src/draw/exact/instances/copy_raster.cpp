#include "draw/exact/instances/copy_raster.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/exact/parts.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

namespace {

constexpr const char* copiesPath = "draw/exact/copies/copies.comp";
constexpr const char* mediumCopiesPath = "draw/exact/copies/medium_copies.comp";
constexpr const char* largeCopiesPath = "draw/exact/copies/large_copies.comp";
constexpr unsigned groupPairs = 64;

void clear(const gl::Buffer& counts) {
  constexpr GLuint zero = 0;
  glClearNamedBufferData(counts.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

gl::Defines cullDefines(CopyRaster::Into into) {
  gl::Defines defines = laneDefines();
  if (into == CopyRaster::Into::sunMap) defines.emplace_back("SUN_MAP", "1");
  return defines;
}

}  // namespace

unsigned CopyRaster::pairsAtOnce() {
  return 1U << (gl::softwareDriver() ? 22U : 25U);
}

unsigned CopyRaster::Copies::triangles() const {
  const InstanceShape::Level& level = shape->levels()[0];
  return static_cast<unsigned>(level.indexCount / level.batch / 3);
}

const gl::Program& CopyRaster::program(const char* path, Pass pass, SampleKind layout) {
  const std::tuple<std::string, Pass, SampleKind> key{path, pass, layout};
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = {{"SAMPLES", std::to_string(samples_)},
                         {"PASS", pass == Pass::nearest ? "0" : "1"}};
  for (const auto& define : definesOf(layout)) defines.push_back(define);
  if (path == copiesPath)
    for (const auto& define : laneDefines()) defines.push_back(define);
  if (pass == Pass::light) defines.emplace_back("ADDS", "1");
  if (into_ == Into::sunMap) defines.emplace_back("SUN_MAP", "1");
  if (into_ == Into::lampMap) defines.emplace_back("LAMP_MAP", "1");
  return programs_.emplace(key, gl::Program::compute(path, defines)).first->second;
}

void CopyRaster::set(const gl::Program& program, const Copies& copies, unsigned firstId) {
  setInstance(program, *copies.instances, copies.shape->radius(), 0);
  gl::Texture& indices = indices_[copies.shape];
  if (!indices) indices = gl::Texture::view("indices", GL_R32UI, copies.shape->indices(), sizeof(GLuint));
  indices.bind(indexUnit);
  copies.shape->vertices().bind(shapeUnit);
  program.set("alongVelocity", static_cast<int>(copies.instances->alongVelocity));
  program.set("triangles", copies.triangles());
  program.set("capacity", copies.instances->capacity);
  program.set("firstId", firstId);
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
    const int most = static_cast<int>(std::max(pairs_ / triangles, 1U));
    listRoom_ = std::max(listRoom_, static_cast<std::size_t>(std::min(most, capacity)) * triangles);
    for (int skipped = 0; skipped < capacity; skipped += most) parts_.push_back({i, skipped, most});
  }
  const auto words = [](std::size_t count) { return count * sizeof(GLuint); };
  const std::size_t parts = parts_.size();
  reserve(listed_, listedView_, "copies in sight", words(static_cast<std::size_t>(all)), GL_R32UI, 4);
  reserve(counts_, countView_, "counts of copies", words(copies_.size()), GL_R32UI, 4);
  reserve(large_, largeView_, "large triangles of copies", words(listRoom_), GL_R32UI, 4);
  reserve(largeCounts_, largeCountView_, "counts of large triangles", words(2 * parts), GL_R32UI, 4);
  reserve(smallGroups_, "groups for copies", parts * GroupCounts::bytes);
  reserve(largeGroups_, "groups for large triangles", parts * GroupCounts::bytes);
  if (!cull_) cull_ = gl::Program::compute("draw/exact/copies/cull_copies.comp", cullDefines(into_));
  clear(counts_);
  gl::barrier();
  listed_.bindStorage(largeBinding);
  counts_.bindStorage(counterBinding);
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    set(cull_, copies_[i], 0);
    cull_.set("draw_", static_cast<int>(i));
    cull_.set("firstListed", firstListed_[i]);
    cull_.set("mapTexels", into.size().x);
    dispatchRows(cull_, copies_[i].instances->capacity);
  }
  gl::barrier();
  for (std::size_t part = 0; part < parts; ++part)
    groups_.fill(counts_,
                 {.first = static_cast<int>(part),
                  .firstCount = static_cast<int>(parts_[part].draw),
                  .skipped = static_cast<unsigned>(parts_[part].skipped),
                  .most = static_cast<unsigned>(parts_[part].most),
                  .times = copies_[parts_[part].draw].triangles(),
                  .each = groupPairs},
                 smallGroups_);
  gl::barrier();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
}

void CopyRaster::runPart(std::size_t number, Pass pass, const Visibility& into, const MapPart& map) {
  const Part& part = parts_[number];
  const Copies& copies = copies_[part.draw];
  const auto start = [&](const char* path) -> const gl::Program& {
    const gl::Program& kernel = program(path, pass, into.layout());
    set(kernel, copies, firstIds_[part.draw]);
    if (pass == Pass::light) colors_[part.draw].set(kernel, *copies.instances);
    kernel.set("firstListed", firstListed_[part.draw]);
    kernel.set("skipped", part.skipped);
    kernel.set("mostCopies", part.most);
    kernel.set("draw_", static_cast<int>(part.draw));
    kernel.set("part", static_cast<int>(number));
    kernel.set("parts", static_cast<int>(parts_.size()));
    kernel.set("listRoom", static_cast<int>(listRoom_));
    kernel.set("smallPixels", smallPixels_);
    kernel.set("mediumPixels", mediumPixels_);
    kernel.set("doubleSided", 1);
    kernel.set("mapTexels", into.size().x);
    map.set(kernel);
    return kernel;
  };
  large_.bindStorage(largeBinding);
  largeCounts_.bindStorage(counterBinding);
  countView_.bind(counterUnit);
  GroupCounts::dispatch(start(copiesPath), smallGroups_, number);
  const unsigned shares = partsFor(into.size(), samples_);
  groups_.prepareLists(
      largeCounts_,
      {.first = static_cast<int>(number), .firstCount = static_cast<int>(number), .parts = shares},
      largeGroups_);
  largeView_.bind(largeUnit);
  largeCountView_.bind(counterUnit);
  if (mediumPixels_ > smallPixels_) GroupCounts::dispatchFixed(start(mediumCopiesPath));
  GroupCounts::dispatchList(start(largeCopiesPath), largeGroups_, number, shares);
  gl::barrier();
}

void CopyRaster::run(Pass pass, const Visibility& into, const MapPart& map) {
  clear(largeCounts_);
  gl::barrier();
  if (pass != Pass::light) into.bind();
  into.nearKeys().bind(nearUnit);
  listedView_.bind(listUnit);
  for (std::size_t part = 0; part < parts_.size(); ++part) runPart(part, pass, into, map);
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

void CopyRaster::drawNumbers(const Visibility& into) {
  if (!copies_.empty() && into.layout() != SampleLayout::wholes) run(Pass::numbers, into, {});
}

void CopyRaster::addLight(const std::vector<Copies>& copies, const Visibility& into) {
  if (copies.empty()) return;
  colors_.resize(std::max(colors_.size(), copies.size()));
  for (std::size_t i = 0; i < copies.size(); ++i) colors_[i].update(*copies[i].instances);
  firstIds_.assign(copies.size(), 0U);
  list(copies, into);
  run(Pass::light, into, {});
}

}  // namespace simreel::draw
