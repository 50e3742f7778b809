#include "sim/reaction/rule/evaluate.hpp"

#include "base/error.hpp"
#include "sim/reaction/rule/model.hpp"

#include <algorithm>
#include <cstddef>

namespace simreel::sim {

namespace {

/// Access to the cells of a plane and, according to the boundary condition, to the values beyond its edges.
class PlaneView {
 public:
  PlaneView(RuleField& field, const RulePlane& plane) : field_(field), plane_(plane) {
    const bool species = plane.array == RuleArray::stage;
    if (field.boundary == RuleBoundary::fixed && species) {
      isFixed_ = true;
      edge_ = field.edges[static_cast<std::size_t>(plane.plane)];
    }
  }

  [[nodiscard]] float at(int x, int y, int z) const {
    const glm::ivec2 size = field_.size;
    const int depth = field_.depth;
    const bool outside = x < 0 || y < 0 || z < 0 || x >= size.x || y >= size.y || z >= depth;
    if (outside && isFixed_) return edge_;
    if (field_.boundary == RuleBoundary::torus) {
      x = x < 0 ? x + size.x : x >= size.x ? x - size.x : x;
      y = y < 0 ? y + size.y : y >= size.y ? y - size.y : y;
      z = z < 0 ? z + depth : z >= depth ? z - depth : z;
    } else {
      x = std::clamp(x, 0, size.x - 1);
      y = std::clamp(y, 0, size.y - 1);
      z = std::clamp(z, 0, depth - 1);
    }
    const auto& cells = field_.array(plane_.array)[static_cast<std::size_t>(plane_.plane)];
    return cells[static_cast<std::size_t>(z * size.y + y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)];
  }
  [[nodiscard]] float sides(int x, int y, int z) const { return at(x - 1, y, z) + at(x + 1, y, z); }
  /// Returns the sum of the cells in the previous and the next layer.
  [[nodiscard]] float faces(int x, int y, int z) const { return at(x, y, z - 1) + at(x, y, z + 1); }

  [[nodiscard]] float edges(int x, int y, int z) const {
    const float beside = at(x, y - 1, z) + at(x, y + 1, z);
    return sides(x, y, z) + (field_.isVolume() ? beside + faces(x, y, z) : beside);
  }
  [[nodiscard]] float corners(int x, int y, int z) const {
    const float flat = sides(x, y - 1, z) + sides(x, y + 1, z);
    if (!field_.isVolume()) return flat;
    const float sidesOfLayers = sides(x, y, z - 1) + sides(x, y, z + 1);
    return flat + (sidesOfLayers + (faces(x, y - 1, z) + faces(x, y + 1, z)));
  }

  /// Returns the weighted sum of the differences between the neighbours of cell x of a mesh and the cell,
  /// added in link order.
  [[nodiscard]] float linked(int x) const {
    const float here = at(x, 0, 0);
    const glm::ivec2 range = field_.links->ranges[static_cast<std::size_t>(x / 4)];
    float sum = 0;
    for (auto s = static_cast<std::size_t>(range.x); s < static_cast<std::size_t>(range.y); ++s) {
      const float difference = at(std::max(field_.links->neighbours[s][x % 4], 0), 0, 0) - here;
      const float term = field_.links->weights[s][x % 4] * difference;
      sum = sum + term;
    }
    return sum;
  }

  /// Returns the sum of the neighbours of cell x of a mesh.
  [[nodiscard]] float neighbourSum(int x) const {
    const glm::ivec2 range = field_.links->ranges[static_cast<std::size_t>(x / 4)];
    float sum = 0;
    for (auto s = static_cast<std::size_t>(range.x); s < static_cast<std::size_t>(range.y); ++s) {
      const int neighbour = field_.links->neighbours[s][x % 4];
      sum = sum + (neighbour < 0 ? 0.0F : at(neighbour, 0, 0));
    }
    return sum;
  }
  [[nodiscard]] float tips(int x, int y, int z) const {
    const float before = sides(x, y - 1, z - 1) + sides(x, y - 1, z + 1);
    return before + (sides(x, y + 1, z - 1) + sides(x, y + 1, z + 1));
  }

