#include "sim/reaction/rule/program.hpp"

#include <algorithm>
#include <map>

namespace simreel::sim {

namespace {

bool isStencil(RuleOp op) {
  return op >= RuleOp::sixfold && op <= RuleOp::deep;
}

class Planning {
 public:
  explicit Planning(Rule& rule) : rule_(rule), graph_(rule.graph) {}

  RuleProgram whole(RuleMethod method) {
    RuleProgram program;
    const auto stages = stageOutputs(method);
    std::vector<int> roots;
    for (const auto& outputs : stages)
      for (const RulePass::Output& output : outputs) roots.push_back(output.node);
    const int tint = rule_.tint < 0 ? rule_.shown : rule_.tint;
    for (const int node : {rule_.shown, tint}) roots.push_back(node);
    findPlanes(roots);
    program.sums = method != RuleMethod::euler;

    const std::vector<int> letPasses = addLets(program, rootsOf(stages));
    constexpr double times[3][4] = {{0}, {0, 1}, {0, 0.5, 0.5, 1}};
    for (std::size_t i = 0; i < stages.size(); ++i) {
      RuleProgram::Stage stage;
      stage.passes = letPasses;
      stage.passes.push_back(static_cast<int>(program.passes.size()));
      stage.time = times[static_cast<std::size_t>(method)][i];
      stage.last = i + 1 == stages.size();
      program.passes.push_back(passOf(stages[i], static_cast<int>(letPasses.size())));
      program.stages.push_back(std::move(stage));
    }
    addShown(program, rule_.shown, tint);
    return program;
  }

 private:
  using Outputs = std::vector<RulePass::Output>;

  void addShown(RuleProgram& program, int shown, int tint) {
    Outputs outputs;
    program.lets = static_cast<int>(planes_.size());
    const auto placed = [&](int node) -> RulePlane {
      if (graph_.at(node).op == RuleOp::species) return {RuleArray::stage, graph_.at(node).index};
      for (const RulePass::Output& output : outputs)
        if (output.node == node) return output.plane;
      outputs.push_back({{RuleArray::lets, program.lets++}, node});
      return outputs.back().plane;
    };
    program.shown = placed(shown);
    program.tint = placed(tint);
    if (outputs.empty()) return;
    std::vector<int> nodes;
    for (const RulePass::Output& output : outputs) nodes.push_back(output.node);
    program.showing = addLets(program, nodes);
    program.showing.push_back(static_cast<int>(program.passes.size()));
    program.passes.push_back(passOf(outputs, 1 + static_cast<int>(planes_.size())));
  }

  static std::vector<int> rootsOf(const std::vector<Outputs>& stages) {
    std::vector<int> roots;
    for (const Outputs& outputs : stages)
      for (const RulePass::Output& output : outputs) roots.push_back(output.node);
    return roots;
  }

  /// Returns the node of u + dt k, rounded for storage, where `from` is u and `uniforms` is the index of
  /// the uniform factor dt.
  int moved(int from, int uniforms, int k) {
    return graph_.settled(graph_.sum(from, graph_.rawProduct(graph_.uniform(uniforms), k)));
  }

  /// Returns the outputs of each stage, as given by the method's Butcher tableau.
  std::vector<Outputs> stageOutputs(RuleMethod method) {
    const std::size_t stages = method == RuleMethod::euler ? 1 : method == RuleMethod::heun ? 2 : 4;
    std::vector<Outputs> all(stages);
    for (std::size_t s = 0; s < stages; ++s)
      for (std::size_t i = 0; i < rule_.rates.size(); ++i) {
        const auto index = static_cast<int>(i);
        const int k = rule_.rates[i];
        const bool first = s == 0, last = s + 1 == stages;
        // In the first stage, the current values of the species are those at the beginning of the step.
        const int base = graph_.input(first ? RuleOp::species : RuleOp::base, index);
        const int sum = first ? k : graph_.sum(graph_.input(RuleOp::sum, index), weighted(method, last, k));
        if (!last) all[s].push_back({{RuleArray::sum, index}, graph_.settled(sum)});
        const int step =
            !last ? (method == RuleMethod::rk4 && s < 2 ? UniformIndex::halfDt : UniformIndex::dt)
            : method == RuleMethod::euler ? UniformIndex::dt
            : method == RuleMethod::heun  ? UniformIndex::halfDt
                                          : UniformIndex::sixthDt;
        const int next = rule_.nexts[i];
        all[s].push_back({{RuleArray::next, index},
                          next >= 0 ? graph_.settled(next) : moved(base, step, last ? sum : k)});
      }
    return all;
  }
  /// Returns k multiplied by its weight in the sum: k1 + 2 k2 + 2 k3 + k4 for rk4, k1 + k2 for Heun.
  int weighted(RuleMethod method, bool last, int k) {
    return method == RuleMethod::rk4 && !last ? graph_.product(graph_.constant(2), k) : k;
  }

  [[nodiscard]] std::vector<bool> neededBy(const std::vector<int>& roots) const {
    std::vector<bool> needed(static_cast<std::size_t>(graph_.size()));
    for (const int root : roots) needed[static_cast<std::size_t>(root)] = true;
    for (int i = graph_.size() - 1; i >= 0; --i)
      if (needed[static_cast<std::size_t>(i)])
        for (const int argument : {graph_.at(i).a, graph_.at(i).b, graph_.at(i).c})
          if (argument >= 0) needed[static_cast<std::size_t>(argument)] = true;
    return needed;
  }

