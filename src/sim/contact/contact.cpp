#include "sim/contact/contact.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace simreel::shader::contact {
#include "glsl/contact/bindings.glsl"
}  // namespace simreel::shader::contact

namespace simreel::sim {

namespace {

namespace at = shader::contact;

constexpr int holdRounds = 4;  ///< hold.comp
constexpr std::size_t mostPairsWord = 5;

/// Before anything is filled.
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
  allocate(std::max(2 * plan_.vertices(), 1 << 15));  // which grows with what is there
  makePrograms(fast);
}

void Contact::makePrograms(bool fast) {
  gl::Defines defines = gl::kernelDefines(fast);
  if (plan_.movable() == plan_.vertices()) defines.emplace_back("NO_SOLIDS", "1");
  if (plan_.balls() == plan_.movable()) defines.emplace_back("NO_BALLS", "1");
  const auto make = [&](const char* name) { return gl::Program::compute(name, defines); };
  gather_ = make("contact/gather.comp");
  begin_ = make("contact/begin.comp");
  reach_ = make("contact/reach.comp");
  leafBoxes_ = make("contact/leaves.comp");
  searchVertices_ = make("contact/search.comp");
  pairLists_ = make("contact/lists.comp");
  siftVertices_ = make("contact/sift.comp");
  nearVertices_ = make("contact/near.comp");
  claim_ = make("contact/claim.comp");
  push_ = make("contact/push.comp");
  apply_ = make("contact/apply.comp");
  hand_ = make("contact/hand.comp");
  take_ = make("contact/take.comp");
  hold_ = make("contact/hold.comp");
  leave_ = make("contact/leave.comp");
  for (std::size_t i = 0; i < std::size(refit_); ++i) {
    defines.emplace_back("AT_ONCE", std::to_string(i + 1));
    refit_[i] = make("contact/refit.comp");
    defines.pop_back();
  }
  start_ = make("contact/start.comp");
  spread_ = make("contact/spread.comp");
  defines.emplace_back("NEAR", "1");
  nearList_ = make("contact/lists.comp");
  defines.back().first = "CANDIDATES";
  candidateLists_ = make("contact/lists.comp");
  defines.back().first = "EDGES";
  siftEdges_ = make("contact/sift.comp");
  searchEdges_ = make("contact/search.comp");
  nearEdges_ = make("contact/near.comp");
  begin_.checkUniformBlock("StepBlock", sizeof(shader::ContactStep));
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
  unsigned most = 0;
  gl::barrier();
  control_.read(4 * mostPairsWord, std::as_writable_bytes(std::span(&most, 1)));
  if (most == ~0U)
    fail(
        ExitCode::device,
        "cloths in contact: a search for what is near took too long, so much is crumpled in one place; use "
        "more substeps or slower motion");
  const bool enough = most <= static_cast<unsigned>(maxPairs_);
  // Twice what was needed, before it is: a frame seldom needs twice what the one before did.
  int wanted = maxPairs_;
  while (most > static_cast<unsigned>(wanted / 2)) wanted *= 2;
  if (wanted > maxPairs_) {
    allocate(wanted);
    const unsigned none = 0;
    control_.write(4 * mostPairsWord, std::as_bytes(std::span(&none, 1)));
    uploadSteps();
  }
  return enough;
}

void Contact::dispatchIndirect(const gl::Program& program, int number) const {
  program.dispatchIndirect(control_,
                           4 * at::countWords + std::size_t{16} * static_cast<std::size_t>(number));
}

void Contact::fit() const {
  struct Fitting {
    const Tree* tree;
    int dispatch;
    int levels;  ///< that are left to fit
  };
  Fitting fittings[] = {{&faces_, at::faceDispatch, faces_.levels},
                        {&edges_, at::edgeDispatch, edges_.levels}};
  for (const Fitting& f : fittings) {
    f.tree->leaves.bindInput(at::leavesBinding);
    f.tree->boxes.bindState(at::boxesBinding);
    leafBoxes_.set("levels", f.tree->levels);
    dispatchIndirect(leafBoxes_, f.dispatch);
  }
  while (fittings[0].levels > 0 || fittings[1].levels > 0) {
    gl::barrier();
    for (Fitting& f : fittings) {
      const int levels = std::min(f.levels, static_cast<int>(std::size(refit_)));
      if (levels == 0) continue;
      f.levels -= levels;
      const gl::Program& program = refit_[levels - 1];
      f.tree->boxes.bindState(at::boxesBinding);
      program.set("levels", f.tree->levels);
      program.set("level", f.levels);
      dispatchIndirect(program, at::levelDispatch + f.levels);
    }
  }
}

void Contact::search() const {
  const auto next = [] {
    gl::barrier();
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  };
  begin_.dispatch(1);
  next();
  dispatchIndirect(reach_, at::vertexDispatch);
  gl::barrier();
  fit();
  gl::barrier();
  candidates_.buffer().bindStorage(at::candidatesBinding);
  const auto walk = [&](const gl::Program& program, const Tree& tree, int dispatch) {
    tree.leaves.bindInput(at::leavesBinding);
    tree.boxes.bindInput(at::boxesBinding);
    program.set("levels", tree.levels);
    dispatchIndirect(program, dispatch);
  };
  walk(searchVertices_, faces_, at::vertexDispatch);
  walk(searchEdges_, edges_, at::edgeDispatch);
  gl::barrier();
  candidateLists_.dispatch(1);
  next();
  candidates_.bindInput(at::candidatesBinding);
  pairs_.buffer().bindStorage(at::pairsBinding);
  dispatchIndirect(siftVertices_, at::vertexCandidateDispatch);
  dispatchIndirect(siftEdges_, at::edgeCandidateDispatch);
  gl::barrier();
  pairLists_.dispatch(1);
  next();
}

void Contact::bind(int index) const {
  steps_.bind(static_cast<std::size_t>(index));
  points_.bindState(at::pointsBinding);
  tallies_.buffer().bindStorage(at::talliesBinding);
  control_.bindStorage(at::controlBinding);
}

std::span<const Contact::Part> Contact::cloths(std::span<const Part> parts) const {
  const auto firstSolid = std::lower_bound(plan_.firsts().begin(), plan_.firsts().end(), plan_.movable());
  return parts.first(static_cast<std::size_t>(firstSolid - plan_.firsts().begin()));
}

template <class Bind>
void Contact::forParts(const gl::Program& program, std::span<const Part> parts, const Bind& bind) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto count = static_cast<int>(parts[i].now->buffer().bytes() / 16);
    bind(parts[i]);
    program.set("first", plan_.firsts()[i]);
    program.set("count", count);
    program.dispatch(count);
  }
  gl::barrier();
}