  [[nodiscard]] float stencil(RuleOp op, int x, int y, int z) const {
    if (op == RuleOp::edges && field_.links != nullptr) return neighbourSum(x);
    if (op == RuleOp::sixfold && field_.links != nullptr) return linked(x);
    switch (op) {
      case RuleOp::edges:
        return edges(x, y, z);
      case RuleOp::corners:
        return corners(x, y, z);
      case RuleOp::sixfold:
        return field_.isVolume() ? 2.0F * edges(x, y, z) + corners(x, y, z) - 24.0F * at(x, y, z)
                                 : 4.0F * edges(x, y, z) + corners(x, y, z) - 20.0F * at(x, y, z);
      case RuleOp::tips:
        return tips(x, y, z);
      case RuleOp::across:
        return at(x + 1, y, z) - at(x - 1, y, z);
      case RuleOp::down:
        return at(x, y + 1, z) - at(x, y - 1, z);
      case RuleOp::deep:
        return at(x, y, z + 1) - at(x, y, z - 1);
      default:
        return at(x, y, z);
    }
  }

 private:
  RuleField& field_;
  RulePlane plane_;
  bool isFixed_ = false;
  float edge_ = 0;
};

/// Returns the value of an input node that is not read from a plane.
float inputNumber(const RuleNode& node, const RuleField& field, int x, int row, unsigned step) {
  const auto cell =
      static_cast<unsigned>(row) * static_cast<unsigned>(field.size.x) + static_cast<unsigned>(x);
  const auto salt = static_cast<unsigned>(node.index) * 2654435761U + field.seed;
  switch (node.op) {
    case RuleOp::x:
      return static_cast<float>(x) + 0.5F;
    case RuleOp::y:
      return static_cast<float>(row % field.size.y) + 0.5F;
    case RuleOp::z:
      return static_cast<float>(row / field.size.y) + 0.5F;
    case RuleOp::noise:
      return shader::signedUnit(shader::hash3({cell, step, salt}).x);
    case RuleOp::random:
      return shader::signedUnit(shader::hash3({cell, 0x5eed5eedU, salt}).x);
    default:
      break;
  }
  SIMREEL_CHECK(false);
  return 0;
}

bool isInput(RuleOp op) {
  return op == RuleOp::x || op == RuleOp::y || op == RuleOp::z || op == RuleOp::noise ||
         op == RuleOp::random;
}

}  // namespace

RulePlanes& RuleField::array(RuleArray which) {
  switch (which) {
    case RuleArray::stage:
      return stage;
    case RuleArray::base:
      return base;
    case RuleArray::sum:
      return sum;
    case RuleArray::lets:
      return lets;
    case RuleArray::weights:
      return weights;
    case RuleArray::next:
      break;
  }
  return next;
}

std::vector<float> ruleUniformsOf(const RuleGraph& graph, const RulePass& pass,
                                  std::span<const float> values) {
  // The arguments of uniform nodes are also uniform and precede these nodes.
  const int count = pass.uniforms.empty() ? 0 : pass.uniforms.back() + 1;
  std::vector<bool> needed(static_cast<std::size_t>(count));
  for (const int node : pass.uniforms) needed[static_cast<std::size_t>(node)] = true;
  for (int i = count - 1; i >= 0; --i)
    if (needed[static_cast<std::size_t>(i)])
      for (const int argument : {graph.at(i).a, graph.at(i).b, graph.at(i).c})
        if (argument >= 0) needed[static_cast<std::size_t>(argument)] = true;
  std::vector<float> of(static_cast<std::size_t>(count));
  const auto argument = [&](int node) { return node < 0 ? 0.0F : of[static_cast<std::size_t>(node)]; };
  for (int i = 0; i < count; ++i) {
    if (!needed[static_cast<std::size_t>(i)]) continue;
    const RuleNode& node = graph.at(i);
    of[static_cast<std::size_t>(i)] =
        node.op == RuleOp::constant ? node.number
        : node.op == RuleOp::uniform
            ? values[static_cast<std::size_t>(node.index)]
            : computed(node.op, argument(node.a), argument(node.b), argument(node.c));
  }
  std::vector<float> uniforms;
  for (const int node : pass.uniforms) {
    const float value = of[static_cast<std::size_t>(node)];
    uniforms.push_back(graph.isConstant(node) ? value : shader::reaction::grained(value, storedGrain));
  }
  return uniforms;
}

// Evaluates one node at a time for a whole row of cells, so that the compiler can vectorize simple
// operations.
void evaluatePass(const RuleGraph& graph, const RulePass& pass, std::span<const float> uniforms,
                  unsigned step, RuleField& field) {
  const auto width = static_cast<std::size_t>(field.size.x);
  std::vector<std::vector<float>> rows(static_cast<std::size_t>(graph.size()));
  const auto rowOf = [&](int node) -> std::vector<float>& {
    auto& row = rows[static_cast<std::size_t>(node)];
    row.resize(width);
    return row;
  };
  for (std::size_t i = 0; i < pass.uniforms.size(); ++i)
    std::fill_n(rowOf(pass.uniforms[i]).begin(), width, uniforms[i]);
  for (int r = 0; r < field.rows(); ++r) {
    const int y = r % field.size.y, z = r / field.size.y;
    for (const RulePass::Read& read : pass.reads) {
      const PlaneView plane(field, read.plane);
      std::vector<float>& row = rowOf(read.node);
      for (int x = 0; x < field.size.x; ++x)
        row[static_cast<std::size_t>(x)] = plane.stencil(read.op, x, y, z);
    }
    for (const int i : pass.nodes) {
      const RuleNode& node = graph.at(i);
      std::vector<float>& row = rowOf(i);
      if (isInput(node.op)) {
        for (int x = 0; x < field.size.x; ++x)
          row[static_cast<std::size_t>(x)] = inputNumber(node, field, x, r, step);
        continue;
      }
      const float* a = rowOf(node.a).data();
      const float* b = node.b >= 0 ? rowOf(node.b).data() : a;
      const float* c = node.c >= 0 ? rowOf(node.c).data() : a;
      for (std::size_t x = 0; x < width; ++x) row[x] = computed(node.op, a[x], b[x], c[x]);
    }
    for (const RulePass::Output& output : pass.outputs) {
      auto& plane = field.array(output.plane.array)[static_cast<std::size_t>(output.plane.plane)];
      std::copy_n(rowOf(output.node).begin(), width,
                  plane.begin() + static_cast<std::ptrdiff_t>(width * static_cast<std::size_t>(r)));
    }
  }
}

RulePlanes evaluateStarts(const Rule& rule, std::span<const float> values, RuleField& field) {
  RuleGraph graph = rule.graph;
  RulePass pass;
  std::vector<bool> needed;
  std::vector<int> outputs;
  for (const int start : rule.starts) outputs.push_back(graph.settled(start));
  needed.resize(static_cast<std::size_t>(graph.size()));
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    pass.outputs.push_back({{RuleArray::next, static_cast<int>(i)}, outputs[i]});
    needed[static_cast<std::size_t>(outputs[i])] = true;
  }
  for (int i = graph.size() - 1; i >= 0; --i) {
    if (!needed[static_cast<std::size_t>(i)]) continue;
    const RuleNode& node = graph.at(i);
    if (graph.isUniform(i)) {
      pass.uniforms.push_back(i);
      continue;
    }
    if (node.op == RuleOp::weight) {
      pass.reads.push_back({i, RuleOp::species, {RuleArray::weights, node.index}});
      continue;
    }
    pass.nodes.push_back(i);
    for (const int argument : {node.a, node.b, node.c})
      if (argument >= 0) needed[static_cast<std::size_t>(argument)] = true;
  }
  std::reverse(pass.nodes.begin(), pass.nodes.end());
  std::sort(pass.uniforms.begin(), pass.uniforms.end());
  const auto cells = static_cast<std::size_t>(field.size.x) * static_cast<std::size_t>(field.rows());
  field.next.assign(rule.starts.size(), std::vector<float>(cells));
  evaluatePass(graph, pass, ruleUniformsOf(graph, pass, values), 0, field);
  return std::move(field.next);
}

}  // namespace simreel::sim
