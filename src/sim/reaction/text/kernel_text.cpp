#include "sim/reaction/text/kernel_text.hpp"

#include "sim/reaction/text/node_text.hpp"

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
  KernelWriter(const Rule& rule, const RulePass& pass, RuleSpace space, RuleBoundary boundary,
               unsigned seed, const WorkSplit& cut)
      : rule_(rule), pass_(pass), space_(space), boundary_(boundary), seed_(seed), cut_(cut) {
    if (isVolume()) cut_.rows = cut.volumeRows;
    for (const RulePass::Read& read : pass.reads) {
      Use& use = uses_[read.plane];
      use.above = use.above || (read.op != RuleOp::species && !isMesh());
      use.sides = use.sides || read.op == RuleOp::sixfold || read.op == RuleOp::edges ||
                  read.op == RuleOp::corners || read.op == RuleOp::tips;
      use.across = use.across || read.op == RuleOp::across;
      use.deep = use.deep || read.op == RuleOp::deep;
    }
  }

  std::string text() {
    line("#include \"reaction/grid.glsl\"");
    if (isMesh())
      line("layout(local_size_x = 64) in;");
    else
      line("layout(local_size_x = {}, local_size_y = {}) in;", cut_.groupX, cut_.groupY);
    declareArrays();
    declareUniforms();
    for (const auto& [plane, use] : uses_) declareRow(plane, use);
    writeMain();
    return std::move(text_);
  }

 private:
  /// Accesses to a plane other than the current cell: rows above and below, sums or differences of columns,
  /// and layers in a volume.
  struct Use {
    bool above = false, sides = false, across = false, deep = false;
  };
  [[nodiscard]] bool isVolume() const { return space_ == RuleSpace::volume; }
  [[nodiscard]] bool isMesh() const { return space_ == RuleSpace::mesh; }
  /// Returns the variable that holds a row's index in its plane.
  [[nodiscard]] const char* rowName() const { return isVolume() ? "row" : "y"; }

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
    if (isMesh()) line("INPUT_WORDS(linksBinding, linksBlock, links)");
  }

  void declareUniforms() { text_ += uniformText(pass_, boundary_); }

  /// Writes the declaration of a struct that holds the four cells of a row and the sums or differences of
  /// the adjacent cells.
  void declareRow(const RulePlane& plane, const Use& use) {
    const std::string name = nameOf(plane);
    const bool inPlace = plane.array == RuleArray::sum;
    line("vec4 {}At(int x, int row) {{ return {}({}, ({} * PLANE_ROWS + row) * columns + x); }}", name,
         inPlace ? "LOAD_ONCE" : "LOAD_INPUT", nameOf(plane.array), plane.plane);
    if (isMesh() && use.sides)
      line(
          "vec4 {0}Of(ivec4 n) {{ return vec4({0}At(n.x >> 2, 0)[n.x & 3], {0}At(n.y >> 2, 0)[n.y & 3], "
          "{0}At(n.z >> 2, 0)[n.z & 3], {0}At(n.w >> 2, 0)[n.w & 3]); }}",
          name);
    if (!use.above) return;
    line("struct {0}Row {{ vec4 here; vec4 sides; vec4 across;{1} }};", name,
         isVolume() ? " vec4 faces; vec4 sidesOfLayers; vec4 deep;" : "");
    line("{0}Row {0}{1}(int x, int y{2}) {{", name, isVolume() ? "LineAt" : "RowAt",
         isVolume() ? ", int z" : "");
    line("  {}Row r;", name);
    line("  int row = {}rowAt(y);", isVolume() ? "layerAt(z) * size.y + " : "");
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
      line("  if (y < 0 || y >= size.y{}) {{ here = vec4({}); {} }}",
           isVolume() ? " || z < 0 || z >= depth" : "", edge,
           use.sides || use.across ? "left = here; right = here;" : "");
    }
    if (use.sides) line("  precise vec4 sides = left + right;");
    if (use.across) line("  precise vec4 across = right - left;");
    line("  r.here = here;");
    line("  r.sides = {};", use.sides ? "sides" : "here");
    line("  r.across = {};", use.across ? "across" : "here");
    if (isVolume()) line("  r.faces = here; r.sidesOfLayers = here; r.deep = here;");
    line("  return r;");
    line("}}");
    if (isVolume()) declareLayers(name, use);
  }

  /// Writes the declaration of the function that combines a row with the same row of the previous layer and
  /// of the next layer.
  void declareLayers(const std::string& name, const Use& use) {
    line("{0}Row {0}RowAt(int x, int y, int z) {{", name);
    line("  {0}Row r = {0}LineAt(x, y, z);", name);
    if (use.sides || use.deep)
      line("  {0}Row before = {0}LineAt(x, y, z - 1), behind = {0}LineAt(x, y, z + 1);", name);
    if (use.sides) {
      line("  precise vec4 faces = before.here + behind.here;");
      line("  precise vec4 sidesOfLayers = before.sides + behind.sides;");
      line("  r.faces = faces; r.sidesOfLayers = sidesOfLayers;");
    }
    if (use.deep) {
      line("  precise vec4 deep = behind.here - before.here;");
      line("  r.deep = deep;");
    }
    line("  return r;");
    line("}}");
  }

  static std::string edgeOf(int species) {
    return fmt::format("{}.{}", species < 4 ? "edgesLow" : "edgesHigh", "xyzw"[species % 4]);
  }

  void writeMain() {
    line("void main() {{");
    if (isVolume()) {
      line("  int x = int(gl_GlobalInvocationID.x), z = int(gl_GlobalInvocationID.y) / layerItems;");
      line("  int top = (int(gl_GlobalInvocationID.y) - z * layerItems) * {};", cut_.rows);
      line("  if (x >= columns || z >= depth) return;");
    } else if (isMesh()) {
      line("  int x = int(gl_GlobalInvocationID.x), top = 0;");
      line("  if (x >= columns) return;");
    } else {
      line("  int x = int(gl_GlobalInvocationID.x), top = int(gl_GlobalInvocationID.y) * {};", cut_.rows);
      line("  if (x >= columns || top >= size.y) return;");
    }
    const char* layer = isVolume() ? ", z" : "";
    for (const auto& [plane, use] : uses_)
      if (use.above) {
        const std::string name = nameOf(plane);
        line("  {0}Row {0}Above = {0}RowAt(x, top - 1{1}), {0}Here = {0}RowAt(x, top{1});", name, layer);
      }
    line("  int lost = 0, lostRow = 0;");
    line("  for (int j = 0; j < {}; ++j) {{", isMesh() ? 1 : cut_.rows);
    line("    int y = top + j;");
    if (isVolume()) line("    int row = z * size.y + y;");
    for (const auto& [plane, use] : uses_) {
      const std::string name = nameOf(plane);
      if (use.above)
        line("    {0}Row {0}Below = {0}RowAt(x, y + 1{1});", name, layer);
      else
        line("    vec4 {0}Cells = {0}At(x, {1}min(y, size.y - 1));", name,
             isVolume() ? "z * size.y + " : "");
      if (isMesh()) continue;
      if (use.sides && isVolume()) {
        line(
            "    precise vec4 {0}Corners = ({0}Above.sides + {0}Below.sides) + ({0}Here.sidesOfLayers + "
            "({0}Above.faces + {0}Below.faces));",
            name);
        line(
            "    precise vec4 {0}Edges = {0}Here.sides + (({0}Above.here + {0}Below.here) + "
            "{0}Here.faces);",
            name);
      } else if (use.sides) {
        line("    precise vec4 {0}Corners = {0}Above.sides + {0}Below.sides;", name);
        line("    precise vec4 {0}Edges = {0}Here.sides + ({0}Above.here + {0}Below.here);", name);
      }
    }
    if (isMesh()) writeLinks();
    for (const RulePass::Read& read : pass_.reads) writeRead(read);
    for (const int node : pass_.nodes) writeNode(node);
    writeOutputs();
    for (const auto& [plane, use] : uses_)
      if (use.above) line("    {0}Above = {0}Here; {0}Here = {0}Below;", nameOf(plane));
    line("  }}");
    line("  if (lost >= lostBits) noteCell(lost, x, lostRow);");
    line("}}");
  }

  /// Writes one loop over the neighbours of a mesh's cells that computes the sums of all planes.
  void writeLinks() {
    bool any = false;
    for (const auto& [plane, use] : uses_) {
      if (!use.sides) continue;
      any = true;
      line("    vec4 {0}Sum = vec4(0.0), {0}Edges = vec4(0.0);", nameOf(plane));
    }
    if (!any) return;
    line("    ivec2 range = ivec2(LOAD_INPUT_WORDS(links, x).xy);");
    line("    for (int s = range.x; s < range.y; ++s) {{");
    line("      ivec4 n = ivec4(LOAD_INPUT_WORDS(links, columns + 2 * s));");
    line("      vec4 weight = uintBitsToFloat(LOAD_INPUT_WORDS(links, columns + 2 * s + 1));");
    for (const auto& [plane, use] : uses_)
      if (use.sides) {
        line("      vec4 {0}There = {0}Of(max(n, 0));", nameOf(plane));
        line("      precise vec4 {0}Difference = {0}There - {0}Cells;", nameOf(plane));
        line("      precise vec4 {0}Term = weight * {0}Difference;", nameOf(plane));
        line("      precise vec4 {0}New = {0}Sum + {0}Term;", nameOf(plane));
        line("      {0}Sum = {0}New;", nameOf(plane));
        line("      precise vec4 {0}More = {0}Edges + mix({0}There, vec4(0.0), lessThan(n, ivec4(0)));",
             nameOf(plane));
        line("      {0}Edges = {0}More;", nameOf(plane));
      }
    line("    }}");
  }

  void writeRead(const RulePass::Read& read) {
    const std::string name = nameOf(read.plane);
    const int n = read.node;
    if (isMesh() && read.op == RuleOp::sixfold) return line("    vec4 v{} = {}Sum;", n, name);
    switch (read.op) {
      case RuleOp::sixfold:
        // The product with 4 or 2 is exact, so fma gives the same bits as a product followed by a sum.
        line("    precise vec4 v{0} = fma(vec4({2}.0), {1}Edges, {1}Corners) - {3}.0 * {1}Here.here;", n,
             name, isVolume() ? 2 : 4, isVolume() ? 24 : 20);
        break;
      case RuleOp::edges:
        line("    vec4 v{} = {}Edges;", n, name);
        break;
      case RuleOp::corners:
        line("    vec4 v{} = {}Corners;", n, name);
        break;
      case RuleOp::tips:
        line("    precise vec4 v{0} = {1}Above.sidesOfLayers + {1}Below.sidesOfLayers;", n, name);
        break;
      case RuleOp::across:
        line("    vec4 v{} = {}Here.across;", n, name);
        break;
      case RuleOp::down:
        line("    precise vec4 v{0} = {1}Below.here - {1}Above.here;", n, name);
        break;
      case RuleOp::deep:
        line("    vec4 v{} = {}Here.deep;", n, name);
        break;
      default:
        line("    vec4 v{} = {}{};", n, name, uses_.at(read.plane).above ? "Here.here" : "Cells");
    }
  }

  [[nodiscard]] std::string value(int node) const {
    return pass_.placeOf(node) >= 0 ? fmt::format("vec4(k{})", node) : fmt::format("v{}", node);
  }

  void writeNode(int i) {
    text_ += nodeText(
        rule_.graph, i, [this](int node) { return value(node); }, seed_, rowName());
  }

  // Writes the stores of the outputs. The generated code checks all rows for lost cells and reports at most
  // one at the end, because software drivers execute both sides of every branch.
  void writeOutputs() {
    line("    if (y < size.y) {{");
    for (const RulePass::Output& output : pass_.outputs)
      line("      STORE_STATE({}, ({} * PLANE_ROWS + {}) * columns + x, kept({}, x));",
           output.plane.array == RuleArray::sum ? "sum" : "next", output.plane.plane, rowName(),
           value(output.node));
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
    line("    lostRow = worst >= lostBits && lost < lostBits ? {} : lostRow;", rowName());
    line("    lost = lost < lostBits ? worst : lost;");
  }

  const Rule& rule_;
  const RulePass& pass_;
  RuleSpace space_;
  RuleBoundary boundary_;
  unsigned seed_;
  WorkSplit cut_;
  std::map<RulePlane, Use> uses_;
  std::string text_;
};

}  // namespace

std::string kernelText(const Rule& rule, const RulePass& pass, RuleSpace space, RuleBoundary boundary,
                       unsigned seed, const WorkSplit& cut) {
  return KernelWriter(rule, pass, space, boundary, seed, cut).text();
}

}  // namespace simreel::sim