/// From where cloth may be held back, where solids move.
void Contact::carry() const {
  if (plan_.movable() == plan_.vertices()) return;
  for (int round = 0; round <= ContactPlan::carryRounds; ++round) {
    if (round > 0) dispatchIndirect(spread_, at::carryDispatch);
    gl::barrier();
    dispatchIndirect(start_, at::startDispatch);
    gl::barrier();
  }
}

void Contact::push(int index, std::span<const Part> parts) {
  SIMREEL_CHECK(parts.size() == plan_.firsts().size());
  bind(index);
  gl::barrier();
  forParts(gather_, parts, [](const Part& part) {
    part.now->bindInput(at::partNowBinding);
    part.next->bindInput(at::partNextBinding);
  });
  search();
  pairs_.bindInput(at::pairsBinding);
  corners_.buffer().bindStorage(at::cornersBinding);
  nears_.bindState(at::nearsBinding);
  dispatchIndirect(nearVertices_, at::vertexPairDispatch);
  dispatchIndirect(nearEdges_, at::edgePairDispatch);
  gl::barrier();
  nearList_.dispatch(1);
  gl::barrier();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  corners_.bindInput(at::cornersBinding);
  carry();
  tallies_.bindInput(at::toldBinding);
  for (int round = 0; round < plan_.rounds(); ++round) {
    dispatchIndirect(claim_, at::nearDispatch);
    gl::barrier();
    dispatchIndirect(push_, at::nearDispatch);
    gl::barrier();
    apply_.dispatch(plan_.movable());
    gl::barrier();
  }
  forParts(hand_, cloths(parts), [](const Part& part) {
    part.next->bindState(at::partNextBinding);
    part.velocities->bindState(at::partVelocitiesBinding);
  });
}

void Contact::hold(int index, std::span<const Part> parts) {
  bind(index);
  gl::barrier();
  forParts(take_, parts, [](const Part& part) { part.next->bindInput(at::partNextBinding); });
  corners_.bindInput(at::cornersBinding);
  nears_.bindState(at::nearsBinding);
  tallies_.bindInput(at::toldBinding);
  for (int round = 0; round < holdRounds; ++round) {
    hold_.set("round", round);
    dispatchIndirect(hold_, at::nearDispatch);
    gl::barrier();
  }
  forParts(leave_, cloths(parts), [](const Part& part) {
    part.next->bindState(at::partNextBinding);
    part.velocities->bindState(at::partVelocitiesBinding);
  });
}

}  // namespace simreel::sim
