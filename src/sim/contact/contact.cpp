#include "sim/contact/contact.hpp"

#include "base/error.hpp"
#include "gl/access_together.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace simreel::shader::contact {
#include "glsl/contact/bindings.glsl"
}  // namespace simreel::shader::contact

namespace simreel::sim {

namespace {

namespace at = shader::contact;

constexpr int holdRounds = 4;  ///< Number of rounds, each of which dispatches hold.comp once.
constexpr std::size_t pairLimitWord = 5;

/// Checks the device limits, before any array is allocated or filled.
void checkLimits(std::size_t vertices) {
  const std::size_t bytes = vertices * at::pointSections * 16;
  const auto max = static_cast<std::size_t>(gl::limits().storageBlockBytes);
  if (bytes > max)
    fail(ExitCode::device,
         "cloths in contact and the meshes and bodies that they touch have {} vertices together, which "
         "need {} "
         "bytes, this device allows {} in one buffer (GL_MAX_SHADER_STORAGE_BLOCK_SIZE); simplify them",
         vertices, bytes, max);
}

}  // namespace

Contact::Contact(ContactPlan plan, int substeps, bool fast) : plan_(std::move(plan)), stepCount_(substeps) {
  const auto vertices = static_cast<std::size_t>(plan_.vertices());
  checkLimits(vertices);
  std::vector<glm::vec4> points(vertices * at::pointSections, glm::vec4(0));
  for (std::size_t i = 0; i < vertices; ++i) points[at::skinSection * vertices + i] = plan_.skins()[i];
  points_ = gl::Vec4Array("contact points", points);
  tallies_ = gl::WordsArray("contact tallies", static_cast<int>(vertices * at::tallySections));
  const auto treeOver = [](const std::vector<glm::uvec4>& leaves, int levels) {
    return Tree{levels, gl::WordsArray("contact leaves", leaves),
                gl::Vec4Array("contact boxes", static_cast<int>(4 * leaves.size()))};
  };
  faces_ = treeOver(plan_.faces(), plan_.faceLevels());
  edges_ = treeOver(plan_.edges(), plan_.edgeLevels());
  control_ = gl::Buffer("contact control",
                        4 * at::countWords + std::size_t{16} * (at::levelDispatch + at::maxLevels));
  steps_ = StepBlocks<shader::ContactStep>("contact steps", substeps);
  allocate(std::max(2 * plan_.vertices(), 1 << 15));  // Initial capacity of the pair list, which grows with
                                                      // the number of pairs.
  makeKernels(fast);
}

void Contact::makeKernels(bool fast) {
  gl::Defines defines = gl::kernelDefines(fast);
  if (plan_.movable() == plan_.vertices()) defines.emplace_back("NO_SOLIDS", "1");
  if (plan_.balls() == plan_.movable()) defines.emplace_back("NO_BALLS", "1");
  const auto make = [&](auto& kernel, const auto&... variant) {
    kernel = std::remove_cvref_t<decltype(kernel)>(defines, variant...);
  };
  make(gather_);
  make(begin_);
  make(reach_);
  make(leafBoxes_);
  make(searchVertices_);
  make(searchEdges_, ContactPairs{true});
  make(candidateLists_, ContactLists::Variant{.near = false, .candidates = true});
  make(pairLists_);
  make(nearList_, ContactLists::Variant{.near = true, .candidates = false});
  make(siftVertices_);
  make(siftEdges_, ContactPairs{true});
  make(nearVertices_);
  make(nearEdges_, ContactPairs{true});
  make(claim_);
  make(push_);
  make(apply_);
  make(hand_);
  make(readBack_);
  make(hold_);
  make(leave_);
  for (int i = 0; i < static_cast<int>(std::size(refit_)); ++i)
    make(refit_[i], ContactRefit::Variant{i + 1});
  make(start_);
  make(spread_);
}

void Contact::allocate(int pairs) {
  maxPairs_ = pairs;
  const auto count = static_cast<std::size_t>(pairs);
  pairs_ = gl::WordsArray("contact pairs", gl::Buffer("contact pairs", 2 * count * 16));
  candidates_ = gl::WordsArray("contact candidates", gl::Buffer("contact candidates", 2 * count * 16));
  corners_ = gl::WordsArray("contact corners", gl::Buffer("contact corners", count * 16));
  nears_ = gl::Vec4Array("contact nears", gl::Buffer("contact nears", 3 * count * 16));
}

void Contact::beginFrame(std::span<const Part> parts) {
  if (saved_.empty())
    for (const Part& part : cloths(parts))
      for (const gl::Vec4Array* array : {part.now, part.velocities, part.trends})
        if (array != nullptr) saved_.emplace_back("contact before a frame", array->buffer().bytes());
  copySaved(parts, true);
  uploadSteps();
}

void Contact::copySaved(std::span<const Part> parts, bool saving) const {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::size_t i = 0;
  for (const Part& part : cloths(parts))
    for (const gl::Vec4Array* array : {part.now, part.velocities, part.trends}) {
      if (array == nullptr) continue;
      const gl::Buffer& own = array->buffer();
      const gl::Buffer& saved = saved_[i++];
      glCopyNamedBufferSubData(saving ? own.name() : saved.name(), saving ? saved.name() : own.name(), 0, 0,
                               static_cast<GLsizeiptr>(own.bytes()));
    }
  gl::barrier();
}

void Contact::uploadSteps() {
  std::vector<shader::ContactStep> steps;
  steps.reserve(static_cast<std::size_t>(stepCount_));
  for (int i = 0; i < stepCount_; ++i) steps.push_back(plan_.step(i == 0, maxPairs_));
  steps_.upload(steps);
}

bool Contact::endFrame() {
  unsigned maximum = 0;
  gl::barrier();
  control_.read(4 * pairLimitWord, std::as_writable_bytes(std::span(&maximum, 1)));
  if (maximum == ~0U)
    fail(ExitCode::device,
         "cloths in contact: the search for neighbours took too long, because too much cloth is crumpled "
         "in one place; use more substeps or slower motion");
  const bool enough = maximum <= static_cast<unsigned>(maxPairs_);
  // Keeps the capacity at twice the number of pairs or more. A frame seldom has more than twice as many
  // pairs as the previous frame.
  int wanted = maxPairs_;
  while (maximum > static_cast<unsigned>(wanted / 2)) wanted *= 2;
  if (wanted > maxPairs_) {
    allocate(wanted);
    const unsigned none = 0;
    control_.write(4 * pairLimitWord, std::as_bytes(std::span(&none, 1)));
    uploadSteps();
  }
  return enough;
}

template <class Interface>
void Contact::dispatchIndirect(const gl::Kernel<Interface>& kernel, int number,
                               const Interface& given) const {
  kernel.dispatchIndirect(control_, 4 * at::countWords + std::size_t{16} * static_cast<std::size_t>(number),
                          given);
}

ContactShared Contact::shared(int index) const {
  return {.step = steps_.at(static_cast<std::size_t>(index)), .points = points_, .control = control_};
}

ContactNearList Contact::nearList() const {
  return {.corners = corners_, .nears = nears_, .tallies = tallies_.buffer(), .tallyTexels = tallies_};
}

void Contact::fit(const ContactShared& shared) const {
  struct Fitting {
    const Tree* tree;
    int dispatch;
    int levels;  ///< Number of tree levels whose boxes are still to be recomputed.
  };
  Fitting fittings[] = {{&faces_, at::faceDispatch, faces_.levels},
                        {&edges_, at::edgeDispatch, edges_.levels}};
  {
    const gl::AccessTogether together;
    for (const Fitting& f : fittings)
      dispatchIndirect(leafBoxes_, f.dispatch,
                       {shared, f.tree->levels, f.tree->leaves, f.tree->boxes.buffer()});
  }
  while (fittings[0].levels > 0 || fittings[1].levels > 0) {
    const gl::AccessTogether together;
    for (Fitting& f : fittings) {
      const int levels = std::min(f.levels, static_cast<int>(std::size(refit_)));
      if (levels == 0) continue;
      f.levels -= levels;
      dispatchIndirect(refit_[levels - 1], at::levelDispatch + f.levels,
                       {shared, f.levels, f.tree->levels, f.tree->boxes});
    }
  }
}

void Contact::search(const ContactShared& shared) const {
  begin_.dispatch(1, {shared});
  dispatchIndirect(reach_, at::vertexDispatch, {shared});
  fit(shared);
  {
    const gl::AccessTogether together;
    const auto walk = [&](const gl::Kernel<ContactSearch>& kernel, const Tree& tree, int dispatch) {
      dispatchIndirect(kernel, dispatch,
                       {shared, tree.levels, tree.leaves, tree.boxes, candidates_.buffer()});
    };
    walk(searchVertices_, faces_, at::vertexDispatch);
    walk(searchEdges_, edges_, at::edgeDispatch);
  }
  candidateLists_.dispatch(1, {shared});
  {
    const gl::AccessTogether together;
    const ContactSift given = {shared, candidates_, pairs_.buffer()};
    dispatchIndirect(siftVertices_, at::vertexCandidateDispatch, given);
    dispatchIndirect(siftEdges_, at::edgeCandidateDispatch, given);
  }
  pairLists_.dispatch(1, {shared});
}

std::span<const Contact::Part> Contact::cloths(std::span<const Part> parts) const {
  const auto firstSolid = std::lower_bound(plan_.firsts().begin(), plan_.firsts().end(), plan_.movable());
  return parts.first(static_cast<std::size_t>(firstSolid - plan_.firsts().begin()));
}

template <class Run>
void Contact::forParts(std::span<const Part> parts, const Run& run) const {
  const gl::AccessTogether together;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto count = static_cast<int>(parts[i].now->buffer().bytes() / 16);
    run(parts[i], ContactRange{plan_.firsts()[i], count}, count);
  }
}

