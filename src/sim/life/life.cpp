#include "sim/life/life.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/limits.hpp"
#include "sim/automata/engine/cell_engine.hpp"
#include "sim/core/kind.hpp"
#include "sim/life/active.hpp"
#include "sim/life/life_scene.hpp"
#include "sim/life/plan.hpp"
#include "sim/life/rle.hpp"
#include "sim/life/states.hpp"
#include "sim/life/stepper.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

namespace simreel::sim {

namespace {

constexpr int maxFillGroups = 32768;

std::vector<glm::uvec4> elements(const std::vector<std::uint32_t>& words) {
  std::vector<glm::uvec4> result((words.size() + 3) / 4);
  std::memcpy(result.data(), words.data(), words.size() * 4);
  return result;
}

struct LifeFill {
  static constexpr auto file = "life/fill.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowBlocks", int> rowBlocks;
  gl::Uniform<"seed", int> seed;
  gl::Uniform<"fraction", int> fraction;
  gl::Uniform<"firstBlock", int> firstBlock;
  gl::Out<"cells"> cells;
};

struct LifeTrail {
  static constexpr auto file = "life/trail.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowBlocks", int> rowBlocks;
  gl::Uniform<"rowQuads", int> rowQuads;
  gl::Uniform<"bright", unsigned> bright;
  gl::Uniform<"drop", unsigned> drop;
  gl::In<"cells"> cells;
  gl::InOut<"trails"> trails;
};

struct LifePaint {
  static constexpr auto file = "life/paint.comp";
  gl::Uniform<"rowBlocks", int> rowBlocks;
  StrokeUniforms stroke;
  gl::InOut<"cells"> cells;
  gl::In<"stamps"> stamps;
};

class Life : public Simulation {
 public:
  Life(LifePlan plan, const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(std::move(plan)),
        size_(plan_.parameters().size),
        colors_(plan_.parameters().display.colors()),
        stepper_(plan_.rule(), plan_.torus(), size_, LifeTuning::best(size_)) {
    checkLimits();
    if (!plan_.plain()) engine_.emplace(plan_.rule(), plan_.shape(), size_, true, "life \"" + name_ + "\"");
    const auto blocks = static_cast<int>(plan_.blocks());
    cells_[0] = gl::WordsArray(name_ + " cells", blocks);
    cells_[1] = gl::WordsArray(name_ + " next cells", blocks);
    constexpr unsigned fine[] = {0xffffffffU, 0xffffffffU, 0, 0};
    status_ = gl::Buffer::of<unsigned>(name_ + " status", fine);
    fill();
    if (!plan_.strokes().empty()) {
      paint_ = gl::Kernel<LifePaint>(gl::kernelDefines(false));
      stamps_ = gl::WordsArray(name_ + " stamps", elements(plan_.strokes().imageBits()));
    }
    paint(plan_.strokesInto(plan_.generationAt(plan_.frameAt(setting.startTime))));
    if (plan_.parameters().trail > 0) startTrail();
    gl::barrier();
  }

  void step(double time, const StepWatch& watch) override {
    const long frame = plan_.frameAt(time);
    if (!started_) firstGeneration_ = generation_ = plan_.generationAt(frame);
    started_ = true;
    const long end = plan_.generationAt(frame + 1);
    int done = 0;
    if (!watch) runActive(end);
    while (generation_ < end) {
      const int steps = watch ? 1 : stepsAtOnce(end);
      if (engine_)
        engine_->run(cells_[0], cells_[1]);
      else
        stepper_.run(cells_[0], cells_[1], steps);
      std::swap(cells_[0], cells_[1]);
      generation_ += steps;
      paint(plan_.strokesInto(generation_));
      if (trailQuads_ > 0) fadeTrail();
      if (watch) watch(++done);
    }
    gl::barrier();
    // Some frames have fewer generations than others. `watch` is therefore also called for each generation
    // that this frame lacks.
    if (watch)
      while (done < stepsPerFrame()) watch(++done);
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.stepsPerFrame(); }

  [[nodiscard]] std::string elementName(long element) const override {
    const long x = element % plan_.rowBlocks() * 128;
    return fmt::format("cells ({} to {}, {})", x, std::min<long>(x + 127, size_.x - 1),
                       element / plan_.rowBlocks());
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    const FieldDisplay& display = plan_.parameters().display;
    Field field;
    field.name = &name_;
    field.size = size_;
    const bool trail = trailQuads_ > 0;
    field.words = trail ? &trail_.view() : &cells_[0].view();
    field.cells = trail ? Field::Cells::bytes : Field::Cells::bits;
    field.rowWords = 4 * (trail ? trailQuads_ : plan_.rowBlocks());
    field.range = {static_cast<float>(display.low), static_cast<float>(display.high)};
    field.colors = &colors_;
    field.display = &display;
    drawables.fields.push_back(field);
  }

  void visitCheckpointData(CarryOver& carry) override {
    carry.number("started", started_);
    carry.number("generation", generation_);
    carry.number("first generation", firstGeneration_);
    carry.array("cells", cells_[0].buffer());
    if (trailQuads_ > 0) carry.array("trail", trail_.buffer());
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays = {{"cells", &cells_[0].buffer(), true}};
    if (trailQuads_ > 0) arrays.push_back({"trail", &trail_.buffer(), true});
    return arrays;
  }

  [[nodiscard]] const gl::Buffer* status() const override {
    return LifeActive::suits(size_) ? &status_ : nullptr;
  }
  [[nodiscard]] std::string explainLoss(unsigned /*step*/, unsigned /*element*/) const override {
    return fmt::format(
        "life \"{}\": the driver ended a loop too early, so cells are wrong; other drivers, or "
        "--memory-path "
        "storage, do not",
        name_);
  }

  [[nodiscard]] StateFile stateFile() const override {
    return {"rle", [this](const std::string& comment) {
              const auto words = cells_[0].buffer().readAll<std::uint32_t>();
              return writeRle({size_, words}, plan_.rule(), plan_.shape().suffix(size_), comment);
            }};
  }

  [[nodiscard]] std::vector<double> measure() const override {
    long alive = 0;
    for (const std::uint32_t word : cells_[0].buffer().readAll<std::uint32_t>())
      alive += std::popcount(word);
    const auto population = static_cast<double>(alive);
    return {population, population / (static_cast<double>(size_.x) * size_.y),
            static_cast<double>(generation_ - firstGeneration_)};
  }

 private:
  /// Throws UserError(device) if a buffer would exceed the device's limit; called before gigabytes are
  /// allocated.
  void checkLimits() const {
    const long blocks = plan_.blocks();
    const long trail = plan_.parameters().trail > 0 ? (size_.x + 15L) / 16 * size_.y : 0;
    const long max = std::min<long>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels);
    if (std::max(blocks, trail) > max)
      fail(ExitCode::device,
           "life \"{}\" of {} x {} cells{} needs {} bytes in one buffer, this device allows {} "
           "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, GL_MAX_TEXTURE_BUFFER_SIZE); make \"size\" smaller",
           name_, size_.x, size_.y, trail > blocks ? " with a trail" : "", std::max(blocks, trail) * 16,
           max * 16);
  }

