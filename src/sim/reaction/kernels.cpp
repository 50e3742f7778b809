#include "sim/reaction/kernels.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/limits.hpp"
#include "sim/reaction/rule/model.hpp"
#include "sim/reaction/stability.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace simreel::sim {

/// Interface of the kernel of one pass of a rule. The generated shader text (reaction/text) reads only some
/// of the members.
struct RuleKernel {
  static constexpr auto file = "reaction/rule";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"stepNumber", int> stepNumber;
  gl::Uniform<"depth", int> depth;
  gl::Uniform<"planeRows", int> planeRows;
  gl::Uniform<"layerItems", int> layerItems;
  gl::In<"UniformBlock"> uniforms;
  gl::InOut<"StatusBlock"> status;
  gl::In<"stage"> stage;
  gl::In<"base"> base;
  gl::InOut<"sum"> sum;
  gl::In<"lets"> lets;
  gl::In<"weights"> maps;
  gl::In<"links"> links;
  gl::Out<"next"> next;
};

struct StripKernel {
  static constexpr auto file = "reaction/strips";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"stepNumber", int> stepNumber;
  gl::Uniform<"lostFirst", int> lostFirst;
  gl::In<"UniformBlock"> uniforms;
  gl::InOut<"StatusBlock"> status;
  gl::In<"stage"> stage;
  gl::Out<"next"> next;
  gl::InOut<"LostBlock"> lost;
};

struct LostKernel {
  static constexpr auto file = "reaction/lost.comp";
  gl::Uniform<"lostFirst", int> lostFirst;
  gl::Uniform<"count", int> count;
  gl::InOut<"StatusBlock"> status;
  gl::In<"LostBlock"> lost;
};

