#include "sim/fluid/kernels.hpp"

#include "base/error.hpp"
#include "gl/access_together.hpp"
#include "gl/limits.hpp"
#include "sim/fluid/brush_boxes.hpp"
#include "sim/fluid/interfaces.hpp"
#include "sim/fluid/quantities.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

/// Checks the device limits, before any array is allocated or filled.
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

std::vector<glm::vec4> stopElements(const std::vector<glm::vec3>& colors) {
  std::vector<glm::vec4> elements;
  elements.reserve(colors.size());
  for (const glm::vec3& color : colors) elements.emplace_back(color, 0.0F);
  return elements;
}

/// Returns the number of invocations per axis for `groups` workgroups that process tiles.
glm::ivec2 tileItems(int groups) {
  constexpr int side = 8, row = FluidLevel::groupRow;
  return {std::min(groups, row) * side, (groups + row - 1) / row * side};
}

/// Checks the limits and returns `name`, so that the check precedes the allocation of arrays in an
/// initializer list.
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
  push_ = gl::Kernel<FluidPush>(defines);
  carry_ = gl::Kernel<FluidCarry>(defines);
  correct_ = gl::Kernel<FluidCorrect>(defines);
  fastest_ = gl::Kernel<FluidFastest>(defines);
  project_.others = gl::Kernel<FluidProject>(defines, {.open = false});
  if (gl::memoryPath() == gl::MemoryPath::texel) {
    project_.open = gl::Kernel<FluidProject>(defines, {.open = true});
    moveDye_ = {gl::Kernel<FluidDyePass>(defines, {.open = true}),
                gl::Kernel<FluidDyePass>(defines, {.open = false})};
  } else {
    constexpr float all[] = {1, 0, 0, 0};
    kept_ = gl::Buffer::of<float>(name + " kept pressure", all);
    projectOpen_ = gl::Kernel<FluidProjectOpen>(defines);
    settle_ = gl::Kernel<FluidSettle>(defines);
    check_ = gl::Kernel<FluidCheck>(defines, {.ways = plan.dyePasses() > 0});
    for (int i = 0; i < 2; ++i)
      dyeStrips_[i] =
          gl::Kernel<FluidDyeStrips>(defines, {.passes = i + 1, .subgroups = gl::limits().shuffle32});
  }
  tally_ = Tally(name, defines);
  sums_ = gl::Kernel<FluidSums>(defines);
  makeShowing(name, defines);
  if (plan.strokes().empty()) return;
  stamps_ = gl::WordsArray(name + " brush images", plan.strokes().imageElements());
  paint_ = gl::Kernel<FluidPaint>(defines);
  paintBack_ = gl::Kernel<FluidPaintBack>(defines);
}