  void fill() {
    if (plan_.fillFraction() > 0) {
      const gl::Kernel<LifeFill> kernel(gl::kernelDefines(false));
      const auto blocks = static_cast<int>(plan_.blocks());
      for (int first = 0; first < blocks; first += maxFillGroups * 64)
        kernel.dispatch(std::min(blocks - first, maxFillGroups * 64), {.size = size_,
                                                                       .rowBlocks = plan_.rowBlocks(),
                                                                       .seed = plan_.seed(),
                                                                       .fraction = plan_.fillFraction(),
                                                                       .firstBlock = first,
                                                                       .cells = cells_[0]});
      gl::barrier();
    }
    if (!plan_.hasPatterns()) return;
    auto words = cells_[0].buffer().readAll<std::uint32_t>();
    plan_.addPatterns(words);
    cells_[0] = gl::WordsArray(name_ + " cells", elements(words));
  }

  void startTrail() {
    trailQuads_ = (size_.x + 15) / 16;
    trail_ = gl::WordsArray(name_ + " trail", trailQuads_ * size_.y);
    fade_ = gl::Kernel<LifeTrail>(gl::kernelDefines(false));
    fadeTrail();
  }

  void fadeTrail() {
    const LifeParameters& p = plan_.parameters();
    fade_.dispatch({trailQuads_, size_.y}, {.size = size_,
                                            .rowBlocks = plan_.rowBlocks(),
                                            .rowQuads = trailQuads_,
                                            .bright = static_cast<unsigned>(p.brightLevel()),
                                            .drop = static_cast<unsigned>(p.brightLevel() - p.trail),
                                            .cells = cells_[0],
                                            .trails = trail_});
  }

  /// Computes most of the generations up to `end` with LifeActive. Does so only if many generations are due
  /// and none before the last one is displayed or painted into.
  void runActive(long end) {
    if (engine_ || end - generation_ < LifeActive::minGenerations || !LifeActive::suits(size_) ||
        trailQuads_ > 0 || !plan_.strokes().empty())
      return;
    if (!active_) active_.emplace(plan_.rule(), plan_.torus(), size_);
    const auto passes = static_cast<int>((end - generation_) / LifeActive::steps);
    gl::barrier();
    active_->run(cells_[0], passes, status_);
    generation_ += long{passes} * LifeActive::steps;
  }

