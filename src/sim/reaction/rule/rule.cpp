#include "sim/reaction/rule/rule.hpp"

#include "scene/json/words.hpp"
#include "sim/reaction/rule/rule_cost.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

using scene::ExpressionTree;
using scene::Operation;
using RulePath = std::vector<std::string>;

class Understanding {
 public:
  explicit Understanding(const RuleText& text) : text_(text) {
    if (isVolume()) rule_.graph = RuleGraph(6, 12);
    rule_.uniforms.parameters = static_cast<int>(text.parameters.size());
    checkNames();
    for (const RuleText::Let& let : text.lets)
      lets_[let.name] = {parsed({"lets", let.name, "is"}, let.text), {}};
  }

  Rule whole() {
    std::vector<ExpressionTree> rates;
    for (const RuleText::Species& species : text_.species) {
      const RulePath path = {"species", species.name, "rate"};
      rates.push_back(parsed(path, species.rate));
      const auto i = static_cast<int>(rates.size()) - 1;
      int rate = nodeOf(path, rates.back());
      if (species.diffuses)
        rate = graph().sum(
            rate, graph().product(graph().uniform(rule_.uniforms.diffusion(i)),
                                  graph().stencil(RuleOp::sixfold, graph().input(RuleOp::species, i))));
      rule_.rates.push_back(rate);
      rule_.nexts.push_back(-1);
      if (species.next.empty()) continue;
      const RulePath next = {"species", species.name, "next"};
      if (species.diffuses || species.rate != "0")
        throw RuleMistake{next, 0, species.next.size(),
                          fmt::format("{} has a \"next\"; leave out its \"rate\" and \"diffusion\"",
                                      scene::inQuotes(species.name))};
      nexts_.push_back(parsed(next, species.next));
      rule_.nexts.back() = nodeOf(next, nexts_.back());
    }
    for (const RuleText::Let& let : text_.lets)
      static_cast<void>(letNode(let.name, {"lets", let.name, "is"}, 0, 1));
    const std::string show = text_.show.empty() ? text_.species[0].name : text_.show;
    rule_.shown = nodeOf({"show"}, parsed({"show"}, show));
    const RulePath tint = {"surface", "color"};
    if (!text_.tint.empty()) rule_.tint = nodeOf(tint, parsed(tint, text_.tint));
    starting_ = true;
    for (const RuleText::Species& species : text_.species) {
      const RulePath path = {"species", species.name, "start"};
      rule_.starts.push_back(nodeOf(path, parsed(path, species.start)));
    }
    for (const RuleText::Parameter& parameter : text_.parameters)
      if (!parameter.mayBeIdle && std::find(used_.begin(), used_.end(), parameter.name) == used_.end())
        throw RuleMistake{
            {"parameters", parameter.name},
            0,
            0,
            fmt::format("no expression has the parameter {}; leave it out, or {}",
                        scene::inQuotes(parameter.name), scene::suggestion(parameter.name, used_))};
    weigh();
    write(rates);
    return std::move(rule_);
  }

 private:
  struct LetState {
    ExpressionTree tree;
    std::optional<int> node;
    bool isOpen = false;
  };

  RuleGraph& graph() { return rule_.graph; }
  [[nodiscard]] bool isVolume() const { return text_.space == RuleSpace::volume; }
  [[nodiscard]] bool isMesh() const { return text_.space == RuleSpace::mesh; }
  [[nodiscard]] bool hasDepth() const { return text_.space != RuleSpace::plane; }

  void checkNames() const {
    std::map<std::string, const char*> known;
    const auto check = [&](const std::string& name, const char* group) {
      if (!scene::isExpressionName(name))
        throw RuleMistake{{group, name},
                          0,
                          0,
                          fmt::format("{} cannot be a name in expressions: letters, digits and _, no digit "
                                      "first, not x, y, t, pi and no function",
                                      scene::inQuotes(name))};
      if (hasDepth() && (name == "z" || name == "depth"))
        throw RuleMistake{
            {group, name},
            0,
            0,
            fmt::format("{} is reserved in expressions of volumes and meshes; use another name",
                        scene::inQuotes(name))};
      if (const auto before = known.emplace(name, group); !before.second)
        throw RuleMistake{
            {group, name},
            0,
            0,
            fmt::format("{} is a name in \"{}\" already", scene::inQuotes(name), before.first->second)};
    };
    for (const auto& species : text_.species) check(species.name, "species");
    for (const auto& parameter : text_.parameters) check(parameter.name, "parameters");
    for (const auto& let : text_.lets) check(let.name, "lets");
  }