void FluidKernels::makeShowing(const std::string& name, const gl::Defines& defines) {
  const FluidParameters& p = plan_.parameters();
  if (p.show != FluidParameters::Show::lines) {
    display_ = gl::Kernel<FluidDisplay>(defines);
    return;
  }
  displayLines_ = gl::Kernel<FluidLines>(defines);
  lines_ = gl::Vec4Array(name + " lines", p.size.x * p.size.y * p.lineDetail * p.lineDetail);
  lineWords_ = gl::Texture::view(name + " lines", GL_RGBA32UI, lines_.buffer());
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

/// Dispatches a kernel over the tiles that are not fully open, then over the ring around the grid.
template <class Interface>
void FluidKernels::runOthers(const gl::Kernel<Interface>& kernel, Interface given) const {
  // Numbers of cells and tiles per workgroup, as in glsl/fluid/cells.glsl.
  const bool four = gl::memoryPath() == gl::MemoryPath::texel;
  const int each = four ? 4 * 64 : 64, tiles = four ? FluidLevel::groupTiles : 1;
  const int list = plan_.levels().levels().front().listElements();
  given.tilesStart = solids_->tilesStart() + list;
  kernel.dispatch(tileItems(solids_->tileGroups().front().y * FluidLevel::groupTiles / tiles), given);
  const int ring = 2 * (plan_.size().x + plan_.size().y + 2);
  given.tilesStart = -1;
  kernel.dispatch(tileItems((ring + each - 1) / each), given);
}

template <class Interface>
void FluidKernels::runOpen(const gl::Kernel<Interface>& kernel, Interface given) const {
  given.tilesStart = solids_->tilesStart();
  kernel.dispatch(tileItems(solids_->tileGroups().front().x), given);
}

/// Paints the brushes into scratch memory and copies the result back, only for the cells in the brushes'
/// boxes. If all cells were painted and the arrays are interchangeable, the arrays are swapped instead.
void FluidKernels::paint(double time, int step, bool all) {
  const std::vector<shader::FluidBrush> brushes = plan_.brushesAt(time, step).brushes;
  if (brushes.empty()) return;
  brushes_.write(0, std::as_bytes(std::span(brushes)));
  const std::vector<BrushBox> boxes = brushBoxes(brushes, plan_.parameters(), all);
  {
    const gl::AccessTogether together;  // The dispatches need no barrier, because a cell in two boxes gets
                                        // the same value from both.
    for (const BrushBox& box : boxes)
      paint_.dispatch({box.cells.z, box.cells.w}, {.part = part(),
                                                   .firstBrush = static_cast<int>(box.first),
                                                   .endBrush = static_cast<int>(box.end),
                                                   .box = box.cells,
                                                   .brushes = brushes_,
                                                   .stamps = stamps_,
                                                   .flow = arrays_.flow().resource(),
                                                   .dye = arrays_.dye().resource(),
                                                   .nextFlow = arrays_.scratch().resource(),
                                                   .nextDye = arrays_.spare().resource()});
  }
  if (all && arrays_.alike()) {
    arrays_.swapFlow(true);
    arrays_.turnDye();
    return;
  }
  const gl::AccessTogether together;
  for (const BrushBox& box : boxes)
    paintBack_.dispatch({box.cells.z, box.cells.w}, {.part = part(),
                                                     .box = box.cells,
                                                     .flow = arrays_.scratch().resource(),
                                                     .dye = arrays_.spare().resource(),
                                                     .nextFlow = arrays_.flow().resource(),
                                                     .nextDye = arrays_.dye().resource()});
}

FluidProject FluidKernels::projection(unsigned number) const {
  const bool texel = gl::memoryPath() == gl::MemoryPath::texel;
  return {.part = part(),
          .number = number,
          .lostSpeed = lostFluidSpeed * plan_.parameters().speed,
          .heatStart = texel ? 0 : arrays_.planeBesideSums(),
          .flow = arrays_.flow().resource(),
          .pool = arrays_.scratch().resource(),
          .next = arrays_.spare().resource(),
          .kept = kept_,
          .settling = arrays_.spare().resource(),
          .heat = arrays_.scratch().resource(),
          .control = pressure_.control(),
          .status = status_};
}

void FluidKernels::project(unsigned number) {
  pressure_.solve(part(), arrays_.flow(), arrays_.scratch(), arrays_.spare(), status_);
  if (gl::memoryPath() == gl::MemoryPath::storage) {
    projectInPlace(number);
  } else {
    const FluidProject given = projection(number);
    // The kernel for the other tiles takes long but has few cells, so it starts first. The kernel for open
    // tiles keeps the GPU busy meanwhile.
    const gl::AccessTogether together;
    runOthers(project_.others, given);
    runOpen(project_.open, given);
  }
  if (gl::memoryPath() == gl::MemoryPath::texel) arrays_.swapFlow(false);
  pressure_.judge(status_);
}

/// Projects the flow in place. Cells near walls read their neighbours, so their results go to a second
/// array until all of them are computed. Cells in open tiles read only pressure corrections, so they are
/// written directly.
void FluidKernels::projectInPlace(unsigned number) {
  const FluidProject given = projection(number);
  {
    const gl::AccessTogether together;
    runOthers(project_.others, given);
  }
  {
    const gl::AccessTogether together;
    runOthers(settle_, FluidSettle{.part = given.part,
                                   .heatStart = given.heatStart,
                                   .flow = arrays_.flow().resource(),
                                   .settling = arrays_.spare().resource(),
                                   .heat = arrays_.scratch().resource()});
    runOpen(projectOpen_, FluidProjectOpen{.part = given.part,
                                           .flow = arrays_.flow().resource(),
                                           .pool = arrays_.scratch().resource(),
                                           .kept = kept_});
  }
  check_.dispatch(
      {plan_.size().x + 2, (plan_.size().y + 5) / 4},  // An invocation of check_ processes four rows.
      {.part = given.part,
       .number = number,
       .lostSpeed = given.lostSpeed,
       .flow = arrays_.flow().resource(),
       .ways = arrays_.scratch().resource(),
       .control = pressure_.control(),
       .status = status_});
}

void FluidKernels::moveDye() {
  const bool strips = gl::memoryPath() == gl::MemoryPath::storage;
  for (int left = plan_.dyePasses(); left > 0;) {
    const int passes = strips ? std::min(left, 2) : 1;
    if (strips) {
      moveDye(passes);
    } else {
      const FluidDyePass given = {.part = part(),
                                  .flow = arrays_.flow().resource(),
                                  .dye = arrays_.dye().resource(),
                                  .next = arrays_.spare().resource()};
      const gl::AccessTogether together;
      runOthers(moveDye_.others, given);
      runOpen(moveDye_.open, given);
    }
    arrays_.turnDye();
    left -= passes;
  }
}

void FluidKernels::moveDye(int passes) const {
  const glm::ivec2 size = plan_.size();
  constexpr int lanes = 32;
  const int columns = 2 * lanes - 4 * passes;
  // Aims at about 9500 workgroups. With fewer, all have to wait for long strips with much dye; with more,
  // the strips are shorter and overlap more, so that more rows are computed twice.
  const int rows = std::clamp(static_cast<int>(std::int64_t{size.x} * size.y / 524288), 4, 1024);
  dyeStrips_[passes - 1].dispatch(
      {((size.x - 1) / columns + 1) * lanes, (size.y - 1) / rows + 1},
      {.part = part(),
       .rows = rows,
       .flow = arrays_.flow().resource(),
       .ways = arrays_.scratch().resource(),  // Distances by which dye is advected, written by check_.
       .dye = arrays_.dye().resource(),
       .next = arrays_.spare().resource()});
}

void FluidKernels::start(double time) {
  place(time, 0);
  steps_.upload(std::vector<shader::FluidStep>{plan_.stepAt(time, 0)});
  step_ = 0;
  paint(time, 0, true);
  project(0);
  prepareDrawing(time);
}

void FluidKernels::resume(double time) {
  beginFrame(time);
  place(time, 0);
  step_ = 0;
  pressure_.resume();
  fastest_.dispatch(everywhere(), {part(), arrays_.flow().resource(), pressure_.control()});
  gl::barrier();
}

void FluidKernels::advance(double time, int step, unsigned number) {
  place(time, step);
  step_ = static_cast<std::size_t>(step) - 1;
  push_.dispatch(everywhere(), {.part = part(),
                                .flow = arrays_.flow().resource(),
                                .next = arrays_.scratch().resource(),
                                .control = pressure_.control(),
                                .kept = kept_});
  carry_.dispatch(everywhere(), {part(), arrays_.scratch().resource(), arrays_.spare().resource()});
  correct_.dispatch(everywhere(), {.part = part(),
                                   .flow = arrays_.scratch().resource(),
                                   .carried = arrays_.spare().resource(),
                                   .dye = arrays_.dye().resource(),
                                   .next = arrays_.flow().resource(),
                                   .kept = kept_});
  paint(time, step, false);
  project(number);
  moveDye();
  gl::barrier();
}

void FluidKernels::measure() {
  sums_.dispatch(Tally::lanes, {.part = pressure_.part(steps_.at(0)),
                                .flow = arrays_.flow().resource(),
                                .dye = arrays_.dye().resource(),
                                .control = pressure_.control(),
                                .laneSums = tally_.laneSums()});
  tally_.join(perCells_, {1, plan_.stepAt(0, 0).dt, 1, 1});
}

CountTable FluidKernels::counts() const {
  return tally_.table(
      {"kineticEnergy", "enstrophy", "dye", "temperature", "speed", "courant", "divergence", "cycles"});
}

void FluidKernels::prepareDrawing(double time) {
  const FluidParameters& p = plan_.parameters();
  const bool lines = p.show == FluidParameters::Show::lines;
  step_ = 0;
  const FluidDisplayPart given = {.part = part(),
                                  .stopCount = static_cast<int>(p.display.colors().size()),
                                  .low = static_cast<float>(p.display.low),
                                  .perRange = static_cast<float>(1 / (p.display.high - p.display.low)),
                                  .obstacleColor = p.obstacleColor,
                                  .flow = arrays_.flow().resource(),
                                  .stops = stops_,
                                  .shown = lines ? gl::Resource(lines_) : arrays_.shown().resource()};
  if (lines)
    displayLines_.dispatch(plan_.size() * p.lineDetail,
                           {.part = given,
                            .lineDetail = p.lineDetail,
                            .linePerDetail = 1.0F / static_cast<float>(p.lineDetail),
                            .linePhase = plan_.linePhase(time)});
  else
    display_.dispatch(
        plan_.size(),
        {.part = given, .brightness = p.brightness, .paper = p.paper, .dye = arrays_.dye().resource()});
  gl::barrier();
}

}  // namespace simreel::sim