  /// Determines which nodes are stored in a separate plane (let plane), and the first pass (level) in which
  /// each node can be computed.
  void findPlanes(const std::vector<int>& roots) {
    const std::vector<bool> needed = neededBy(roots);
    levels_.assign(static_cast<std::size_t>(graph_.size()), 0);
    for (int i = 0; i < graph_.size(); ++i) {
      const RuleNode& node = graph_.at(i);
      int& level = levels_[static_cast<std::size_t>(i)];
      for (const int argument : {node.a, node.b, node.c})
        if (argument >= 0) level = std::max(level, levels_[static_cast<std::size_t>(argument)]);
      if (!needed[static_cast<std::size_t>(i)] || !isStencil(node.op)) continue;
      const RuleOp over = graph_.at(node.a).op;
      if (over == RuleOp::species || over == RuleOp::weight) continue;
      planes_.emplace(node.a, static_cast<int>(planes_.size()));
      ++level;
    }
  }

  /// Adds one pass per level, which compute the let planes that `roots` need. Returns the indices of the
  /// passes.
  std::vector<int> addLets(RuleProgram& program, const std::vector<int>& roots) {
    const std::vector<bool> needed = neededBy(roots);
    std::map<int, Outputs> byLevel;
    for (const auto& [node, plane] : planes_)
      if (needed[static_cast<std::size_t>(node)])
        byLevel[levels_[static_cast<std::size_t>(node)]].push_back({{RuleArray::lets, plane}, node});
    std::vector<int> numbers;
    for (auto& [level, outputs] : byLevel) {
      for (RulePass::Output& output : outputs) settled_[output.node] = graph_.settled(output.node);
      numbers.push_back(static_cast<int>(program.passes.size()));
      Outputs stored = outputs;
      for (RulePass::Output& output : stored) output.node = settled_.at(output.node);
      program.passes.push_back(passOf(stored, level));
    }
    return numbers;
  }

  /// Returns the let plane of a node if it is stored before a pass of this level, otherwise null.
  [[nodiscard]] const int* storedBefore(int node, int level) const {
    const auto plane = planes_.find(node);
    return plane != planes_.end() && levels_[static_cast<std::size_t>(node)] < level ? &plane->second
                                                                                     : nullptr;
  }

  RulePass passOf(const Outputs& outputs, int level) {
    RulePass pass;
    pass.outputs = outputs;
    std::vector<bool> needed(static_cast<std::size_t>(graph_.size()));
    for (const RulePass::Output& output : outputs) needed[static_cast<std::size_t>(output.node)] = true;
    for (int i = graph_.size() - 1; i >= 0; --i) {
      if (!needed[static_cast<std::size_t>(i)]) continue;
      const RuleNode& node = graph_.at(i);
      if (graph_.isUniform(i)) {
        pass.uniforms.push_back(i);
        pass.usesTime = pass.usesTime || dependsOnTime(i);
      } else if (const int* plane = storedBefore(i, level)) {
        pass.reads.push_back({i, RuleOp::species, {RuleArray::lets, *plane}});
      } else if (isStencil(node.op)) {
        pass.reads.push_back({i, node.op, planeOf(node.a)});
      } else if (node.op == RuleOp::species || node.op == RuleOp::base || node.op == RuleOp::sum ||
                 node.op == RuleOp::weight) {
        pass.reads.push_back({i, RuleOp::species, planeOf(i)});
      } else {
        pass.nodes.push_back(i);
        pass.usesNoise = pass.usesNoise || node.op == RuleOp::noise;
        for (const int argument : {node.a, node.b, node.c})
          if (argument >= 0) needed[static_cast<std::size_t>(argument)] = true;
      }
    }
    std::reverse(pass.nodes.begin(), pass.nodes.end());
    std::sort(pass.uniforms.begin(), pass.uniforms.end());
    return pass;
  }

  [[nodiscard]] RulePlane planeOf(int node) const {
    const RuleNode& n = graph_.at(node);
    switch (n.op) {
      case RuleOp::species:
        return {RuleArray::stage, n.index};
      case RuleOp::base:
        return {RuleArray::base, n.index};
      case RuleOp::sum:
        return {RuleArray::sum, n.index};
      case RuleOp::weight:
        return {RuleArray::weights, n.index};
      default:
        return {RuleArray::lets, planes_.at(node)};
    }
  }

  [[nodiscard]] bool dependsOnTime(int node) const {
    const std::vector<bool> needed = neededBy({node});
    for (int i = 0; i < graph_.size(); ++i)
      if (needed[static_cast<std::size_t>(i)] && graph_.at(i).op == RuleOp::uniform &&
          graph_.at(i).index == UniformIndex::time)
        return true;
    return false;
  }

  Rule& rule_;
  RuleGraph& graph_;
  std::vector<int> levels_;
  std::map<int, int> planes_;   ///< let plane of each node that has one
  std::map<int, int> settled_;  ///< stored (settled) node of each node with a plane
};

}  // namespace

int RulePass::placeOf(int node) const {
  const auto found = std::lower_bound(uniforms.begin(), uniforms.end(), node);
  return found != uniforms.end() && *found == node ? static_cast<int>(found - uniforms.begin()) : -1;
}

RuleProgram programOf(Rule& rule, RuleMethod method) {
  return Planning(rule).whole(method);
}

}  // namespace simreel::sim