  static ExpressionTree parsed(const RulePath& path, const std::string& text) {
    try {
      return scene::parseExpression(text);
    } catch (const scene::ExpressionMistake& mistake) {
      throw RuleMistake{path, mistake.begin, mistake.end, mistake.message};
    }
  }

  /// Adds the nodes of an expression tree and returns its root. In the tree, arguments precede the nodes
  /// that use them, so recursion occurs only for lets (named subexpressions).
  int nodeOf(const RulePath& path, const ExpressionTree& tree) {
    std::vector<int> nodes;
    nodes.reserve(tree.nodes.size());
    for (const ExpressionTree::Node& node : tree.nodes) {
      int arguments[3] = {-1, -1, -1};
      for (int i = 0; i < 3; ++i)
        if (node.arguments[i] >= 0) arguments[i] = nodes[static_cast<std::size_t>(node.arguments[i])];
      nodes.push_back(combined(path, tree, node, arguments));
      if (graph().size() > 16 * maxRuleCost)
        throw RuleMistake{path, node.begin, node.end, "the rule is too large"};
    }
    return nodes.back();
  }

  int named(const RulePath& path, const ExpressionTree::Node& node) {
    const std::string& name = node.name;
    RuleGraph& g = graph();
    if (isMesh() && (name == "x" || name == "y" || name == "z"))
      return g.input(RuleOp::weight, static_cast<int>(text_.parameters.size()) + (name[0] - 'x'));
    if (name == "x") return g.product(g.input(RuleOp::x, 0), g.uniform(UniformIndex::spacing));
    if (name == "y") return g.product(g.input(RuleOp::y, 0), g.uniform(UniformIndex::spacing));
    if (name == "t") return g.uniform(UniformIndex::time);
    if (name == "width") return g.uniform(UniformIndex::width);
    if (name == "height") return g.uniform(UniformIndex::height);
    if (isVolume() && name == "z")
      return g.product(g.input(RuleOp::z, 0), g.uniform(UniformIndex::spacing));
    if (hasDepth() && name == "depth") return g.uniform(UniformIndex::depth);
    if (name == "pi") return g.constant(std::numbers::pi);
    for (std::size_t i = 0; i < text_.parameters.size(); ++i) {
      if (text_.parameters[i].name != name) continue;
      used_.push_back(name);
      const auto index = static_cast<int>(i);
      if (text_.parameters[i].isField) {
        if (starting_)
          throw RuleMistake{path, node.begin, node.end,
                            "no other object has a field yet when \"start\" is made"};
        return g.input(RuleOp::weight, index);
      }
      const int value = g.uniform(UniformIndex::value(index));
      if (!text_.parameters[i].isMapped) return value;
      return g.sum(value, g.product(g.uniform(rule_.uniforms.span(index)), g.input(RuleOp::weight, index)));
    }
    for (std::size_t i = 0; i < text_.species.size(); ++i)
      if (text_.species[i].name == name) {
        if (starting_)
          throw RuleMistake{path, node.begin, node.end,
                            "\"start\" can use only parameters, x, y and random"};
        return g.input(RuleOp::species, static_cast<int>(i));
      }
    if (lets_.contains(name)) return letNode(name, path, node.begin, node.end);
    std::vector<std::string> known = {"x", "y", "t", "pi", "width", "height"};
    if (hasDepth()) known.insert(known.end(), {"z", "depth"});
    for (const auto& species : text_.species) known.push_back(species.name);
    for (const auto& parameter : text_.parameters) known.push_back(parameter.name);
    for (const auto& let : text_.lets) known.push_back(let.name);
    throw RuleMistake{
        path, node.begin, node.end,
        fmt::format("unknown name {}; {}", scene::inQuotes(name), scene::suggestion(name, known))};
  }

  int letNode(const std::string& name, const RulePath& path, std::size_t begin, std::size_t end) {
    LetState& let = lets_.at(name);
    if (starting_)
      throw RuleMistake{path, begin, end, "\"start\" can use only parameters, x, y and random"};
    if (let.isOpen) {
      open_.push_back(name);
      open_.erase(open_.begin(), std::find(open_.begin(), open_.end(), name));
      throw RuleMistake{
          path, begin, end,
          fmt::format("the definitions of \"lets\" form a circle: {}", fmt::join(open_, " needs "))};
    }
    if (!let.node) {
      let.isOpen = true;
      open_.push_back(name);
      let.node = nodeOf({"lets", name, "is"}, let.tree);
      open_.pop_back();
      let.isOpen = false;
    }
    return *let.node;
  }

