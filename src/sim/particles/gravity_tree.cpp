#include "sim/particles/gravity_tree.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace simreel::shader::tree {
#include "glsl/particles/tree/bindings.glsl"
}

namespace simreel::sim {

namespace {

using shader::keyBits;
using shader::rootBodies;
using shader::rootLeaves;
using shader::rootNodes;

/// Items an invocation of the reduction takes.
constexpr int reduction = 64;

constexpr int ceilDivide(int a, int b) {
  return (a - 1) / b + 1;
}

gl::Vec4Array zeros(const std::string& label, std::int64_t count) {
  return {label, std::vector<glm::vec4>(static_cast<std::size_t>(count), glm::vec4(0))};
}

}  // namespace

float perOpening(float opening) {
  return std::max(1.0F / std::max(opening, 1e-6F), 0.87F);
}

float softeningSquare(float softening) {
  return std::max(softening * softening, 1e-20F);
}

GravityTree::GravityTree(const std::string& name, int capacity, bool fast)
    : name_(name), capacity_(capacity), sort_((checkLimits(), name + " order"), capacity) {
  const std::int64_t roots = ceilDivide(capacity, rootBodies);
  // Pairs of all reductions: capacity/64 + capacity/64^2 + ... and one for each that rounds up.
  corners_ = zeros(name + " box", 2 * (std::int64_t{capacity} / (reduction - 1) + 8));
  bodies_ = zeros(name + " sorted bodies", roots * rootBodies);
  boxes_ = zeros(name + " node boxes", 2 * roots * rootNodes);
  cells_ = zeros(name + " node centers", roots * rootNodes);
  moments_ = zeros(name + " node moments", 2 * roots * rootNodes);
  const gl::Defines defines = gl::kernelDefines(fast);
  const auto with = [&](const char* define, const char* path) {
    gl::Defines more = defines;
    more.emplace_back(define, "1");
    return gl::Program::compute(path, more);
  };
  reduceBodies_ = with("FROM_BODIES", "particles/tree/reduce.comp");
  reduceBoxes_ = gl::Program::compute("particles/tree/reduce.comp", defines);
  key_ = gl::Program::compute("particles/tree/key.comp", defines);
  gather_ = gl::Program::compute("particles/tree/gather.comp", defines);
  leaves_ = with("LEAVES", "particles/tree/build.comp");
  parents_ = gl::Program::compute("particles/tree/build.comp", defines);
  const bool texels = gl::memoryPath() == gl::MemoryPath::texel;
  walk_ =
      gl::Program::compute(texels ? "particles/tree/walk.comp" : "particles/tree/walk_list.comp", defines);
}

/// Before anything is filled: a set far beyond the limit would first take gigabytes.
void GravityTree::checkLimits() const {
  SIMREEL_CHECK(capacity_ > 0);
  const std::int64_t bytesOfTree = std::int64_t{32} * rootNodes;
  const std::int64_t max = gl::limits().storageBlockBytes / bytesOfTree * rootBodies;
  if (capacity_ > max)
    fail(ExitCode::device,
         "gravity of \"{}\" by \"tree\" takes at most {} bodies on this device, not {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE is {}); use fewer",
         name_, max, capacity_, gl::limits().storageBlockBytes);
}

void GravityTree::accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                             float gravity, float softening, float opening) {
  sort(positions, count);
  build(positions, count, opening);
  walk(accelerations, count, gravity, softening);
}

/// log64(N) small dispatches.
void GravityTree::findBox(const gl::Vec4Array& positions, int count) {
  int items = count;
  int first = 0;
  int result = 0;
  do {
    const gl::Program& program = result == 0 ? reduceBodies_ : reduceBoxes_;
    const int results = ceilDivide(items, reduction);
    positions.bindInput(shader::tree::positionsBinding);
    corners_.bindState(shader::tree::cornersBinding);
    program.set("count", items);
    program.set("first", first);
    program.set("result", result);
    program.set("results", results);
    gl::barrier();
    program.dispatch(results);
    first = result;
    result += results;
    items = results;
  } while (items > 1);
  box_ = first;
}

void GravityTree::sort(const gl::Vec4Array& positions, int count) {
  SIMREEL_CHECK(count <= capacity_);
  if (count <= 0) return;
  findBox(positions, count);
  positions.bindInput(shader::tree::positionsBinding);
  corners_.bindInput(shader::tree::cornersBinding);
  sort_.records().bindState(shader::tree::recordsBinding);
  key_.set("count", count);
  key_.set("box", box_);
  gl::barrier();
  key_.dispatch(count);
  sort_.sort(count, keyBits, keyBits);
}

void GravityTree::build(const gl::Vec4Array& positions, int count, float opening) {
  if (count <= 0) return;
  const int roots = ceilDivide(count, rootBodies);
  positions.bindInput(shader::tree::positionsBinding);
  bodies_.bindState(shader::tree::bodiesBinding);
  sort_.records().bindInput(shader::tree::recordsBinding);
  gather_.set("count", count);
  gather_.set("padded", roots * rootBodies);
  gl::barrier();
  gather_.dispatch(roots * rootBodies);
  bodies_.bindInput(shader::tree::bodiesBinding);
  boxes_.bindState(shader::tree::boxesBinding);
  cells_.bindState(shader::tree::cellsBinding);
  moments_.bindState(shader::tree::momentsBinding);
  for (int width = rootLeaves; width > 0; width /= 2) {
    const gl::Program& program = width == rootLeaves ? leaves_ : parents_;
    program.set("roots", roots);
    program.set("width", width);
    program.set("perOpening", perOpening(opening));
    gl::barrier();
    program.dispatch(roots * width);
  }
}

// An invocation carries 8 bodies through texels (walk.comp); through storage blocks 64 of them share a list
// of what pulls them (walk_list.comp). On a software driver every tree has a dispatch of its own, so that
// none exceeds the iterations a shader may take there.
//
// Cost at opening 0.6 of 131,072 bodies in a Plummer sphere, counted by the twin: a group of 64 visits 4142
// nodes, takes 1700 of them as multipoles (66 operations a body) and opens 373 leaves (8 x 33 operations a
// body): 0.21e6 operations a body with the visits shared, in a disk a fifth. Loads are 16 bytes a visit, 32
// a multipole and 128 a leaf, the same for a whole group: 2.6 kB a body from the caches.
void GravityTree::walk(const gl::Vec4Array& accelerations, int count, float gravity, float softening) {
  if (count <= 0) return;
  const int roots = ceilDivide(count, rootBodies);
  const bool texels = gl::memoryPath() == gl::MemoryPath::texel;
  bodies_.bindInput(shader::tree::bodiesBinding);
  boxes_.bindInput(shader::tree::boxesBinding);
  cells_.bindInput(shader::tree::cellsBinding);
  moments_.bindInput(shader::tree::momentsBinding);
  sort_.records().bindInput(shader::tree::recordsBinding);
  accelerations.bindState(shader::tree::accelerationsBinding);
  walk_.set("count", count);
  walk_.set("gravity", gravity);
  walk_.set("softening2", softeningSquare(softening));
  const int step = gl::softwareDriver() ? 1 : roots;
  for (int root = 0; root < roots; root += step) {
    walk_.set("firstRoot", root);
    walk_.set("lastRoot", root + step);
    walk_.set("finish", root + step == roots ? 1 : 0);
    gl::barrier();
    walk_.dispatch(texels ? ceilDivide(count, 8)
                          : ceilDivide(count, shader::groupBodies) * shader::groupBodies);
  }
  gl::barrier();
}

}  // namespace simreel::sim
