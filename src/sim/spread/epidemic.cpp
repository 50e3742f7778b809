#include "sim/spread/epidemic.hpp"

#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/core/kind.hpp"
#include "sim/spread/epidemic_plan.hpp"
#include "sim/spread/grid.hpp"

#include <algorithm>
#include <optional>

namespace simreel::sim {

namespace {

struct EpidemicStepKernel {
  static constexpr auto file = "spread/epidemic/step.comp";
  struct Variant {
    gl::Flag<"MIXED"> mixed;
  };
  SpreadStepPart part;
  gl::Block<"StepBlock", decltype(EpidemicPlan::Step::data)> uniforms;
};

struct EpidemicPaintKernel {
  static constexpr auto file = "spread/epidemic/paint.comp";
  SpreadPaintPart part;
  gl::Block<"StepBlock", decltype(EpidemicPlan::Step::data)> uniforms;
};

class Epidemic final : public Simulation {
 public:
  Epidemic(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(checked(object), object.name, setting.seed, setting.frameSeconds),
        palette_(plan_.palette()),
        steps_(name_ + " steps", plan_.stepsPerFrame()) {
    const gl::Defines defines = gl::kernelDefines(setting.fast);
    step_ = gl::Kernel<EpidemicStepKernel>(
        defines, {.mixed = parameters().mixing == EpidemicParameters::Mixing::global});
    paint_ = gl::Kernel<EpidemicPaintKernel>(defines);
    grid_.emplace(name_, parameters(), plan_.firstCells(), plan_.stepsPerFrame(), plan_.strokes());
    const glm::uvec4 start = grid_->latestCounts();
    plan_.setPeople(start.x + start.y + start.z);
    grid_->paintFirst(plan_.firstStrokes(setting.startTime), steps_.at(0), *this);
  }

  void step(double time, const StepWatch& watch) override {
    grid_->runFrame(plan_.frame(time), steps_, plan_.stepsPerFrame(), watch, *this);
  }
  void step(glm::ivec2 items, const SpreadStepPart& part, const gl::Resource& uniforms) const {
    step_.dispatch(items, {.part = part, .uniforms = uniforms});
  }
  void paint(glm::ivec2 items, const SpreadPaintPart& part, const gl::Resource& uniforms) const {
    paint_.dispatch(items, {.part = part, .uniforms = uniforms});
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.stepsPerFrame(); }
  [[nodiscard]] std::string elementName(long element) const override { return grid_->elementName(element); }
  void publish(double /*time*/, Drawables& drawables) const override {
    static const SpreadGrid::ClassNames classes = {
        {0, "empty"}, {64, "susceptible"}, {128, "infected"}, {255, "recovered"}};
    grid_->publishField(name_, palette_, classes, parameters().display, drawables);
    if (!parameters().chart) return;
    const auto vivid = [](const glm::vec3& c) { return c * (0.8F / std::max({c.r, c.g, c.b, 1e-3F})); };
    grid_->publishChart(
        {"susceptible", "infected", "recovered"},
        {vivid(parameters().susceptible), parameters().infection, vivid(parameters().recovered)},
        parameters().chartSeconds * parameters().stepsPerSecond, drawables);
  }
  void visitCheckpointData(CarryOver& carry) override {
    plan_.visitCheckpointData(carry);
    grid_->visitCheckpointData(carry);
  }
  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &grid_->cells().buffer(), true}};
  }
  [[nodiscard]] CountTable counts() const override {
    return {{"susceptible", "infected", "recovered"}, &grid_->frameCounts(), grid_->frameSteps()};
  }
  [[nodiscard]] std::vector<double> measure() const override {
    const glm::dvec4 n(grid_->latestCounts());
    return {n.x, n.y, n.z, n.x + n.y + n.z};
  }

 private:
  [[nodiscard]] const EpidemicParameters& parameters() const { return plan_.parameters(); }
  static const EpidemicParameters& checked(const scene::Object& object) {
    const auto& parameters = parametersOf<EpidemicParameters>(object);
    SpreadGrid::checkLimits(object.name, parameters.size);
    return parameters;
  }

  std::string name_;
  EpidemicPlan plan_;
  std::vector<glm::vec3> palette_;
  StepBlocks<decltype(EpidemicPlan::Step::data)> steps_;
  std::optional<SpreadGrid> grid_;
  gl::Kernel<EpidemicStepKernel> step_;
  gl::Kernel<EpidemicPaintKernel> paint_;
};

/// Returns a plan for validation. If the grid would take gigabytes, it is a small grid made from the same
/// image.
EpidemicPlan validationPlan(const EpidemicParameters& parameters, const EpidemicPlan& plan,
                            const Setting& setting) {
  if (parameters.minLargestBufferBytes() <= ObjectParameters::commonBlockBytes) return plan;
  EpidemicParameters small = parameters;
  small.size = SpreadParameters::validationPlan;
  small.strokes.clear();
  return {small, "", setting.seed, setting.frameSeconds};
}

}  // namespace

SimulationKind epidemicKind() {
  return kindOf<EpidemicParameters>(
      "epidemic", "Susceptible, infected and recovered people on a grid of cells.",
      [](const scene::Object& object, const Setting& setting) {
        const auto& parameters = parametersOf<EpidemicParameters>(object);
        const EpidemicPlan plan(parameters, object.name, setting.seed, setting.frameSeconds);
        static_cast<void>(validationPlan(parameters, plan, setting).firstCells());
      },
      makeSimulation<Epidemic>);
}

}  // namespace simreel::sim