  int truth(int a) { return graph().choose(a, graph().constant(1), graph().constant(0)); }

  int combined(const RulePath& path, const ExpressionTree& tree, const ExpressionTree::Node& node,
               const int (&n)[3]) {
    RuleGraph& g = graph();
    const auto refuse = [&](const char* message) -> int {
      throw RuleMistake{path, node.begin, node.end, message};
    };
    if (starting_ && (node.operation >= Operation::laplacian && node.operation <= Operation::noise))
      return refuse("\"start\" cannot use neighbours or noise");
    const bool squares = (node.operation >= Operation::ddx && node.operation <= Operation::ddz) ||
                         node.operation == Operation::corners;
    if (isMesh() && squares)
      return refuse("a mesh has no rows of cells; use laplacian, diffuse, neighbours or around");
    const bool sums = node.operation == Operation::neighbours || node.operation == Operation::around;
    if (isMesh() && sums && g.isUniform(n[0]))
      return refuse(
          "this sum has the same term in each cell, but cells of a mesh have different numbers of "
          "neighbours; sum an expression that varies from cell to cell");
    switch (node.operation) {
      case Operation::number:
        return g.constant(node.number);
      case Operation::name:
        return named(path, node);
      case Operation::negate:
        return g.difference(g.constant(0), n[0]);
      case Operation::add:
        return g.sum(n[0], n[1]);
      case Operation::subtract:
        return g.difference(n[0], n[1]);
      case Operation::multiply:
        return g.product(n[0], n[1]);
      case Operation::divide:
        if (g.isConstant(n[1]) && g.at(n[1]).number == 0) return refuse("division by zero");
        return g.quotient(n[0], n[1]);
      case Operation::power:
        return power(path, tree.at(node.arguments[1]), n[0], n[1]);
      case Operation::less:
        return g.function(RuleOp::less, n[0], n[1]);
      case Operation::lessEqual:
        return g.function(RuleOp::lessEqual, n[0], n[1]);
      case Operation::equal:
        return g.function(RuleOp::equal, n[0], n[1]);
      case Operation::notEqual:
        return g.difference(g.constant(1), g.function(RuleOp::equal, n[0], n[1]));
      case Operation::both:
        return g.choose(n[0], truth(n[1]), g.constant(0));
      case Operation::either:
        return g.choose(n[0], g.constant(1), truth(n[1]));
      case Operation::opposite:
        return g.choose(n[0], g.constant(0), g.constant(1));
      case Operation::min:
        return g.function(RuleOp::min, n[0], n[1]);
      case Operation::max:
        return g.function(RuleOp::max, n[0], n[1]);
      case Operation::clamp:
        return g.function(RuleOp::min, g.function(RuleOp::max, n[0], n[1]), n[2]);
      case Operation::step:
        return g.function(RuleOp::lessEqual, n[0], n[1]);
      case Operation::abs:
        return g.function(RuleOp::abs, n[0]);
      case Operation::floor:
        return g.function(RuleOp::floor, n[0]);
      case Operation::sqrt:
        return g.function(RuleOp::sqrt, n[0]);
      case Operation::exp:
        return g.function(RuleOp::exp, n[0]);
      case Operation::log:
        return g.function(RuleOp::log, n[0]);
      case Operation::sin:
        return g.function(RuleOp::sin, n[0]);
      case Operation::cos:
        return g.function(RuleOp::cos, n[0]);
      case Operation::tanh:
        return g.function(RuleOp::tanh, n[0]);
      case Operation::choose:
        return g.choose(n[0], n[1], n[2]);
      case Operation::laplacian:
        return laplacian(n[0]);
      case Operation::ddx:
        return g.product(g.uniform(UniformIndex::perGradient), g.stencil(RuleOp::across, n[0]));
      case Operation::ddy:
        return g.product(g.uniform(UniformIndex::perGradient), g.stencil(RuleOp::down, n[0]));
      case Operation::ddz:
        if (!isVolume()) return refuse("a flat grid has no z; give it a \"depth\"");
        return g.product(g.uniform(UniformIndex::perGradient), g.stencil(RuleOp::deep, n[0]));
      case Operation::diffuse:
        return diffuse(n[0], n[1]);
      case Operation::neighbours:
        return g.stencil(RuleOp::edges, n[0]);
      case Operation::corners:
        return g.stencil(RuleOp::corners, n[0]);
      case Operation::around: {
        const int edges = g.stencil(RuleOp::edges, n[0]);
        if (isMesh()) return edges;
        const int flat = g.sum(edges, g.stencil(RuleOp::corners, n[0]));
        return isVolume() ? g.sum(flat, g.stencil(RuleOp::tips, n[0])) : flat;
      }
      case Operation::noise:
        return g.input(RuleOp::noise, static_cast<int>(tree.at(node.arguments[0]).number));
      case Operation::random:
        return g.input(RuleOp::random, static_cast<int>(tree.at(node.arguments[0]).number));
    }
    return refuse("not understood");
  }