  /// Returns the number of generations for the next pass, which ends at `end` or earlier: 1 if the engine
  /// is used, if a trail needs every generation, or if strokes paint into a generation before the last.
  [[nodiscard]] int stepsAtOnce(long end) const {
    const int max = stepper_.stepsOf(end - generation_);
    if (engine_ || trailQuads_ > 0) return 1;
    for (int i = 1; i < max; ++i)
      if (!plan_.strokesInto(generation_ + i).empty()) return 1;
    return max;
  }

  void paint(const std::vector<shader::Stroke>& strokes) {
    for (const shader::Stroke& stroke : strokes) {
      const glm::ivec4 box = Strokes::box(stroke, size_);
      if (box.z == 0) continue;
      paint_.dispatch({(box.x + box.z - 1) / 128 - box.x / 128 + 1, box.w},
                      {.rowBlocks = plan_.rowBlocks(),
                       .stroke = uniformsOf(stroke, box),
                       .cells = cells_[0],
                       .stamps = stamps_});
    }
  }

  std::string name_;
  LifePlan plan_;
  glm::ivec2 size_;
  std::vector<glm::vec3> colors_;
  LifeStepper stepper_;
  std::optional<LifeActive> active_;
  std::optional<CellEngine> engine_;  ///< engine for rules and borders that LifeStepper and LifeActive do
                                      ///< not support
  gl::Buffer status_;                 ///< status buffer that active_ writes
  gl::WordsArray cells_[2];           ///< current cells, and the output of the next pass
  gl::WordsArray trail_, stamps_;
  gl::Kernel<LifePaint> paint_;
  gl::Kernel<LifeTrail> fade_;
  int trailQuads_ = 0;  ///< number of 16-byte elements per row of the trail; 0 if there is no trail
  bool started_ = false;
  long generation_ = 0, firstGeneration_ = 0;
};

}  // namespace

SimulationKind lifeKind() {
  const auto planOf = [](const scene::Object& object, const Setting& setting) {
    return LifePlan(parametersOf<LifeParameters>(object), object.name, setting.seed, setting.frameSeconds);
  };
  SimulationKind life = kindOf<LifeParameters>(
      "life",
      "A cellular automaton: Conway's Game of Life, or any rule of neighbours, of two states or more.",
      [planOf](const scene::Object& object, const Setting& setting) {
        static_cast<void>(planOf(object, setting));
      },
      [planOf](const scene::Object& object, const Setting& setting) -> std::unique_ptr<Simulation> {
        LifePlan plan = planOf(object, setting);
        if (plan.rule().states > 2) return makeLifeStates(std::move(plan), object.name, setting);
        return std::make_unique<Life>(std::move(plan), object, setting);
      });
  life.kind.sceneAround = sceneAroundPattern;
  life.kind.appendix = [] {
    std::string text =
        "Rules:\n"
        "  B3/S23, 23/3              neighbours for birth and survival, of eight\n"
        "  B2-a/S12                  with letters of how they lie (Hensel)\n"
        "  B2/S013V, B2/S34H         of four (von Neumann), of six (hexagonal)\n"
        "  MAP...                    every neighbourhood, in base64 as Golly has it\n"
        "  345/2/4, B2/S345/C4       Generations: states at the end; also with letters, V, H, MAP\n"
        "  W110                      Wolfram's of a row (even ones): each row from the one above\n"
        "  R5,C0,M1,S34..58,B34..45,NM  Larger than Life; NN von Neumann, NC circular, N2 Euclidean,\n"
        "                            N+ cross, NX saltire, N* star, N# hash, NB and ND checkerboards,\n"
        "                            NH hexagonal, NA asterisk, N3 tripod, NL triangular, NG Gaussian\n"
        "  R2,C0,S2-3,8,B3,NN        the same with lists of counts, without the middle\n"
        "  R2,C0,S2-4,B3-4,N@891891  a bit a cell, in base 16; ...NW0121...: a digit or two, its weight\n"
        "  R1/T3/C3/NM               cyclic: range, threshold, states, neighbourhood (NM, NN)\n"
        "Rules by name:\n";
    for (const RulePreset& preset : rulePresets())
      text += fmt::format("  {:<15} {:<34} {}\n", preset.name, preset.rule, preset.doc);
    return text;
  };
  return life;
}

}  // namespace simreel::sim
