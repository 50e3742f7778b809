#include "sim/reaction/text/node_text.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

bool isOfStrips(RuleOp op) {
  return op == RuleOp::species || op == RuleOp::sixfold || op == RuleOp::edges || op == RuleOp::corners ||
         op == RuleOp::down;
}

/// Writes a pass of several steps (glsl/reaction/strips.glsl) with the same operations in the same order as
/// in single steps.
class StripWriter {
 public:
  StripWriter(const Rule& rule, const RulePass& pass, const WorkSplit& cut)
      : rule_(rule), pass_(pass), cut_(cut), planes_(static_cast<int>(rule.rates.size())) {
    for (const RulePass::Read& read : pass.reads)
      if (read.op != RuleOp::species && read.op != RuleOp::down) sided_[read.plane.plane] = true;
  }

  std::string text() {
    line("#ifdef SUBGROUPS");
    line("#extension GL_KHR_shader_subgroup_shuffle_relative : require");
    line("#endif");
    line("#define STEPS {}", cut_.stepsPerPass);
    line("#define ELEMENTS {}", cut_.stripElements);
    line("#define STRIP_ROWS {}", cut_.stripRows);
    line("#include \"reaction/grid.glsl\"");
    line("#include \"reaction/strips.glsl\"");
    line("#ifdef TEXEL_PATH");
    line("layout(local_size_x = 8) in;");
    line("#else");
    line("layout(local_size_x = 32) in;");
    line("#endif");
    line("INPUT_ARRAY(stageBinding, stageBlock, stage)");
    line("STATE_ARRAY(nextBinding, nextBlock, next)");
    text_ += uniformText(pass_, RuleBoundary::torus);
    line("int lostColumn = 0;  // element of the first of an invocation's");
    line("bool sound[ELEMENTS];  // of a strip's elements, those that are stored");
    line("struct Row {{");
    for (int p = 0; p < planes_; ++p) line("  vec4 p{}[ELEMENTS];", p);
    line("}};");
    line("struct Level {{ Row above, aboveSides, here, hereSides; }};");
    writeSides();
    writeAdvanced();
    writeMain();
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> form, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Args>(args)...);
    text_ += '\n';
  }
  [[nodiscard]] bool sided(int plane) const { return sided_.contains(plane); }

  void writeSides() {
    line("Row sidesOf(Row row) {{");
    line("  Row sides = row;");
    line("  const int last = ELEMENTS - 1;");
    for (int p = 0; p < planes_; ++p) {
      if (!sided(p)) continue;
      line("  vec2 beside{0} = beside(row.p{0}[0].x, row.p{0}[last].w);", p);
      line("  for (int k = 0; k <= last; ++k) {{");
      line("    vec4 left = vec4(k > 0 ? row.p{0}[max(k - 1, 0)].w : beside{0}.x, row.p{0}[k].xyz);", p);
      line("    vec4 right = vec4(row.p{0}[k].yzw, k < last ? row.p{0}[min(k + 1, last)].x : beside{0}.y);",
           p);
      line("    precise vec4 sum = left + right;");
      line("    sides.p{}[k] = sum;", p);
      line("  }}");
    }
    line("  return sides;");
    line("}}");
  }

  [[nodiscard]] std::string value(int node) const {
    return pass_.placeOf(node) >= 0 ? fmt::format("vec4(k{})", node) : fmt::format("v{}", node);
  }

  // Writes the function that takes the row below and returns the current row one step later.
  void writeAdvanced() {
    line("Row advanced(inout Level level, Row below, int row, int number, bool stored) {{");
    line("  Row belowSides = sidesOf(below);");
    line("  Row made;");
    line("  for (int k = 0; k < ELEMENTS; ++k) {{");
    for (int p = 0; p < planes_; ++p) {
      line("    vec4 here{0} = level.here.p{0}[k];", p);
      if (!sided(p)) continue;
      line("    precise vec4 corners{0} = level.aboveSides.p{0}[k] + belowSides.p{0}[k];", p);
      line("    precise vec4 edges{0} = level.hereSides.p{0}[k] + (level.above.p{0}[k] + below.p{0}[k]);",
           p);
    }
    for (const RulePass::Read& read : pass_.reads) writeRead(read);
    for (const int node : pass_.nodes)
      text_ += nodeText(
          rule_.graph, node, [this](int n) { return value(n); }, 0, "row");
    std::string worst;
    for (const RulePass::Output& output : pass_.outputs) {
      line("    made.p{}[k] = {};", output.plane.plane, value(output.node));
      const std::string one = fmt::format("exponentOf({}, {})", value(output.node), output.plane.plane);
      worst = worst.empty() ? one : fmt::format("max({}, {})", worst, one);
    }
    line("    int worst = stored && sound[k] ? {} : 0;", worst);
    line("    if (worst >= lostBits) noteStrip(worst, lostColumn + k, row, number);");
    line("  }}");
    line("  level.above = level.here;");
    line("  level.aboveSides = level.hereSides;");
    line("  level.here = below;");
    line("  level.hereSides = belowSides;");
    line("  return made;");
    line("}}");
  }

  void writeRead(const RulePass::Read& read) {
    const int n = read.node, p = read.plane.plane;
    switch (read.op) {
      case RuleOp::sixfold:
        line("    precise vec4 v{0} = fma(vec4(4.0), edges{1}, corners{1}) - 20.0 * here{1};", n, p);
        break;
      case RuleOp::edges:
        line("    vec4 v{} = edges{};", n, p);
        break;
      case RuleOp::corners:
        line("    vec4 v{} = corners{};", n, p);
        break;
      case RuleOp::down:
        line("    precise vec4 v{0} = below.p{1}[k] - level.above.p{1}[k];", n, p);
        break;
      default:
        line("    vec4 v{} = here{};", n, p);
    }
  }

  void writeMain() {
    writeLoad();
    writeStart();
    // The loop is unrolled by three rows, so that the roles of the rows above, here and below rotate
    // without copies.
    line("  for (int i = 0; i < count; i += 3) {{");
    for (int turn = 0; turn < 3; ++turn) writeTurn(turn);
    line("  }}");
    line("}}");
  }

  void writeLoad() {
    line("Row loadRow(int columnsOf[ELEMENTS], bool back[ELEMENTS], int unfolded) {{");
    line("  Row loaded;");
    line("  int row = folded(unfolded, size.y);");
    line("  for (int k = 0; k < ELEMENTS; ++k) {{");
    for (int p = 0; p < planes_; ++p)
      line(
          "    loaded.p{0}[k] = facing(LOAD_INPUT(stage, ({0} * size.y + row) * columns + columnsOf[k]), "
          "back[k]);",
          p);
    line("  }}");
    line("  return loaded;");
    line("}}");
  }

  void writeStart() {
    line("void main() {{");
    line("#ifdef TEXEL_PATH");
    line("  int strip = int(gl_GlobalInvocationID.x);");
    line("#else");
    line("  int strip = int(gl_WorkGroupID.x);");
    line("#endif");
    line("  int x = strip * inside - border + lane * ELEMENTS;");
    line("  int top = int(gl_WorkGroupID.y) * STRIP_ROWS;");
    line("  int rows = min(STRIP_ROWS, size.y - top), count = rows + 2 * STEPS;");
    line("#ifdef TEXEL_PATH");
    line("  if (x + border >= columns) return;");
    line("#endif");
    line("  lostColumn = x;");
    line("  int columnsOf[ELEMENTS];");
    line("  bool back[ELEMENTS];");
    line("  Row nothing;");
    line("  for (int k = 0; k < ELEMENTS; ++k) {{");
    line("    int place = lane * ELEMENTS + k;");
    line("    int unfolded = wrapped(x + k, folds * columns);");
    line("    columnsOf[k] = folded(unfolded, columns);");
    line("    back[k] = unfolded >= columns;");
    line("    sound[k] = place >= border && place < border + inside && x + k < columns;");
    for (int p = 0; p < planes_; ++p) line("    nothing.p{}[k] = vec4(0);", p);
    line("  }}");
    line("  Level empty = Level(nothing, nothing, nothing, nothing);");
    for (int s = 0; s < cut_.stepsPerPass; ++s) line("  Level level{} = empty;", s);
    line("  int row = wrapped(top - STEPS, folds * size.y);");
    line("  Row pending = loadRow(columnsOf, back, row);");
  }

  void writeTurn(int turn) {
    line("    {{");
    line("      int now = i + {};", turn);
    line("      Row made = pending;");
    line("      row = row + 1 < folds * size.y ? row + 1 : 0;");
    line("      pending = loadRow(columnsOf, back, row);");
    for (int s = 0; s < cut_.stepsPerPass; ++s) {
      line("      int at{0} = now - STEPS - {1};", s, s + 1);
      line("      made = advanced(level{0}, made, top + at{0}, {0}, at{0} >= 0 && at{0} < rows);", s);
    }
    line("      if (now >= 2 * STEPS && now < count) {{");
    line("        int to = top + now - 2 * STEPS;");
    line("        for (int k = 0; k < ELEMENTS; ++k)");
    line("          if (sound[k]) {{");
    for (int p = 0; p < planes_; ++p)
      line("            STORE_STATE(next, ({0} * size.y + to) * columns + x + k, made.p{0}[k]);", p);
    line("          }}");
    line("      }}");
    line("    }}");
  }

  const Rule& rule_;
  const RulePass& pass_;
  WorkSplit cut_;
  int planes_;
  std::map<int, bool> sided_;
  std::string text_;
};

}  // namespace