  int laplacian(int a) {
    return graph().product(graph().uniform(UniformIndex::perLaplacian),
                           graph().stencil(RuleOp::sixfold, a));
  }

  // Returns the diffusion with a variable coefficient D. With the neighbours j of cell i and the weights w:
  // sum w (D_i + D_j) / 2 (u_j - u_i) = (D_i lap(u) + lap(D u) - u_i lap(D)) / 2.
  int diffuse(int d, int u) {
    RuleGraph& g = graph();
    if (g.isUniform(d)) return g.product(d, laplacian(u));
    const int lap = g.stencil(RuleOp::sixfold, u), both = g.stencil(RuleOp::sixfold, g.product(d, u));
    const int twice =
        g.difference(g.sum(g.product(d, lap), both), g.product(u, g.stencil(RuleOp::sixfold, d)));
    return g.product(g.product(g.constant(0.5), g.uniform(UniformIndex::perLaplacian)), twice);
  }

  int power(const RulePath& path, const ExpressionTree::Node& written, int base, int exponent) {
    RuleGraph& g = graph();
    if (!g.isConstant(exponent)) return g.function(RuleOp::power, base, exponent);
    const float number = g.at(exponent).number;
    const int whole = std::abs(number) <= greatestWholePower ? static_cast<int>(number) : 0;
    if (number == 0.5F) return g.function(RuleOp::sqrt, base);
    if (static_cast<float>(whole) != number || (whole == 0 && number != 0))
      return g.function(RuleOp::power, base, exponent);
    if (whole < 0 && g.isConstant(base) && g.at(base).number == 0)
      throw RuleMistake{path, written.begin, written.end, "division by zero"};
    // The power is computed by squaring, for example a^5 = a (a^2)^2.
    int result = g.constant(1), square = base;
    for (int left = std::abs(whole); left > 0; left /= 2) {
      if (left % 2 == 1) result = g.product(result, square);
      if (left > 1) square = g.product(square, square);
    }
    return whole < 0 ? g.function(RuleOp::reciprocal, result) : result;
  }

  void weigh() {
    rule_.cost = costOfRule(rule_);
    if (rule_.cost > maxRuleCost)
      throw RuleMistake{{"species"},
                        0,
                        0,
                        fmt::format("the rates need {} additions and multiplications per cell and step, "
                                    "but at most {} are allowed; make them simpler",
                                    rule_.cost, maxRuleCost)};
  }

  void write(const std::vector<ExpressionTree>& rates) {
    std::size_t next = 0;
    for (const RuleText::Let& let : text_.lets)
      rule_.text += fmt::format("{} = {};\n", let.name, lets_.at(let.name).tree.text());
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const RuleText::Species& species = text_.species[i];
      if (rule_.nexts[i] >= 0) {
        rule_.text += fmt::format("{} becomes {};\n", species.name, nexts_[next++].text());
        continue;
      }
      const std::string diffusion =
          species.diffuses ? fmt::format("diffusion_{0} * laplacian({0})", species.name) : "";
      const bool alone = species.diffuses && rates[i].nodes.size() == 1 && rates[i].at(0).number == 0 &&
                         rates[i].at(0).operation == Operation::number;
      rule_.text += fmt::format("d{}/dt = {}{};\n", species.name, diffusion,
                                alone ? "" : (species.diffuses ? " + " : "") + rates[i].text());
    }
  }

  const RuleText& text_;
  Rule rule_;
  std::map<std::string, LetState> lets_;
  std::vector<ExpressionTree> nexts_;
  std::vector<std::string> open_, used_;
  bool starting_ = false;
};

}  // namespace

Rule compileRule(const RuleText& text) {
  return Understanding(text).whole();
}

}  // namespace simreel::sim
