#include "sim/spread/wildfire.hpp"

#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/core/kind.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/spread/grid.hpp"
#include "sim/spread/wildfire_plan.hpp"

namespace simreel::sim {

namespace {

struct WildfireStepKernel {
  static constexpr auto file = "spread/wildfire/step.comp";
  struct Variant {
    gl::Flag<"EMBERS"> embers;
    gl::Flag<"SLOPE"> slope;
    gl::Flag<"GALES"> gales;
  };
  SpreadStepPart part;
  gl::Block<"StepBlock", decltype(WildfirePlan::Step::data)> uniforms;
  gl::In<"fuels"> fuels;
  gl::In<"ground"> ground;
  gl::In<"gales"> gales;
  gl::In<"inclines"> inclines;
  gl::In<"climbs"> climbs;
};

struct WildfirePaintKernel {
  static constexpr auto file = "spread/wildfire/paint.comp";
  SpreadPaintPart part;
  gl::Block<"StepBlock", decltype(WildfirePlan::Step::data)> uniforms;
  gl::In<"ground"> ground;
};

struct WildfireGaleKernel {
  static constexpr auto file = "spread/wildfire/gale.comp";
  struct Variant {
    gl::Flag<"WIND"> wind;
  };
  FluidWindPart wind;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"perCell", glm::vec2> perCell;
  gl::Uniform<"scale", float> scale;
  gl::Uniform<"rowGales", int> rowGales;
  gl::Uniform<"count", int> count;
  gl::Out<"gales"> gales;
};

class Wildfire final : public Simulation {
 public:
  Wildfire(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(checked(object), object.name, setting.seed, setting.frameSeconds),
        palette_(plan_.palette()),
        steps_(name_ + " steps", plan_.stepsPerFrame()),
        grid_(name_, parameters(), plan_.firstCells(), plan_.stepsPerFrame(), plan_.strokes()),
        fuels_(name_ + " fuel", packedCells(plan_.fuels(), parameters().size)),
        ground_(name_ + " ground", packedCells(plan_.ground(), parameters().size)) {
    const gl::Defines defines = gl::kernelDefines(setting.fast);
    step_ = gl::Kernel<WildfireStepKernel>(defines, {.embers = parameters().embers.has_value(),
                                                     .slope = climbs(),
                                                     .gales = !parameters().windFluid.empty()});
    paint_ = gl::Kernel<WildfirePaintKernel>(defines);
    grid_.paintFirst(plan_.firstStrokes(setting.startTime), steps_.at(0), *this);
    if (blown()) makeGales(setting);
    if (!climbs()) return;
    inclines_ = gl::WordsArray(name_ + " inclines", packedCells(plan_.inclines(), parameters().size));
    climbs_ = gl::Vec4Array(name_ + " climb", plan_.climbFactors());
  }

  void step(double time, const StepWatch& watch) override {
    if (blown()) blow(time);
    grid_.runFrame(plan_.frame(time), steps_, plan_.stepsPerFrame(), watch, *this);
  }
  void step(glm::ivec2 items, const SpreadStepPart& part, const gl::Resource& uniforms) const {
    step_.dispatch(items, {.part = part,
                           .uniforms = uniforms,
                           .fuels = fuels_,
                           .ground = ground_,
                           .gales = gales_,
                           .inclines = inclines_,
                           .climbs = climbs_});
  }
  void paint(glm::ivec2 items, const SpreadPaintPart& part, const gl::Resource& uniforms) const {
    paint_.dispatch(items, {.part = part, .uniforms = uniforms, .ground = ground_});
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.stepsPerFrame(); }
  [[nodiscard]] std::string elementName(long element) const override { return grid_.elementName(element); }
  void publish(double /*time*/, Drawables& drawables) const override {
    static const SpreadGrid::ClassNames classes = {{8, "rock"},     {24, "water"}, {72, "grass"},
                                                   {120, "forest"}, {132, "fire"}, {255, "burnt"}};
    grid_.publishField(name_, palette_, classes, parameters().display, drawables);
    if (!parameters().chart) return;
    grid_.publishChart({"unburnt", "burning", "burnt"},
                       {{0.20F, 0.55F, 0.16F}, {1.0F, 0.45F, 0.08F}, {0.45F, 0.40F, 0.38F}},
                       parameters().chartSeconds * parameters().stepsPerSecond, drawables);
  }
  void visitCheckpointData(CarryOver& carry) override {
    plan_.visitCheckpointData(carry);
    grid_.visitCheckpointData(carry);
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
  [[nodiscard]] const WildfireParameters& parameters() const { return plan_.parameters(); }
  [[nodiscard]] bool blown() const { return !parameters().windFluid.empty(); }
  void makeGales(const Setting& setting) {
    wind_ = setting.wanted<FluidWind>(parameters().windFluid);
    gales_ = gl::WordsArray(name_ + " gales", rowGales() * parameters().size.y);
    gale_ = gl::Kernel<WildfireGaleKernel>(gl::kernelDefines(setting.fast), {.wind = true});
  }
  /// Returns the number of elements per row of gales_.
  [[nodiscard]] int rowGales() const { return 4 * grid_.rowElements(); }
  /// Samples the fluid's wind for the steps of the frame that starts at `time` (seconds).
  void blow(double time) {
    const glm::ivec2 size = parameters().size;
    const int count = rowGales() * size.y;
    gl::barrier();
    gale_.dispatch(count, {.wind = wind_->part(),
                           .size = size,
                           .perCell = glm::vec2(wind_->grid().size) / glm::vec2(size),
                           .scale = plan_.galeScale(time, wind_->speed()),
                           .rowGales = rowGales(),
                           .count = count,
                           .gales = gales_});
  }
  [[nodiscard]] bool climbs() const { return parameters().slope > 0; }
  static const WildfireParameters& checked(const scene::Object& object) {
    const auto& parameters = parametersOf<WildfireParameters>(object);
    const int bytes = !parameters.windFluid.empty() ? 4 : parameters.slope > 0 ? 2 : 1;
    SpreadGrid::checkLimits(object.name, parameters.size, bytes);
    return parameters;
  }
  std::string name_;
  WildfirePlan plan_;
  std::vector<glm::vec3> palette_;
  StepBlocks<decltype(WildfirePlan::Step::data)> steps_;
  SpreadGrid grid_;
  gl::WordsArray fuels_, ground_, inclines_;
  gl::Vec4Array climbs_;
  const FluidWind* wind_ = nullptr;  ///< source of the wind; null for uniform wind
  gl::WordsArray gales_;
  gl::Kernel<WildfireStepKernel> step_;
  gl::Kernel<WildfirePaintKernel> paint_;
  gl::Kernel<WildfireGaleKernel> gale_;
};

}  // namespace

SimulationKind wildfireKind() {
  return kindOf<WildfireParameters>(
      "wildfire", "Fire on a map of fuel, carried by wind from cell to cell.",
      [](const scene::Object& object, const Setting& setting) {
        // A grid that would take gigabytes is validated with a small grid made from the same images. Its
        // strokes are checked separately at full size.
        WildfireParameters parameters = parametersOf<WildfireParameters>(object);
        if (parameters.minLargestBufferBytes() > ObjectParameters::commonBlockBytes) {
          static_cast<void>(Strokes(parameters.strokes, setting.seed,
                                    {parameters.size, parameters.border == SpreadParameters::Border::torus,
                                     "wildfire \"" + object.name + "\""}));
          parameters.size = SpreadParameters::validationPlan;
          parameters.strokes.clear();
        }
        static_cast<void>(WildfirePlan(parameters, object.name, setting.seed, setting.frameSeconds));
      },
      makeSimulation<Wildfire>);
}

}  // namespace simreel::sim