bool stripsCan(const Rule& rule, const RuleProgram& program, RuleSpace space, RuleBoundary boundary,
               int width) {
  if (space != RuleSpace::plane || boundary == RuleBoundary::fixed || width % 4 != 0) return false;
  if (program.stages.size() != 1 || program.stages[0].passes.size() != 1) return false;
  const RulePass& pass = program.passes[static_cast<std::size_t>(program.stages[0].passes[0])];
  if (pass.usesTime) return false;
  const bool reads = std::all_of(pass.reads.begin(), pass.reads.end(), [&](const RulePass::Read& read) {
    // An odd stencil changes its sign in the mirrored values beyond an edge, so it requires a torus.
    const bool odd = read.op == RuleOp::down && boundary != RuleBoundary::torus;
    return read.plane.array == RuleArray::stage && isOfStrips(read.op) && !odd;
  });
  return reads && std::none_of(pass.nodes.begin(), pass.nodes.end(), [&](int node) {
           const RuleOp op = rule.graph.at(node).op;
           return op == RuleOp::x || op == RuleOp::y || op == RuleOp::noise || op == RuleOp::random;
         });
}

std::string stripText(const Rule& rule, const RulePass& pass, const WorkSplit& cut) {
  return StripWriter(rule, pass, cut).text();
}

}  // namespace simreel::sim
