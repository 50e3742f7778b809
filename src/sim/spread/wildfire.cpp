#include "sim/spread/wildfire.hpp"

#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/core/kind.hpp"
#include "sim/fluid/wind.hpp"
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
    if (blown()) makeGales(setting);
    if (!climbs()) return;
    inclines_ = gl::WordsArray(name_ + " inclines", packedCells(plan_.inclines(), parameters().size));
    climbs_ = gl::Vec4Array(name_ + " climb", plan_.climbFactors());
  }

  void step(double time, const StepWatch& watch) override {
    if (blown()) blow(time);
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
    if (blown()) gales_.bindInput(shader::spread::galesBinding);
    if (!climbs()) return;
    inclines_.bindInput(shader::spread::inclinesBinding);
    climbs_.bindInput(shader::spread::climbsBinding);
  }
  [[nodiscard]] const WildfireParameters& parameters() const { return plan_.parameters(); }
  [[nodiscard]] bool blown() const { return !parameters().windFluid.empty(); }
  void makeGales(const Setting& setting) {
    wind_ = setting.wanted<FluidWind>(parameters().windFluid);
    const glm::ivec2 size = parameters().size;
    const int rowGales = 4 * grid_.rowElements();
    gales_ = gl::WordsArray(name_ + " gales", rowGales * size.y);
    gl::Defines defines = gl::kernelDefines(setting.fast);
    addWindDefines(defines, wind_);
    gale_ = gl::Program::compute("spread/wildfire/gale.comp", defines);
    gale_.set("size", size);
    gale_.set("perCell", glm::vec2(wind_->grid().size) / glm::vec2(size));
    gale_.set("rowGales", rowGales);
    gale_.set("count", rowGales * size.y);
    wind_->tell(gale_);
  }
  /// The wind that the steps of the frame that starts at `time` (s) have.
  void blow(double time) {
    gale_.set("scale", plan_.galeScale(time, wind_->speed()));
    wind_->bind();
    gales_.bindState(shader::spread::nextCellsBinding);
    gl::barrier();
    gale_.dispatch(4 * grid_.rowElements() * parameters().size.y);
    gl::barrier();
  }
  [[nodiscard]] bool climbs() const { return parameters().slope > 0; }
  static const WildfireParameters& checked(const scene::Object& object) {
    const auto& parameters = parametersOf<WildfireParameters>(object);
    const int bytes = !parameters.windFluid.empty() ? 4 : parameters.slope > 0 ? 2 : 1;
    SpreadGrid::checkLimits(object.name, parameters.size, bytes);
    return parameters;
  }
  static gl::Defines defines(const WildfireParameters& parameters, bool fast) {
    gl::Defines defines = gl::kernelDefines(fast);
    if (parameters.embers) defines.emplace_back("EMBERS", "1");
    if (parameters.slope > 0) defines.emplace_back("SLOPE", "1");
    if (!parameters.windFluid.empty()) defines.emplace_back("GALES", "1");
    return defines;
  }

  std::string name_;
  WildfirePlan plan_;
  std::vector<glm::vec3> palette_;
  StepBlocks<decltype(WildfirePlan::Step::data)> steps_;
  SpreadGrid grid_;
  gl::WordsArray fuels_, ground_, inclines_;
  gl::Vec4Array climbs_;
  const FluidWind* wind_ = nullptr;  ///< null: the wind is the same everywhere
  gl::WordsArray gales_;
  gl::Program gale_;
};

}  // namespace

SimulationKind wildfireKind() {
  return kindOf<WildfireParameters>(
      "wildfire", "Fire on a map of fuel, carried by wind from cell to cell.",
      [](const scene::Object& object, const Setting& setting) {
        // A grid of gigabytes is checked by a small one from the same pictures, and its strokes alone.
        WildfireParameters parameters = parametersOf<WildfireParameters>(object);
        if (parameters.leastBlockBytes() > ObjectParameters::commonBlockBytes) {
          static_cast<void>(Strokes(parameters.strokes, setting.seed,
                                    {parameters.size, parameters.border == SpreadParameters::Border::torus,
                                     "wildfire \"" + object.name + "\""}));
          parameters.size = SpreadParameters::lookedAt;
          parameters.strokes.clear();
        }
        static_cast<void>(WildfirePlan(parameters, object.name, setting.seed, setting.frameSeconds));
      },
      makeSimulation<Wildfire>);
}

}  // namespace simreel::sim
