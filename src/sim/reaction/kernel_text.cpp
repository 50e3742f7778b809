#include "sim/reaction/kernel_text.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

const char* nameOf(RuleArray array) {
  switch (array) {
    case RuleArray::stage:
      return "stage";
    case RuleArray::base:
      return "base";
    case RuleArray::sum:
      return "sum";
    case RuleArray::lets:
      return "lets";
    case RuleArray::weights:
      return "weights";
    case RuleArray::next:
      break;
  }
  return "next";
}

std::string nameOf(const RulePlane& plane) {
  return fmt::format("{}{}", nameOf(plane.array), plane.plane);
}

class KernelWriter {
 public:
  KernelWriter(const Rule& rule, const RulePass& pass, RuleBoundary boundary, unsigned seed,
               const RuleCut& cut)
      : rule_(rule), pass_(pass), boundary_(boundary), seed_(seed), cut_(cut) {
    for (const RulePass::Read& read : pass.reads) {
      Use& use = uses_[read.plane];
      use.above = use.above || read.op != RuleOp::species;
      use.sides =
          use.sides || read.op == RuleOp::lap20 || read.op == RuleOp::edges || read.op == RuleOp::corners;
      use.across = use.across || read.op == RuleOp::across;
    }
  }

  std::string text() {
    line("#include \"reaction/grid.glsl\"");
    line("layout(local_size_x = {}, local_size_y = {}) in;", cut_.groupX, cut_.groupY);
    declareArrays();
    declareTold();
    for (const auto& [plane, use] : uses_) declareRow(plane, use);
    writeMain();
    return std::move(text_);
  }

 private:
  /// Of a plane: whether rows beside this one are looked at, and columns.
  struct Use {
    bool above = false, sides = false, across = false;
  };