/// Computes the positions to which vertices can be held back: their positions at the start, displaced by
/// moving solids and, in carryRounds rounds, by cloth that solids push.
void Contact::carry(const ContactShared& shared) const {
  if (plan_.movable() == plan_.vertices()) return;
  for (int round = 0; round <= ContactPlan::carryRounds; ++round) {
    if (round > 0) dispatchIndirect(spread_, at::carryDispatch, {shared, nearList()});
    dispatchIndirect(start_, at::startDispatch, {shared, tallies_.buffer()});
  }
}

void Contact::push(int index, std::span<const Part> parts) {
  SIMREEL_CHECK(parts.size() == plan_.firsts().size());
  const ContactShared given = shared(index);
  const gl::Buffer& tallies = tallies_.buffer();
  gl::barrier();
  forParts(parts, [&](const Part& part, const ContactRange& range, int count) {
    gather_.dispatch(count, {given, range, *part.now, *part.next, tallies});
  });
  search(given);
  {
    const gl::AccessTogether together;
    const ContactNear near = {given, pairs_, corners_.buffer(), nears_.buffer(), tallies};
    dispatchIndirect(nearVertices_, at::vertexPairDispatch, near);
    dispatchIndirect(nearEdges_, at::edgePairDispatch, near);
  }
  nearList_.dispatch(1, {given});
  carry(given);
  for (int round = 0; round < plan_.rounds(); ++round) {
    dispatchIndirect(claim_, at::nearDispatch, {given, nearList()});
    dispatchIndirect(push_, at::nearDispatch, {given, nearList()});
    apply_.dispatch(plan_.movable(), {given, tallies});
  }
  forParts(cloths(parts), [&](const Part& part, const ContactRange& range, int count) {
    hand_.dispatch(count, {given, range, *part.next, *part.velocities});
  });
}

void Contact::hold(int index, std::span<const Part> parts) {
  const ContactShared given = shared(index);
  gl::barrier();
  forParts(parts, [&](const Part& part, const ContactRange& range, int count) {
    readBack_.dispatch(count, {given, range, *part.next});
  });
  for (int round = 0; round < holdRounds; ++round)
    dispatchIndirect(hold_, at::nearDispatch, {given, nearList(), round});
  forParts(cloths(parts), [&](const Part& part, const ContactRange& range, int count) {
    leave_.dispatch(count, {given, range, *part.next, *part.velocities, tallies_.buffer()});
  });
}

}  // namespace simreel::sim
