#include "sim/spread/wildfire.hpp"

#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/core/kind.hpp"
#include "sim/spread/grid.hpp"
#include "sim/spread/wildfire_plan.hpp"

namespace simreel::sim {

namespace {

class Wildfire final : public Simulation {
 public:
  Wildfire(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(checked(object), object.name, setting.seed, setting.frameSeconds),
        palette_(plan_.palette()),
        steps_(name_ + " steps", plan_.stepsPerFrame()),
        grid_(name_, parameters(), plan_.firstCells(), plan_.stepsPerFrame(), "wildfire",
              defines(parameters(), setting.fast), plan_.strokes()),
        fuels_(name_ + " fuel", packedCells(plan_.fuels(), parameters().size)),
        ground_(name_ + " ground", packedCells(plan_.ground(), parameters().size)) {
    steps_.bind(0);
    ground_.bindInput(shader::spread::groundBinding);
    grid_.paintFirst(plan_.firstStrokes(setting.startTime));
    if (!climbs()) return;
    inclines_ = gl::WordsArray(name_ + " inclines", packedCells(plan_.inclines(), parameters().size));
    climbs_ = gl::Vec4Array(name_ + " climb", plan_.climbFactors());
  }

  void step(double time, const StepWatch& watch) override {
    grid_.runFrame(plan_.frame(time), steps_, plan_.stepsPerFrame(), watch, [&] { bindMaps(); });
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.stepsPerFrame(); }
  [[nodiscard]] std::string elementName(long element) const override { return grid_.elementName(element); }
  void publish(double /*time*/, Drawables& drawables) const override {
    grid_.publishField(name_, palette_, parameters().display, drawables);
    if (!parameters().chart) return;
    grid_.publishChart({"unburnt", "burning", "burnt"},
                       {{0.20F, 0.55F, 0.16F}, {1.0F, 0.45F, 0.08F}, {0.45F, 0.40F, 0.38F}},
                       parameters().chartSeconds * parameters().stepsPerSecond, drawables);
  }
  void carryOver(CarryOver& carry) override {
    plan_.carryOver(carry);
    grid_.carryOver(carry);
  }
  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &grid_.cells().buffer(), true}};
  }
  [[nodiscard]] CountTable counts() const override {
    return {{"unburnt", "burning", "burnt", "bare"}, &grid_.frameCounts(), grid_.frameSteps()};
  }
  [[nodiscard]] std::vector<double> measure() const override {
    const glm::dvec4 n(grid_.latestCounts());
    return {n.x, n.y, n.z, n.w};
  }

 private:
  void bindMaps() const {
    fuels_.bindInput(shader::spread::fuelsBinding);
    ground_.bindInput(shader::spread::groundBinding);
    if (!climbs()) return;
    inclines_.bindInput(shader::spread::inclinesBinding);
    climbs_.bindInput(shader::spread::climbsBinding);
  }
  [[nodiscard]] const WildfireParameters& parameters() const { return plan_.parameters(); }
  [[nodiscard]] bool climbs() const { return parameters().slope > 0; }
  static const WildfireParameters& checked(const scene::Object& object) {
    const auto& parameters = parametersOf<WildfireParameters>(object);
    SpreadGrid::checkLimits(object.name, parameters.size, parameters.slope > 0 ? 2 : 1);
    return parameters;
  }
  static gl::Defines defines(const WildfireParameters& parameters, bool fast) {
    gl::Defines defines = gl::kernelDefines(fast);
    if (parameters.hasEmbers) defines.emplace_back("EMBERS", "1");
    if (parameters.slope > 0) defines.emplace_back("SLOPE", "1");
    return defines;
  }

  std::string name_;
  WildfirePlan plan_;
  std::vector<glm::vec3> palette_;
  StepBlocks<decltype(WildfirePlan::Step::data)> steps_;
  SpreadGrid grid_;
  gl::WordsArray fuels_, ground_, inclines_;
  gl::Vec4Array climbs_;
};

}  // namespace

SimulationKind wildfireKind() {
  return kindOf<WildfireParameters>(
      "wildfire", "Fire on a map of fuel, carried by wind from cell to cell.",
      [](const scene::Object& object, const Setting& setting) {
        static_cast<void>(WildfirePlan(parametersOf<WildfireParameters>(object), object.name, setting.seed,
                                       setting.frameSeconds));
      },
      makeSimulation<Wildfire>);
}

}  // namespace simreel::sim
