#include "reference/gravity_tree_twin.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/particles/gravity_tree.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace {

using namespace simreel::shader;

inline int findLSB(int x) {
  return std::countr_zero(static_cast<unsigned>(x));
}

#define FUNCTION inline
#define precise
#define REAL float
/// Provides the bodies that model.glsl reads in a kernel, and includes the model file.
struct Kernel {
  const vec4* bodies = nullptr;

  [[nodiscard]] vec4 loadBody(int i) const { return bodies[i]; }
#include "glsl/particles/tree/model.glsl"
};
#undef REAL
#undef precise
#undef FUNCTION

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

template <class Body>
void forAll(int count, int threads, const Body& body) {
  if (threads == 1) {
    for (int i = 0; i < count; ++i) body(i);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, count), [&](const tbb::blocked_range<int>& range) {
      for (int i = range.begin(); i < range.end(); ++i) body(i);
    });
  });
}

/// The bodies of one group and their summed accelerations.
struct Group {
  vec3 middle, halfSize;
  vec4 bodies[groupBodies];
  Kernel::Pull sums[groupBodies];
};

void walkTree(const GravityTreeTwin& tree, int root, float softening2, Group& group,
              GravityTreeTwin::Work& work) {
  Kernel kernel;
  int node = 1;
  do {
    const int i = root * rootNodes + node;
    ++work.visits;
    const vec4 cell = tree.cells[at(i)];
    if (kernel.isFar(cell, group.middle, group.halfSize)) {
      ++work.far;
      for (int b = 0; b < groupBodies; ++b)
        group.sums[b] =
            kernel.plusNode(group.sums[b], group.bodies[b].x, group.bodies[b].y, group.bodies[b].z,
                            vec3(cell), tree.moments[at(2 * i)], tree.moments[at(2 * i + 1)], softening2);
      node = kernel.nodeAfter(node);
    } else if (node >= rootLeaves) {
      ++work.leaves;
      const int first = root * rootBodies + (node - rootLeaves) * leafBodies;
      for (int j = first; j < first + leafBodies; ++j)
        for (int b = 0; b < groupBodies; ++b)
          group.sums[b] = kernel.plusBody(group.sums[b], group.bodies[b].x, group.bodies[b].y,
                                          group.bodies[b].z, tree.sorted[at(j)], softening2);
      node = kernel.nodeAfter(node);
    } else {
      node = 2 * node;
    }
  } while (node != 1);
}

}  // namespace

GravityTreeTwin::GravityTreeTwin(std::span<const glm::vec4> bodies, float opening, int threads)
    : threads_(threads) {
  sort(bodies);
  build(opening);
}

void GravityTreeTwin::sort(std::span<const glm::vec4> bodies) {
  Kernel kernel;
  const int count = static_cast<int>(bodies.size());
  vec3 low(1e30F), high(-1e30F);
  for (const vec4& body : bodies)
    if (kernel.takesPart(body)) {
      low = min(low, vec3(body));
      high = max(high, vec3(body));
    }
  std::vector<std::uint64_t> keys(bodies.size());
  forAll(count, threads_, [&](int i) {
    const vec4 body = bodies[at(i)];
    glm::uvec3 key(0xffffffU, 0xffffffU, 0);
    if (kernel.takesPart(body)) key = kernel.hilbertKey(kernel.cellOf(vec3(body), low, high));
    keys[at(i)] = (static_cast<std::uint64_t>(key.y) << keyBits) | key.x;
  });
  order.resize(bodies.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) { return keys[a] < keys[b]; });
  sorted.assign(at((count + rootBodies - 1) / rootBodies * rootBodies), vec4(0));
  for (std::size_t i = 0; i < order.size(); ++i)
    if (kernel.takesPart(bodies[order[i]])) sorted[i] = bodies[order[i]];
}

void GravityTreeTwin::build(float opening) {
  const float perOpening = simreel::sim::perOpening(opening);
  const int roots = static_cast<int>(sorted.size()) / rootBodies;
  boxes.assign(at(roots * rootNodes * 2), vec4(0));
  moments = boxes;
  cells.assign(at(roots * rootNodes), vec4(0));
  const auto store = [&](int i, const Kernel::Node& node) {
    boxes[at(2 * i)] = vec4(node.low, 0);
    boxes[at(2 * i + 1)] = vec4(node.high, 0);
    Kernel kernel;
    cells[at(i)] = kernel.nodeCell(node, perOpening);
    moments[at(2 * i)] = kernel.nodeMoments0(node);
    moments[at(2 * i + 1)] = kernel.nodeMoments1(node);
  };
  const auto load = [&](int i) {
    Kernel kernel;
    return kernel.unpackNode(boxes[at(2 * i)], boxes[at(2 * i + 1)], cells[at(i)], moments[at(2 * i)],
                             moments[at(2 * i + 1)]);
  };
  forAll(roots * rootLeaves, threads_, [&](int leaf) {
    Kernel kernel{sorted.data()};
    store(leaf / rootLeaves * rootNodes + rootLeaves + leaf % rootLeaves,
          kernel.leafNode(leaf * leafBodies));
  });
  for (int width = rootLeaves / 2; width > 0; width /= 2)
    forAll(roots * width, threads_, [&](int i) {
      const int base = i / width * rootNodes;
      const int node = width + i % width;
      Kernel kernel;
      store(base + node, kernel.parentNode(load(base + 2 * node), load(base + 2 * node + 1)));
    });
}

std::vector<glm::vec4> GravityTreeTwin::accelerations(float gravity, float softening) {
  const float softening2 = simreel::sim::softeningSquare(softening);
  const int count = static_cast<int>(order.size());
  const int roots = static_cast<int>(sorted.size()) / rootBodies;
  std::vector<glm::vec4> result(order.size(), vec4(0));
  std::atomic<std::int64_t> visits = 0, far = 0, leaves = 0;
  forAll((count + groupBodies - 1) / groupBodies, threads_, [&](int g) {
    constexpr int perRoot = rootBodies / groupBodies;
    const int node = g / perRoot * rootNodes + perRoot + g % perRoot;
    const vec3 low(boxes[at(2 * node)]), high(boxes[at(2 * node + 1)]);
    if (low.x > high.x) return;
    Group group{};
    group.middle = low + (high - low) * 0.5F;
    group.halfSize = max(high - group.middle, group.middle - low);
    for (int b = 0; b < groupBodies; ++b) group.bodies[b] = sorted[at(g * groupBodies + b)];
    Work mine;
    for (int root = 0; root < roots; ++root) walkTree(*this, root, softening2, group, mine);
    visits += mine.visits;
    far += mine.far;
    leaves += mine.leaves;
    for (int b = 0; b < groupBodies && g * groupBodies + b < count; ++b) {
      const Kernel::Pull sum = group.sums[b];
      const vec4 a(exactFlush(sum.x * gravity), exactFlush(sum.y * gravity), exactFlush(sum.z * gravity),
                   0);
      result[order[at(g * groupBodies + b)]] = group.bodies[b].w > 0 ? a : vec4(0);
    }
  });
  work = {visits, far, leaves};
  return result;
}