  template <class... Args>
  void line(fmt::format_string<Args...> form, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Args>(args)...);
    text_ += '\n';
  }

  void declareArrays() {
    std::set<RuleArray> read;
    for (const auto& [plane, use] : uses_) read.insert(plane.array);
    for (const RuleArray array : read)
      if (array != RuleArray::sum) line("INPUT_ARRAY({0}Binding, {0}Block, {0})", nameOf(array));
    bool sums = read.contains(RuleArray::sum);
    for (const RulePass::Output& output : pass_.outputs)
      sums = sums || output.plane.array == RuleArray::sum;
    if (sums) line("STATE_ARRAY(sumBinding, sumBlock, sum)");
    line("STATE_ARRAY(nextBinding, nextBlock, next)");
  }

  void declareTold() {
    const std::size_t count = toldVectors(pass_);
    line("layout(std140, binding = stepBinding) uniform ToldBlock {{ vec4 told[{}]; }};", count);
    for (std::size_t i = 0; i < pass_.told.size(); ++i)
      line("float k{} = once(told[{}].{});", pass_.told[i], i / 4, "xyzw"[i % 4]);
    const std::size_t grains = count - 3;
    line("float storedGrain = once(told[{}].x), flushedGrain = once(told[{}].y);", grains, grains);
    if (boundary_ == RuleBoundary::fixed)
      line("vec4 edgesLow = once(told[{}]), edgesHigh = once(told[{}]);", grains + 1, grains + 2);
  }

  /// What an invocation holds of a row: the four cells and sums or differences of those beside them.
  void declareRow(const RulePlane& plane, const Use& use) {
    const std::string name = nameOf(plane);
    const bool inPlace = plane.array == RuleArray::sum;
    line("vec4 {}At(int x, int row) {{ return {}({}, ({} * size.y + row) * columns + x); }}", name,
         inPlace ? "LOAD_ONCE" : "LOAD_INPUT", nameOf(plane.array), plane.plane);
    if (!use.above) return;
    line("struct {0}Row {{ vec4 here; vec4 sides; vec4 across; }};", name);
    line("{0}Row {0}RowAt(int x, int y) {{", name);
    line("  {}Row r;", name);
    line("  int row = rowAt(y);");
    line("  vec4 here = {}At(x, row);", name);
    if (use.sides || use.across) {
      line("  vec4 left = leftOf({}At(columnAt(x - 1), row), here, x);", name);
      line("  vec4 right = rightOf(here, {}At(columnAt(x + 1), row), x);", name);
    }
    if (boundary_ == RuleBoundary::fixed && plane.array == RuleArray::stage) {
      const std::string edge = edgeOf(plane.plane);
      if (use.sides || use.across) {
        line("  if (x == 0) left.x = {};", edge);
        line("  if (x == columns - 1) right[TAIL] = {};", edge);
      }
      line("  if (y < 0 || y >= size.y) {{ here = vec4({}); {} }}", edge,
           use.sides || use.across ? "left = here; right = here;" : "");
    }
    if (use.sides) line("  precise vec4 sides = left + right;");
    if (use.across) line("  precise vec4 across = right - left;");
    line("  r.here = here;");
    line("  r.sides = {};", use.sides ? "sides" : "here");
    line("  r.across = {};", use.across ? "across" : "here");
    line("  return r;");
    line("}}");
  }

  static std::string edgeOf(int species) {
    return fmt::format("{}.{}", species < 4 ? "edgesLow" : "edgesHigh", "xyzw"[species % 4]);
  }

  void writeMain() {
    line("void main() {{");
    line("  int x = int(gl_GlobalInvocationID.x), top = int(gl_GlobalInvocationID.y) * {};", cut_.rows);
    line("  if (x >= columns || top >= size.y) return;");
    for (const auto& [plane, use] : uses_)
      if (use.above) {
        const std::string name = nameOf(plane);
        line("  {0}Row {0}Above = {0}RowAt(x, top - 1), {0}Here = {0}RowAt(x, top);", name);
      }
    line("  int lost = 0, lostRow = 0;");
    line("  for (int j = 0; j < {}; ++j) {{", cut_.rows);
    line("    int y = top + j;");
    for (const auto& [plane, use] : uses_) {
      const std::string name = nameOf(plane);
      if (use.above)
        line("    {0}Row {0}Below = {0}RowAt(x, y + 1);", name);
      else
        line("    vec4 {0}Cells = {0}At(x, min(y, size.y - 1));", name);
      if (use.sides) {
        line("    precise vec4 {0}Corners = {0}Above.sides + {0}Below.sides;", name);
        line("    precise vec4 {0}Edges = {0}Here.sides + ({0}Above.here + {0}Below.here);", name);
      }
    }
    for (const RulePass::Read& read : pass_.reads) writeRead(read);
    for (const int node : pass_.nodes) writeNode(node);
    writeOutputs();
    for (const auto& [plane, use] : uses_)
      if (use.above) line("    {0}Above = {0}Here; {0}Here = {0}Below;", nameOf(plane));
    line("  }}");
    line("  if (lost >= lostBits) noteCell(lost, x, lostRow);");
    line("}}");
  }

  void writeRead(const RulePass::Read& read) {
    const std::string name = nameOf(read.plane);
    const int n = read.node;
    switch (read.op) {
      case RuleOp::lap20:
        // The product by four is exact: the same bits in one instruction as in two.
        line("    precise vec4 v{0} = fma(vec4(4.0), {1}Edges, {1}Corners) - 20.0 * {1}Here.here;", n,
             name);
        break;
      case RuleOp::edges:
        line("    vec4 v{} = {}Edges;", n, name);
        break;
      case RuleOp::corners:
        line("    vec4 v{} = {}Corners;", n, name);
        break;
      case RuleOp::across:
        line("    vec4 v{} = {}Here.across;", n, name);
        break;
      case RuleOp::down:
        line("    precise vec4 v{0} = {1}Below.here - {1}Above.here;", n, name);
        break;
      default:
        line("    vec4 v{} = {}{};", n, name, uses_.at(read.plane).above ? "Here.here" : "Cells");
    }
  }

  [[nodiscard]] std::string value(int node) const {
    return pass_.placeOf(node) >= 0 ? fmt::format("vec4(k{})", node) : fmt::format("v{}", node);
  }

  void writeNode(int i) {
    const RuleNode& node = rule_.graph.at(i);
    const auto argument = [&](int n) { return n < 0 ? std::string() : value(n); };
    const std::string a = argument(node.a), b = argument(node.b), c = argument(node.c);
    const auto each = [&](const char* function) {
      line("    vec4 a{} = {};", i, a);
      line("    vec4 v{0} = EACH_CELL({1}, a{0});", i, function);
    };
    const unsigned salt = static_cast<unsigned>(node.index) * 2654435761U + seed_;
    switch (node.op) {
      case RuleOp::x:
        line("    precise vec4 v{} = cellsOf(x) + 0.5;", i);
        break;
      case RuleOp::y:
        line("    precise vec4 v{} = vec4(float(y)) + 0.5;", i);
        break;
      case RuleOp::noise:
        line("    vec4 v{} = hashed(x, y, uint(stepNumber), {}u);", i, salt);
        break;
      case RuleOp::random:
        line("    vec4 v{} = hashed(x, y, {}u, {}u);", i, 0x5eed5eedU, salt);
        break;
      case RuleOp::add:
        line("    precise vec4 v{} = {} + {};", i, a, b);
        break;
      case RuleOp::subtract:
        line("    precise vec4 v{} = {} - {};", i, a, b);
        break;
      case RuleOp::multiply:
        line("    precise vec4 v{} = {} * {};", i, a, b);
        break;
      case RuleOp::flush:
        line("    vec4 v{} = grained({}, flushedGrain);", i, a);
        break;
      case RuleOp::settle:
        line("    vec4 v{} = grained({}, storedGrain);", i, a);
        break;
      case RuleOp::reciprocal:
        return each("exactReciprocal");
      case RuleOp::min:
        line("    vec4 v{} = min({}, {});", i, a, b);
        break;
      case RuleOp::max:
        line("    vec4 v{} = max({}, {});", i, a, b);
        break;
      case RuleOp::abs:
        line("    vec4 v{} = abs({});", i, a);
        break;
      case RuleOp::floor:
        line("    vec4 v{} = floor({});", i, a);
        break;
      case RuleOp::sqrt:
        return each("rootOf");
      case RuleOp::exp:
        return each("exactExp");
      case RuleOp::log:
        return each("logOf");
      case RuleOp::sin:
        return each("exactSin");
      case RuleOp::cos:
        return each("exactCos");
      case RuleOp::tanh:
        return each("exactTanh");
      case RuleOp::power:
        line("    vec4 a{0} = {1}, b{0} = {2};", i, a, b);
        line("    vec4 v{0} = EACH_PAIR(exactPow, a{0}, b{0});", i);
        break;
      case RuleOp::less:
        line("    vec4 v{} = vec4(lessThan({}, {}));", i, a, b);
        break;
      case RuleOp::lessEqual:
        line("    vec4 v{} = vec4(lessThanEqual({}, {}));", i, a, b);
        break;
      case RuleOp::equal:
        line("    vec4 v{} = vec4(equal({}, {}));", i, a, b);
        break;
      case RuleOp::choose:
        line("    vec4 v{} = mix({}, {}, notEqual({}, vec4(0.0)));", i, c, b, a);
        break;
      default:
        SIMREEL_CHECK(false);
    }
  }

  // A lost cell is looked for in all rows and noted once: software drivers run the code of every branch.
  void writeOutputs() {
    line("    if (y < size.y) {{");
    for (const RulePass::Output& output : pass_.outputs)
      line("      STORE_STATE({}, ({} * size.y + y) * columns + x, kept({}, x));",
           output.plane.array == RuleArray::sum ? "sum" : "next", output.plane.plane, value(output.node));
    line("    }}");
    std::string worst;
    for (const RulePass::Output& output : pass_.outputs)
      if (output.plane.array == RuleArray::next) {
        const std::string one =
            fmt::format("exponentOf(kept({}, x), {})", value(output.node), output.plane.plane);
        worst = worst.empty() ? one : fmt::format("max({}, {})", worst, one);
      }
    if (worst.empty()) return;
    line("    int worst = y < size.y ? {} : 0;", worst);
    line("    lostRow = worst >= lostBits && lost < lostBits ? y : lostRow;");
    line("    lost = lost < lostBits ? worst : lost;");
  }

  const Rule& rule_;
  const RulePass& pass_;
  RuleBoundary boundary_;
  unsigned seed_;
  RuleCut cut_;
  std::map<RulePlane, Use> uses_;
  std::string text_;
};

}  // namespace

std::size_t toldVectors(const RulePass& pass) {
  return (pass.told.size() + 4) / 4 + 3;
}

std::string kernelText(const Rule& rule, const RulePass& pass, RuleBoundary boundary, unsigned seed,
                       const RuleCut& cut) {
  return KernelWriter(rule, pass, boundary, seed, cut).text();
}

}  // namespace simreel::sim