namespace {

/// Checks the device limits, before any array is allocated or filled.
void checkRuleLimits(const std::string& name, const ReactionParameters& p, std::int64_t planes) {
  const std::int64_t elements = std::int64_t{(p.size.x + 3) / 4} * p.size.y * p.depth * planes;
  const auto refuse = [&](std::int64_t need, const char* what, std::int64_t max, const char* limit) {
    if (need > max)
      fail(ExitCode::device,
           "reaction \"{}\" of {} cells needs {} {} in one buffer, this device allows {} ({}); make it "
           "smaller",
           name, p.cellsText(), need, what, max, limit);
  };
  refuse(elements * 16, "bytes", gl::limits().storageBlockBytes, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE");
  refuse(elements, "texels", gl::limits().texelBufferTexels, "GL_MAX_TEXTURE_BUFFER_SIZE");
}

/// Maximum number of steps for which lost cells are recorded separately; more than a frame usually has.
constexpr int lostSteps = 1024;

/// Returns the number of elements across a strip that the strip stores.
int stripWidth(const WorkSplit& cut) {
  const int lanes = gl::memoryPath() == gl::MemoryPath::texel ? 1 : 32;
  return lanes * cut.stripElements - (cut.stepsPerPass + 3) / 4 * 2;
}

/// Returns the number of rows per strip. With longer strips, fewer rows are computed twice, but there must
/// be enough strips for the device: several per CPU thread on a software driver, thousands on a GPU.
int stripRowsFor(const WorkSplit& cut, int columns, int rows) {
  const bool texel = gl::memoryPath() == gl::MemoryPath::texel;
  const int wanted = texel ? 64 : 4000, minimum = texel ? 8 : 16;
  const int across = (columns - 1) / stripWidth(cut) + 1;
  int down = texel ? 64 : 128;
  while (down > minimum && across * ((rows - 1) / down + 1) < wanted) down /= 2;
  return down;
}

/// Packs the links in the format of glsl/reaction/bindings.glsl.
std::vector<glm::uvec4> linkWords(const RuleLinks& links) {
  std::vector<glm::uvec4> words;
  for (const glm::ivec2& range : links.ranges) words.emplace_back(range.x, range.y, 0, 0);
  for (std::size_t s = 0; s < links.weights.size(); ++s) {
    words.emplace_back(links.neighbours[s]);
    const glm::vec4& weight = links.weights[s];
    words.emplace_back(std::bit_cast<std::uint32_t>(weight.x), std::bit_cast<std::uint32_t>(weight.y),
                       std::bit_cast<std::uint32_t>(weight.z), std::bit_cast<std::uint32_t>(weight.w));
  }
  return words;
}

/// Warns of unstable steps, unless the plan has already warned of the diffusion.
void warnOfGrowth(const std::string& object, const ReactionPlan& plan, const RulePlanes& first) {
  if (plan.diffusesTooFast()) return;
  if (const std::optional<StepGrowth> growth = unstableSteps(plan, first))
    warn(
        "reaction \"{}\": a step makes small waves in the first state {:.3g} times as high, but the "
        "equations make them only {:.3g} times as high; lower dt to {:.2g}, or take another \"method\"",
        object, growth->step, growth->equations, growth->dt);
}

}  // namespace

WorkSplit ReactionKernels::bestCut() {
  WorkSplit cut;
  const bool texel = gl::memoryPath() == gl::MemoryPath::texel;
  cut.rows = texel ? 2 : 1;
  // If an invocation processes several rows, consecutive rows use the same loads of the rows above and
  // below, each in three layers.
  cut.volumeRows = texel ? 16 : 1;
  cut.stepsPerPass = texel ? 4 : 2;
  cut.stripElements = texel ? 6 : 1;
  // Maximum number of species for strips. The result has the same bits with and without strips. A software
  // driver takes 7 s to compile strips of 3 species and 50 s for 8; a GPU runs out of registers at 8.
  cut.stripSpecies = texel ? 4 : 6;
  // Number of cell updates after which strips are compiled. A software driver needs seconds to compile them
  // and then saves about 3 ns per cell update.
  cut.stripsAfter = texel ? 5e8 : 0;
  return cut;
}

ReactionKernels::ReactionKernels(const std::string& name, const ReactionPlan& plan, bool fast,
                                 const WorkSplit& cut)
    : plan_(plan),
      size_(plan.parameters().size),
      depth_(plan.parameters().depth),
      layerItems_((size_.y - 1) / (depth_ > 1 ? cut.volumeRows : cut.rows) + 1),
      columns_((size_.x + 3) / 4),
      cut_(cut) {
  const RuleProgram& program = plan.program();
  checkRuleLimits(
      name, plan.parameters(),
      std::max({static_cast<std::int64_t>(plan.parameters().species.size()), std::int64_t{program.lets},
                static_cast<std::int64_t>(plan.parameters().parameters.size()) +
                    (plan.links() != nullptr ? bindMaps : 0)}));
  if (plan.links() != nullptr) links_ = gl::WordsArray(name + " links", linkWords(*plan.links()));
  const RuleField field = plan.firstField();
  warnOfGrowth(name, plan, field.stage);
  const std::vector<glm::vec4> first = packed(field.stage);
  cells_[0] = gl::Vec4Array(name + " cells", first);
  cells_[1] = gl::Vec4Array(name + " next cells", first);
  for (int i = 0; i < 2; ++i)
    words_[i] = gl::Texture::view(name + " words", GL_RGBA32UI, cells_[i].buffer());
  const auto elements = static_cast<int>(first.size());
  if (program.stages.size() > 1) {
    stages_[0] = gl::Vec4Array(name + " stage", elements);
    stages_[1] = gl::Vec4Array(name + " other stage", elements);
    sums_ = gl::Vec4Array(name + " sums", elements);
  }
  if (program.lets > 0) {
    lets_ = gl::Vec4Array(name + " lets", columns_ * size_.y * depth_ * program.lets);
    letWords_ = gl::Texture::view(name + " let words", GL_RGBA32UI, lets_.buffer());
  }
  if (!field.weights.empty()) weights_ = gl::Vec4Array(name + " maps", packed(field.weights));
  constexpr unsigned fine[] = {0xffffffffU, 0xffffffffU, 0, 0};
  status_ = gl::Buffer::of<unsigned>(name + " status", fine);

  gl::Defines defines = gl::kernelDefines(fast);
  const RuleSpace space = plan.parameters().space();
  makeInputs(name, defines);
  if (space == RuleSpace::volume) defines.emplace_back("VOLUME", "1");
  if (space == RuleSpace::mesh) defines.emplace_back("MESH", "1");
  defines.emplace_back("BOUNDARY", std::to_string(static_cast<int>(plan.parameters().boundary)));
  defines.emplace_back("TAIL", std::to_string((size_.x - 1) % 4));
  for (const RulePass& pass : program.passes)
    passes_.push_back(
        {gl::Kernel<RuleKernel>::generated(
             kernelText(plan.rule(), pass, space, plan.parameters().boundary, plan.noiseSeed(), cut_),
             defines),
         gl::Buffer(name + " uniforms", uniformVectors(pass) * sizeof(glm::vec4)),
         {}});
  mayStrip_ = cut_.stepsPerPass > 1 && static_cast<int>(plan.rule().rates.size()) <= cut_.stripSpecies &&
              stripsCan(plan.rule(), program, space, plan.parameters().boundary, size_.x);
  name_ = name;
  stripDefines_ = std::move(defines);
}

void ReactionKernels::makeStrips() {
  gl::Defines defines = stripDefines_;
  if (cut_.stripRows == 0) cut_.stripRows = stripRowsFor(cut_, columns_, size_.y);
  lost_ = gl::Kernel<LostKernel>(defines);
  if (gl::limits().shuffle32) defines.emplace_back("SUBGROUPS", "1");
  const RulePass& pass =
      plan_.program().passes[static_cast<std::size_t>(plan_.program().stages[0].passes[0])];
  strips_ = gl::Kernel<StripKernel>::generated(stripText(plan_.rule(), pass, cut_), defines);
  const std::vector<unsigned> none(lostSteps, 0xffffffffU);
  lostCells_ = gl::Buffer::of<unsigned>(name_ + " lost cells", none);
}

ReactionKernels::Pass& ReactionKernels::firstPass() {
  return passes_[static_cast<std::size_t>(plan_.program().stages[0].passes[0])];
}

std::vector<glm::vec4> ReactionKernels::packed(const RulePlanes& planes) const {
  std::vector<glm::vec4> elements;
  const auto width = static_cast<std::size_t>(size_.x);
  for (const std::vector<float>& plane : planes)
    for (std::size_t y = 0; y < plane.size() / width; ++y)
      for (std::size_t x = 0; x < width; x += 4) {
        glm::vec4& element = elements.emplace_back(0.0F);
        for (std::size_t i = 0; i < 4 && x + i < width; ++i)
          element[static_cast<int>(i)] = plane[y * width + x + i];
      }
  return elements;
}

void ReactionKernels::setValues(const std::vector<float>& values) {
  values_ = values;
  for (std::size_t i = 0; i < passes_.size(); ++i)
    if (!plan_.program().passes[i].usesTime) tell(static_cast<int>(i));
}

// Uploads the uniform block of a pass: the uniform values, then the rounding grains of stored numbers and
// of flushed numbers, then the values beyond edges of the kind "fixed".
void ReactionKernels::tell(int pass) {
  Pass& to = passes_[static_cast<std::size_t>(pass)];
  std::vector<float> uniforms =
      ruleUniformsOf(plan_.rule().graph, plan_.program().passes[static_cast<std::size_t>(pass)], values_);
  uniforms.resize((uniforms.size() + 4) / 4 * 4);
  uniforms.insert(uniforms.end(), {storedGrain, flushedGrain, 0, 0});
  const std::vector<float> edges = plan_.edges();
  uniforms.insert(uniforms.end(), edges.begin(), edges.end());
  if (uniforms == to.written) return;
  to.written = uniforms;
  to.uniforms.write(0, std::as_bytes(std::span(uniforms)));
}

void ReactionKernels::run(int pass, const gl::Vec4Array& stage, const gl::Vec4Array& next, long number) {
  const RulePass& what = plan_.program().passes[static_cast<std::size_t>(pass)];
  const Pass& given = passes_[static_cast<std::size_t>(pass)];
  if (what.usesTime) tell(pass);
  const bool toLets = what.outputs.front().plane.array == RuleArray::lets;
  given.kernel.dispatch({columns_, layerItems_ * depth_}, {.size = size_,
                                                           .columns = columns_,
                                                           .stepNumber = static_cast<int>(number),
                                                           .depth = depth_,
                                                           .planeRows = size_.y * depth_,
                                                           .layerItems = layerItems_,
                                                           .uniforms = given.uniforms,
                                                           .status = status_,
                                                           .stage = stage,
                                                           .base = cells_[0],
                                                           .sum = sums_,
                                                           .lets = lets_,
                                                           .maps = weights_,
                                                           .links = links_,
                                                           .next = toLets ? lets_ : next});
}

void ReactionKernels::advance(long number, int steps, long first) {
  if (mayStrip_ && !strips_ && cellSteps_ >= cut_.stripsAfter) makeStrips();
  cellSteps_ += static_cast<double>(steps) * size_.x * size_.y;
  const int together = strips_ ? cut_.stepsPerPass : steps + 1;
  for (int begun = 0; steps >= together; steps -= together, number += together) {
    strips(number, number - begun);
    begun += together;
    if (begun + together <= lostSteps && steps >= 2 * together) continue;
    tellLost(number + together - begun, begun);
    begun = 0;
  }
  for (int i = 0; i < steps; ++i) step(number + i, first);
}

void ReactionKernels::strips(long number, long lostFirst) {
  const int lanes = gl::memoryPath() == gl::MemoryPath::texel ? 1 : 32;
  const int across = (columns_ - 1) / stripWidth(cut_) + 1;
  strips_.dispatch({across * lanes, (size_.y - 1) / cut_.stripRows + 1},
                   {.size = size_,
                    .columns = columns_,
                    .stepNumber = static_cast<int>(number),
                    .lostFirst = static_cast<int>(lostFirst),
                    .uniforms = firstPass().uniforms,
                    .status = status_,
                    .stage = cells_[0],
                    .next = cells_[1],
                    .lost = lostCells_});
  std::swap(cells_[0], cells_[1]);
  std::swap(words_[0], words_[1]);
}

void ReactionKernels::tellLost(long first, int steps) {
  lost_.dispatch(1, {static_cast<int>(first), steps, status_, lostCells_});
}

void ReactionKernels::step(long number, long first) {
  const RuleProgram& program = plan_.program();
  const gl::Vec4Array* from = &cells_[0];
  for (std::size_t i = 0; i < program.stages.size(); ++i) {
    const RuleProgram::Stage& stage = program.stages[i];
    const gl::Vec4Array* to = stage.last ? &cells_[1] : &stages_[i % 2];
    values_[UniformIndex::time] = plan_.modelTime(number, first, stage.time);
    for (const int pass : stage.passes) run(pass, *from, *to, number);
    from = to;
  }
  std::swap(cells_[0], cells_[1]);
  std::swap(words_[0], words_[1]);
}

void ReactionKernels::prepareDrawing(long number, long first) {
  values_[UniformIndex::time] = plan_.modelTime(number, first, 0);
  for (const int pass : plan_.program().showing) run(pass, cells_[0], cells_[1], 0);
  gl::barrier();
}

}  // namespace simreel::sim
