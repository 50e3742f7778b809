#include "sim/particles/gravity_tree.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace simreel::sim {

/// Kernel that reduces bodies, or the boxes of the previous level, to bounding boxes.
struct TreeReduce {
  static constexpr auto file = "particles/tree/reduce.comp";
  struct Variant {
    gl::Flag<"FROM_BODIES"> fromBodies;
  };
  gl::Uniform<"count", int> count;
  gl::Uniform<"first", int> first;
  gl::Uniform<"result", int> result;
  gl::Uniform<"results", int> results;
  gl::In<"positions"> positions;
  gl::InOut<"corners"> corners;
};

struct TreeKey {
  static constexpr auto file = "particles/tree/key.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"box", int> box;
  gl::In<"positions"> positions;
  gl::In<"corners"> corners;
  gl::Out<"records"> records;
};

struct TreeGather {
  static constexpr auto file = "particles/tree/gather.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"padded", int> padded;
  gl::In<"positions"> positions;
  gl::In<"records"> records;
  gl::Out<"bodies"> bodies;
};

struct TreeBuild {
  static constexpr auto file = "particles/tree/build.comp";
  struct Variant {
    gl::Flag<"LEAVES"> leaves;
  };
  gl::Uniform<"roots", int> roots;
  gl::Uniform<"width", int> width;
  gl::Uniform<"perOpening", float> perOpening;
  gl::In<"bodies"> bodies;
  gl::InOut<"boxes"> boxes;
  gl::InOut<"cells"> cells;
  gl::InOut<"moments"> moments;
};

struct TreeWalkPart {
  gl::Uniform<"count", int> count;
  gl::Uniform<"gravity", float> gravity;
  gl::Uniform<"softening2", float> softening2;
  gl::Uniform<"firstRoot", int> firstRoot;
  gl::Uniform<"lastRoot", int> lastRoot;
  gl::Uniform<"finish", bool> finish;
  gl::In<"bodies"> bodies;
  gl::In<"boxes"> boxes;
  gl::In<"cells"> cells;
  gl::In<"moments"> moments;
  gl::In<"records"> records;
  gl::InOut<"accelerations"> accelerations;
};
struct TreeWalk {
  static constexpr auto file = "particles/tree/walk.comp";
  TreeWalkPart part;
};
struct TreeWalkList {
  static constexpr auto file = "particles/tree/walk_list.comp";
  TreeWalkPart part;
};

namespace {

using shader::keyBits;
using shader::rootBodies;
using shader::rootLeaves;
using shader::rootNodes;

/// Number of items that an invocation of the reduction reads.
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
  // The capacity is the sum over all reduction levels: capacity/64 + capacity/64^2 + ..., plus one for each
  // level that rounds up.
  corners_ = zeros(name + " box", 2 * (std::int64_t{capacity} / (reduction - 1) + 8));
  bodies_ = zeros(name + " sorted bodies", roots * rootBodies);
  boxes_ = zeros(name + " node boxes", 2 * roots * rootNodes);
  cells_ = zeros(name + " node centers", roots * rootNodes);
  moments_ = zeros(name + " node moments", 2 * roots * rootNodes);
  const gl::Defines defines = gl::kernelDefines(fast);
  reduceBodies_ = gl::Kernel<TreeReduce>(defines, {.fromBodies = true});
  reduceBoxes_ = gl::Kernel<TreeReduce>(defines);
  key_ = gl::Kernel<TreeKey>(defines);
  gather_ = gl::Kernel<TreeGather>(defines);
  leaves_ = gl::Kernel<TreeBuild>(defines, {.leaves = true});
  parents_ = gl::Kernel<TreeBuild>(defines);
  if (gl::memoryPath() == gl::MemoryPath::texel)
    walk_ = gl::Kernel<TreeWalk>(defines);
  else
    walkList_ = gl::Kernel<TreeWalkList>(defines);
}

/// Throws UserError(device) if the trees exceed the device's limit. Called before any buffer is filled,
/// because a set of bodies far beyond the limit would first allocate gigabytes.
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

/// Needs log64(N) small dispatches for N bodies.
void GravityTree::findBox(const gl::Vec4Array& positions, int count) {
  int items = count;
  int first = 0;
  int result = 0;
  do {
    const int results = ceilDivide(items, reduction);
    (result == 0 ? reduceBodies_ : reduceBoxes_)
        .dispatch(results, {.count = items,
                            .first = first,
                            .result = result,
                            .results = results,
                            .positions = positions,
                            .corners = corners_});
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
  key_.dispatch(count, {.count = count,
                        .box = box_,
                        .positions = positions,
                        .corners = corners_,
                        .records = sort_.records()});
  sort_.sort(count, keyBits, keyBits);
}

void GravityTree::build(const gl::Vec4Array& positions, int count, float opening) {
  if (count <= 0) return;
  const int roots = ceilDivide(count, rootBodies);
  const int padded = roots * rootBodies;
  gather_.dispatch(padded, {.count = count,
                            .padded = padded,
                            .positions = positions,
                            .records = sort_.records(),
                            .bodies = bodies_});
  for (int width = rootLeaves; width > 0; width /= 2)
    (width == rootLeaves ? leaves_ : parents_)
        .dispatch(roots * width, {.roots = roots,
                                  .width = width,
                                  .perOpening = perOpening(opening),
                                  .bodies = bodies_,
                                  .boxes = boxes_,
                                  .cells = cells_,
                                  .moments = moments_});
}

// On the texel path, an invocation processes 8 bodies (walk.comp). On the storage path, 64 bodies use a
// common list of the nodes and leaves that attract them (walk_list.comp). On a software driver, each tree
// has a separate dispatch, so that no invocation exceeds the driver's limit of loop iterations.
//
// The cost was counted in the CPU reference for 131,072 bodies in a Plummer sphere with an opening of 0.6:
// a group of 64 bodies visits 4142 nodes, evaluates 1700 of them as multipoles (66 operations per body) and
// opens 373 leaves (8 x 33 operations per body). Including the visits, that is 0.21e6 operations per body;
// in a disk it is a fifth of that. A group loads 16 bytes per visit, 32 per multipole and 128 per leaf,
// which is 2.6 kB per body from the caches.
void GravityTree::walk(const gl::Vec4Array& accelerations, int count, float gravity, float softening) {
  if (count <= 0) return;
  const int roots = ceilDivide(count, rootBodies);
  const int step = gl::softwareDriver() ? 1 : roots;
  for (int root = 0; root < roots; root += step) {
    const TreeWalkPart part = {.count = count,
                               .gravity = gravity,
                               .softening2 = softeningSquare(softening),
                               .firstRoot = root,
                               .lastRoot = root + step,
                               .finish = root + step == roots,
                               .bodies = bodies_,
                               .boxes = boxes_,
                               .cells = cells_,
                               .moments = moments_,
                               .records = sort_.records(),
                               .accelerations = accelerations};
    if (walk_)
      walk_.dispatch(ceilDivide(count, 8), {part});
    else
      walkList_.dispatch(ceilDivide(count, shader::groupBodies) * shader::groupBodies, {part});
  }
}

}  // namespace simreel::sim
