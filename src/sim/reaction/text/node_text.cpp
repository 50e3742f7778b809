#include "sim/reaction/text/node_text.hpp"

#include "base/error.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

template <class... Args>
void addLine(std::string& text, fmt::format_string<Args...> form, Args&&... args) {
  fmt::format_to(std::back_inserter(text), form, std::forward<Args>(args)...);
  text += '\n';
}

}  // namespace

std::string nodeText(const RuleGraph& graph, int i, const std::function<std::string(int node)>& value,
                     unsigned seed, const char* row) {
  std::string text;
  const RuleNode& node = graph.at(i);
  const auto argument = [&](int n) { return n < 0 ? std::string() : value(n); };
  const std::string a = argument(node.a), b = argument(node.b), c = argument(node.c);
  const auto each = [&](const char* function) {
    addLine(text, "    vec4 a{} = {};", i, a);
    addLine(text, "    vec4 v{0} = EACH_CELL({1}, a{0});", i, function);
  };
  const unsigned salt = static_cast<unsigned>(node.index) * 2654435761U + seed;
  switch (node.op) {
    case RuleOp::x:
      addLine(text, "    precise vec4 v{} = cellsOf(x) + 0.5;", i);
      break;
    case RuleOp::y:
      addLine(text, "    precise vec4 v{} = vec4(float(y)) + 0.5;", i);
      break;
    case RuleOp::z:
      addLine(text, "    precise vec4 v{} = vec4(float(z)) + 0.5;", i);
      break;
    case RuleOp::noise:
      addLine(text, "    vec4 v{} = hashed(x, {}, uint(stepNumber), {}u);", i, row, salt);
      break;
    case RuleOp::random:
      addLine(text, "    vec4 v{} = hashed(x, {}, {}u, {}u);", i, row, 0x5eed5eedU, salt);
      break;
    case RuleOp::add:
      addLine(text, "    precise vec4 v{} = {} + {};", i, a, b);
      break;
    case RuleOp::subtract:
      addLine(text, "    precise vec4 v{} = {} - {};", i, a, b);
      break;
    case RuleOp::multiply:
      addLine(text, "    precise vec4 v{} = {} * {};", i, a, b);
      break;
    case RuleOp::flush:
      addLine(text, "    vec4 v{} = grained({}, flushedGrain);", i, a);
      break;
    case RuleOp::settle:
      addLine(text, "    vec4 v{} = grained({}, storedGrain);", i, a);
      break;
    case RuleOp::reciprocal:
      each("exactReciprocal");
      break;
    case RuleOp::min:
      addLine(text, "    vec4 v{} = min({}, {});", i, a, b);
      break;
    case RuleOp::max:
      addLine(text, "    vec4 v{} = max({}, {});", i, a, b);
      break;
    case RuleOp::abs:
      addLine(text, "    vec4 v{} = abs({});", i, a);
      break;
    case RuleOp::floor:
      addLine(text, "    vec4 v{} = floor({});", i, a);
      break;
    case RuleOp::sqrt:
      each("rootOf");
      break;
    case RuleOp::exp:
      each("exactExp");
      break;
    case RuleOp::log:
      each("logOf");
      break;
    case RuleOp::sin:
      each("exactSin");
      break;
    case RuleOp::cos:
      each("exactCos");
      break;
    case RuleOp::tanh:
      each("exactTanh");
      break;
    case RuleOp::power:
      addLine(text, "    vec4 a{0} = {1}, b{0} = {2};", i, a, b);
      addLine(text, "    vec4 v{0} = EACH_PAIR(exactPow, a{0}, b{0});", i);
      break;
    case RuleOp::less:
      addLine(text, "    vec4 v{} = vec4(lessThan({}, {}));", i, a, b);
      break;
    case RuleOp::lessEqual:
      addLine(text, "    vec4 v{} = vec4(lessThanEqual({}, {}));", i, a, b);
      break;
    case RuleOp::equal:
      addLine(text, "    vec4 v{} = vec4(equal({}, {}));", i, a, b);
      break;
    case RuleOp::choose:
      addLine(text, "    vec4 v{} = mix({}, {}, notEqual({}, vec4(0.0)));", i, c, b, a);
      break;
    default:
      SIMREEL_CHECK(false);
  }
  return text;
}

std::string uniformText(const RulePass& pass, RuleBoundary boundary) {
  std::string text;
  const std::size_t count = uniformVectors(pass);
  addLine(text, "layout(std140, binding = stepBinding) uniform UniformBlock {{ vec4 uniforms[{}]; }};",
          count);
  for (std::size_t i = 0; i < pass.uniforms.size(); ++i)
    addLine(text, "float k{} = once(uniforms[{}].{});", pass.uniforms[i], i / 4, "xyzw"[i % 4]);
  const std::size_t grains = count - 3;
  addLine(text, "float storedGrain = once(uniforms[{}].x), flushedGrain = once(uniforms[{}].y);", grains,
          grains);
  if (boundary == RuleBoundary::fixed)
    addLine(text, "vec4 edgesLow = once(uniforms[{}]), edgesHigh = once(uniforms[{}]);", grains + 1,
            grains + 2);
  return text;
}

std::size_t uniformVectors(const RulePass& pass) {
  return (pass.uniforms.size() + 4) / 4 + 3;
}

}  // namespace simreel::sim
