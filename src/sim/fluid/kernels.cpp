#include "sim/fluid/kernels.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"
#include "sim/fluid/brush_boxes.hpp"
#include "sim/fluid/quantities.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::shader::fluid {
#include "glsl/fluid/bindings.glsl"
}

namespace simreel::sim {

namespace {

namespace at = shader::fluid;

/// Before anything is filled.
void checkLimits(const std::string& name, glm::ivec2 size) {
  const std::int64_t elements = (std::int64_t{size.x} + 2) * (size.y + 2);
  const auto refuse = [&](std::int64_t need, const char* what, std::int64_t max, const char* limit) {
    if (need > max)
      fail(ExitCode::device,
           "fluid \"{}\" of {}x{} cells needs {} {} in one buffer, this device allows {} ({}); make it "
           "smaller",
           name, size.x, size.y, need, what, max, limit);
  };
  refuse(elements * 16, "bytes", gl::limits().storageBlockBytes, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE");
  refuse(elements, "texels", gl::limits().texelBufferTexels, "GL_MAX_TEXTURE_BUFFER_SIZE");
}

gl::Defines definesOf(const FluidParameters& p, bool fast) {
  gl::Defines defines = gl::kernelDefines(fast);
  const auto define = [&](const char* key, int value) { defines.emplace_back(key, std::to_string(value)); };
  define("LEFT", static_cast<int>(p.left.kind));
  define("RIGHT", static_cast<int>(p.right.kind));
  define("TOP", static_cast<int>(p.top.kind));
  define("BOTTOM", static_cast<int>(p.bottom.kind));
  define("HEATS", p.heats() ? 1 : 0);
  define("VISCOUS", p.viscous() ? 1 : 0);
  define("CONFINES", p.confines() ? 1 : 0);
  define("SINKS", p.sinks() ? 1 : 0);
  define("ADVECTION", static_cast<int>(p.advection));
  define("OBSTACLES", p.obstacles.empty() ? 0 : 1);
  define("OBSTACLES_MOVE", p.obstaclesMove() ? 1 : 0);
  define("POCKETS_GROW", p.pocketsGrow() ? 1 : 0);
  define("OBSTACLES_SLIP", p.obstaclesSlip ? 1 : 0);
  define("SHOWN", static_cast<int>(p.show));
  define("LOOK", static_cast<int>(p.look));
  return defines;
}

std::vector<glm::uvec4> stampElements(const std::vector<std::uint32_t>& words) {
  std::vector<glm::uvec4> elements;
  for (std::size_t i = 0; i + 3 < words.size(); i += 4)
    elements.emplace_back(words[i], words[i + 1], words[i + 2], words[i + 3]);
  return elements;
}

std::vector<glm::vec4> stopElements(const std::vector<glm::vec3>& colors) {
  std::vector<glm::vec4> elements;
  elements.reserve(colors.size());
  for (const glm::vec3& color : colors) elements.emplace_back(color, 0.0F);
  return elements;
}

/// As `name` is checked before the arrays are made.
const std::string& checked(const std::string& name, const FluidPlan& plan) {
  checkLimits(name, plan.size());
  return name;
}

}  // namespace

FluidKernels::FluidKernels(const std::string& name, const FluidPlan& plan, bool fast, double startTime)
    : plan_(plan),
      pressure_(checked(name, plan), plan, definesOf(plan.parameters(), fast)),
      arrays_(name, plan, plan.firstFlow(startTime)) {
  const FluidParameters& p = plan.parameters();
  stops_ = gl::Vec4Array(name + " colours", stopElements(p.display.colors()));
  constexpr unsigned fine[] = {0xffffffffU, 0xffffffffU, 0, 0};
  status_ = gl::Buffer::of<unsigned>(name + " status", fine);
  brushes_ = gl::Buffer(name + " brushes", sizeof(shader::FluidBrush) * shader::maxBrushes);
  steps_ = StepBlocks<shader::FluidStep>(name + " steps", plan.substeps());
  const gl::Defines defines = definesOf(p, fast);
  const auto compiled = [&](const char* path, const gl::Defines& with) {
    gl::Program program = gl::Program::compute(path, with);
    program.set("size", plan.size());
    program.set("solidsStart", plan.levels().elements());
    return program;
  };
  const auto make = [&](gl::Program& program, const char* path) { program = compiled(path, defines); };
  const auto makeTiled = [&](Tiled& tiled, const char* ofOpen, const char* ofOthers) {
    gl::Defines open = defines, others = defines;
    open.emplace_back("IN_THE_OPEN", "1");
    others.emplace_back("IN_THE_OPEN", "0");
    tiled = {compiled(ofOpen, open), compiled(ofOthers, others)};
  };
  make(push_, "fluid/push.comp");
  make(carry_, "fluid/carry.comp");
  make(correct_, "fluid/correct.comp");
  correct_.checkUniformBlock("FluidBlock", sizeof(shader::FluidStep));
  make(fastest_, "fluid/fastest.comp");
  if (gl::memoryPath() == gl::MemoryPath::texel) {
    makeTiled(project_, "fluid/project.comp", "fluid/project.comp");
    for (const gl::Program* program : {&project_.open, &project_.others})
      program->set("lostSpeed", lostFluidSpeed * p.speed);
    makeTiled(moveDye_, "fluid/dye/pass.comp", "fluid/dye/pass.comp");
  } else {
    constexpr float all[] = {1, 0, 0, 0};
    kept_ = gl::Buffer::of<float>(name + " kept pressure", all);
    makeTiled(project_, "fluid/project_open.comp", "fluid/project.comp");
    make(settle_, "fluid/settle.comp");
    for (const gl::Program* program : {&project_.others, &settle_})
      program->set("heatStart", arrays_.planeBesideSums());
    gl::Defines checks = defines;
    if (plan.dyePasses() > 0) checks.emplace_back("WAYS", "1");
    check_ = compiled("fluid/check.comp", checks);
    check_.set("lostSpeed", lostFluidSpeed * p.speed);
    for (int i = 0; i < 2; ++i) {
      gl::Defines strips = defines;
      strips.emplace_back("PASSES", std::to_string(i + 1));
      if (gl::limits().shuffle32) strips.emplace_back("SUBGROUPS", "1");
      dyeStrips_[i] = compiled("fluid/dye/strips.comp", strips);
    }
  }
  const bool lines = p.show == FluidParameters::Show::lines;
  make(show_, lines ? "fluid/look/lines.comp" : "fluid/look/show.comp");
  show_.set("stopCount", static_cast<int>(p.display.colors().size()));
  show_.set("low", static_cast<float>(p.display.low));
  show_.set("perRange", static_cast<float>(1 / (p.display.high - p.display.low)));
  show_.set("obstacleColor", p.obstacleColor);
  tally_ = Tally(name, "fluid/tally.comp", defines);
  tally_.kernel().set("size", plan.size());
  tally_.kernel().set("solidsStart", plan.levels().elements());
  if (lines) {
    const int detail = p.lineDetail;
    lines_ = gl::Vec4Array(name + " lines", p.size.x * p.size.y * detail * detail);
    lineWords_ = gl::Texture::view(name + " lines", GL_RGBA32UI, lines_.buffer());
    show_.set("lineDetail", detail);
    show_.set("linePerDetail", 1.0F / static_cast<float>(detail));
  } else {
    show_.set("brightness", p.brightness);
    show_.set("paper", p.paper);
  }
  if (plan.strokes().empty()) return;
  stamps_ = gl::WordsArray(name + " brush images", stampElements(plan.strokes().imageBits()));
  make(paint_, "fluid/paint.comp");
  paint_.checkUniformBlock("BrushBlock", brushes_.bytes());
  make(paintBack_, "fluid/paint_back.comp");
}

void FluidKernels::beginFrame(double time) {
  std::vector<shader::FluidStep> steps;
  for (int i = 1; i <= plan_.substeps(); ++i) steps.push_back(plan_.stepAt(time, i));
  steps_.upload(steps);
}

void FluidKernels::place(double time, int step) {
  auto solids = plan_.solidsAt(time, step);
  if (solids == solids_) return;
  solids_ = std::move(solids);
  pressure_.setSolids(*solids_);
  const FluidCells cells = openCells(plan_.size(), solids_->solid());
  const auto per = [](long count) {
    return static_cast<float>(1.0 / static_cast<double>(std::max(count, 1L)));
  };
  perCells_ = {per(cells.open), per(cells.corners), 1, per(cells.open)};
}

/// Over the grid and the ring around it.
void FluidKernels::run(const gl::Program& program) const {
  pressure_.bindSolids();
  gl::barrier();
  program.dispatch(plan_.size().x + 2, plan_.size().y + 2);
}

void FluidKernels::runTiles(const gl::Program& program, int start, int count) const {
  constexpr int side = 8, row = FluidLevel::groupRow;
  program.set("tilesStart", start);
  program.dispatch(std::min(count, row) * side, (count + row - 1) / row * side);
}

/// Over tiles that do not lie in the open, and the ring around the grid.
void FluidKernels::runOthers(const gl::Program& program) const {
  // glsl/fluid/cells.glsl
  const bool four = gl::memoryPath() == gl::MemoryPath::texel;
  const int each = four ? 4 * 64 : 64, tiles = four ? FluidLevel::groupTiles : 1;
  const int list = plan_.levels().levels().front().listElements();
  runTiles(program, solids_->tilesStart() + list,
           solids_->tileGroups().front().y * FluidLevel::groupTiles / tiles);
  const int ring = 2 * (plan_.size().x + plan_.size().y + 2);
  runTiles(program, -1, (ring + each - 1) / each);
}

void FluidKernels::runOpen(const gl::Program& program) const {
  runTiles(program, solids_->tilesStart(), solids_->tileGroups().front().x);
}

/// The long programs for few cells come first: what is in the open fills the device up while they run.
void FluidKernels::run(const Tiled& tiled) const {
  pressure_.bindSolids();
  gl::barrier();
  runOthers(tiled.others);
  runOpen(tiled.open);
}

/// Where brushes reach a small part of the cells only that is painted. It is taken back to the rest, unless
/// it is all there is, and may stay where it is.
void FluidKernels::paint(double time, int step, bool all) {
  const std::vector<shader::FluidBrush> brushes = plan_.brushesAt(time, step).brushes;
  if (brushes.empty()) return;
  brushes_.write(0, std::as_bytes(std::span(brushes)));
  brushes_.bindUniform(at::brushesBinding, 0, brushes_.bytes());
  stamps_.bindInput(at::stampsBinding);
  arrays_.flow().bindInput(at::flowBinding);
  arrays_.dye().bindInput(at::dyeBinding);
  arrays_.scratch().bindState(at::nextFlowBinding);
  arrays_.spare().bindState(at::nextDyeBinding);
  pressure_.bindSolids();
  const std::vector<BrushBox> boxes = brushBoxes(brushes, plan_.parameters(), all);
  const auto run = [&](const gl::Program& program) {
    gl::barrier();
    for (const BrushBox& box : boxes) {  // a cell in two of them is the same each time
      program.set("firstBrush", static_cast<int>(box.first));
      program.set("endBrush", static_cast<int>(box.end));
      program.set("box", box.cells);
      program.dispatch(box.cells.z, box.cells.w);
    }
  };
  run(paint_);
  if (all && arrays_.alike()) {
    arrays_.turnFlow(true);
    arrays_.turnDye();
    return;
  }
  arrays_.scratch().bindInput(at::flowBinding);
  arrays_.spare().bindInput(at::dyeBinding);
  arrays_.flow().bindState(at::nextFlowBinding);
  arrays_.dye().bindState(at::nextDyeBinding);
  run(paintBack_);
}

void FluidKernels::project(unsigned number) {
  pressure_.solve(arrays_.flow(), arrays_.scratch(), arrays_.spare());
  arrays_.flow().bindInput(at::flowBinding);
  arrays_.scratch().bindInput(at::carriedBinding);
  arrays_.spare().bindState(at::nextFlowBinding);
  pressure_.control().bindStorage(at::controlBinding);
  status_.bindStorage(shader::statusBinding);
  if (gl::memoryPath() == gl::MemoryPath::storage)
    projectInPlace(number);
  else {
    for (const gl::Program* program : {&project_.open, &project_.others}) program->set("number", number);
    run(project_);
    arrays_.turnFlow(false);
  }
  pressure_.judge(status_);
}

/// Cells at walls read what is around them, so what they become waits until all of them have; cells in the
/// open look at corrections only.
void FluidKernels::projectInPlace(unsigned number) {
  pressure_.bindSolids();
  kept_.bindStorage(at::keptBinding);
  arrays_.scratch().bindStorage(at::nextDyeBinding);
  gl::barrier();
  runOthers(project_.others);
  gl::barrier();
  runOthers(settle_);
  runOpen(project_.open);
  arrays_.scratch().bindStorage(at::nextFlowBinding);
  check_.set("number", number);
  gl::barrier();
  check_.dispatch(plan_.size().x + 2, (plan_.size().y + 5) / 4);  // four rows an invocation
}

void FluidKernels::moveDye() {
  const bool strips = gl::memoryPath() == gl::MemoryPath::storage;
  arrays_.flow().bindInput(at::flowBinding);
  if (strips) arrays_.scratch().bindInput(at::carriedBinding);  // ways, of check_
  for (int left = plan_.dyePasses(); left > 0;) {
    const int passes = strips ? std::min(left, 2) : 1;
    arrays_.dye().bindInput(at::dyeBinding);
    arrays_.spare().bindState(at::nextDyeBinding);
    if (strips)
      moveDye(passes);
    else
      run(moveDye_);
    arrays_.turnDye();
    left -= passes;
  }
}

void FluidKernels::moveDye(int passes) const {
  gl::barrier();
  const gl::Program& program = dyeStrips_[passes - 1];
  const glm::ivec2 size = plan_.size();
  constexpr int lanes = 32;
  const int columns = 2 * lanes - 4 * passes;
  // About 9500 groups: long strips of much dye are what the others wait for, short ones take more rows
  // twice.
  const int rows = std::clamp(static_cast<int>(std::int64_t{size.x} * size.y / 524288), 4, 1024);
  program.set("rows", rows);
  program.dispatch(((size.x - 1) / columns + 1) * lanes, (size.y - 1) / rows + 1);
}

void FluidKernels::start(double time) {
  place(time, 0);
  steps_.upload(std::vector<shader::FluidStep>{plan_.stepAt(time, 0)});
  steps_.bind(0);
  paint(time, 0, true);
  project(0);
  show(time);
}

void FluidKernels::resume(double time) {
  beginFrame(time);
  place(time, 0);
  steps_.bind(0);
  pressure_.resume();
  arrays_.flow().bindInput(at::flowBinding);
  pressure_.control().bindStorage(at::controlBinding);
  run(fastest_);
  gl::barrier();
}

void FluidKernels::advance(double time, int step, unsigned number) {
  place(time, step);
  steps_.bind(static_cast<std::size_t>(step) - 1);
  arrays_.flow().bindInput(at::flowBinding);
  arrays_.scratch().bindState(at::nextFlowBinding);
  pressure_.control().bindStorage(at::controlBinding);
  if (kept_.name() != 0) kept_.bindStorage(at::keptBinding);
  run(push_);
  arrays_.scratch().bindInput(at::flowBinding);
  arrays_.spare().bindState(at::nextFlowBinding);
  run(carry_);
  arrays_.spare().bindInput(at::carriedBinding);
  arrays_.dye().bindInput(at::dyeBinding);
  arrays_.flow().bindState(at::nextFlowBinding);
  run(correct_);
  paint(time, step, false);
  steps_.bind(static_cast<std::size_t>(step) - 1);
  project(number);
  moveDye();
  gl::barrier();
}

void FluidKernels::measure() {
  steps_.bind(0);
  arrays_.flow().bindInput(at::flowBinding);
  arrays_.dye().bindInput(at::dyeBinding);
  pressure_.bindSolids();
  pressure_.control().bindStorage(at::controlBinding);
  tally_.take(perCells_, {1, plan_.stepAt(0, 0).dt, 1, 1});
}

CountTable FluidKernels::counts() const {
  return tally_.table(
      {"kineticEnergy", "enstrophy", "dye", "temperature", "speed", "courant", "divergence", "cycles"});
}

void FluidKernels::show(double time) {
  const bool lines = plan_.parameters().show == FluidParameters::Show::lines;
  steps_.bind(0);
  arrays_.flow().bindInput(at::flowBinding);
  stops_.bindInput(at::carriedBinding);
  arrays_.dye().bindInput(at::dyeBinding);
  pressure_.bindSolids();
  if (lines)
    lines_.bindState(at::nextFlowBinding);
  else
    arrays_.shown().bindState(at::nextFlowBinding);
  gl::barrier();
  if (lines) show_.set("linePhase", plan_.linePhase(time));
  const glm::ivec2 places = plan_.size() * (lines ? plan_.parameters().lineDetail : 1);
  show_.dispatch(places.x, places.y);
  gl::barrier();
}

}  // namespace simreel::sim
