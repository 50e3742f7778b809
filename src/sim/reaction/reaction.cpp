#include "sim/reaction/reaction.hpp"

#include "base/error.hpp"
#include "sim/core/kind.hpp"
#include "sim/gray_scott/quantities.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/grid/tally.hpp"
#include "sim/reaction/kernels.hpp"
#include "sim/reaction/model.hpp"
#include "sim/reaction/presets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

class Reaction : public Simulation {
 public:
  Reaction(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(parametersOf<ReactionParameters>(object), object.name, setting.seed, setting.frameSeconds),
        kernels_(name_, plan_, setting.fast),
        colors_(plan_.parameters().display.colors()),
        first_(plan_.stepAt(setting.startTime) - plan_.parameters().presteps),
        now_(plan_.stepAt(setting.startTime)) {
    for (const ReactionSpecies& species : plan_.parameters().species)
      speciesNames_.push_back(name_ + "." + species.name);
    makeTally(setting.fast);
    kernels_.setValues(plan_.valuesAt(0));
    prestep(setting);
    for (const auto& [stroke, species] : plan_.strokesAt(setting.startTime, 0))
      kernels_.paint(stroke, species);
    gl::barrier();
    look();
  }

  void step(double time, const StepWatch& watch) override {
    advance(time, watch);
    look();
  }
  void pass(double time) override { advance(time, {}); }
  void resumed(double time) override {
    now_ = plan_.stepAt(time);
    kernels_.setValues(plan_.valuesAt(time));
    look();
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.parameters().steps; }
  [[nodiscard]] std::string elementName(long element) const override {
    const long plane = element / kernels_.columns() / plan_.parameters().size.y;
    const long row = element / kernels_.columns() % plan_.parameters().size.y;
    const long x = element % kernels_.columns() * 4;
    return fmt::format("{} of cells ({}, {}) to ({}, {})", speciesName(plane), x, row,
                       std::min<long>(x + 3, plan_.parameters().size.x - 1), row);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    const ReactionParameters& p = plan_.parameters();
    const int planeWords = 4 * kernels_.columns() * p.size.y;
    Field field;
    field.name = &name_;
    field.words = &kernels_.shownWords();
    field.cells = Field::Cells::floats;
    field.size = p.size;
    field.rowWords = 4 * kernels_.columns();
    field.firstWord = planeWords * plan_.program().shown;
    field.cellWords = 1;
    field.range = {static_cast<float>(p.display.low), static_cast<float>(p.display.high)};
    field.colors = &colors_;
    field.display = &p.display;
    drawables.fields.push_back(field);
    // For files only.
    field.words = &kernels_.words();
    field.display = nullptr;
    for (std::size_t i = 0; i < speciesNames_.size(); ++i) {
      field.name = &speciesNames_[i];
      field.firstWord = planeWords * static_cast<int>(i);
      drawables.fields.push_back(field);
    }
  }

  void carryOver(CarryOver& carry) override { carry.array("cells", kernels_.cells().buffer()); }
  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &kernels_.cells().buffer()}};
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &kernels_.status(); }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    const auto width = static_cast<unsigned>(plan_.parameters().size.x);
    const auto height = static_cast<unsigned>(plan_.parameters().size.y);
    return fmt::format(
        "reaction \"{}\": {} of cell ({}, {}) is infinite or no number after step {}; a smaller \"dt\" or "
        "another "
        "\"method\" may keep it finite",
        name_, speciesName(element / width / height), element % width, element / width % height,
        static_cast<int>(step) + 1 - static_cast<int>(first_));
  }

  [[nodiscard]] CountTable counts() const override {
    std::vector<const char*> names;
    names.reserve(countNames_.size());
    for (const std::string& name : countNames_) names.push_back(name.c_str());
    return tally_.table(std::move(names));
  }
  [[nodiscard]] std::vector<double> measure() const override {
    Drawables drawables;
    publish(0, drawables);
    const std::vector<float> values = fieldValues(drawables.fields.front());
    const auto count = static_cast<double>(values.size());
    double sum = 0, squares = 0;
    for (const float value : values) sum += static_cast<double>(value);
    for (const float value : values) {
      const double d = static_cast<double>(value) - sum / count;
      squares += d * d;
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {sum / count, *least, *most, std::sqrt(squares / count),
            dominantWavelength(values, plan_.parameters().size)};
  }

 private:
  void makeTally(bool fast) {
    const ReactionParameters& p = plan_.parameters();
    const int species = std::min(static_cast<int>(p.species.size()), 4);
    tally_ = Tally(name_, "reaction/tally.comp", gl::kernelDefines(fast));
    tally_.kernel().set("size", p.size);
    tally_.kernel().set("columns", kernels_.columns());
    tally_.kernel().set("species", species);
    for (int i = 0; i < 4; ++i) {
      const std::string& name = p.species[static_cast<std::size_t>(i % species)].name;
      countNames_.push_back("mean_" + name + (i < species ? "" : "^" + std::to_string(i / species + 1)));
    }
    for (int i = 0; i < species; ++i)
      countNames_.push_back("most_" + p.species[static_cast<std::size_t>(i)].name);
  }
  /// What is drawn and counted of the present state.
  void look() {
    kernels_.show(now_, first_);
    kernels_.cells().bindInput(shader::reaction::stageBinding);
    const glm::ivec2 size = plan_.parameters().size;
    tally_.take(glm::vec4(static_cast<float>(1 / (static_cast<double>(size.x) * size.y))), glm::vec4(1));
  }

  [[nodiscard]] std::string speciesName(long plane) const {
    const auto& species = plan_.parameters().species;
    return plane < static_cast<long>(species.size())
               ? "\"" + species[static_cast<std::size_t>(plane)].name + "\""
               : "a species";
  }

  void advance(double time, const StepWatch& watch) {
    const int steps = plan_.parameters().steps;
    now_ = plan_.stepAt(time);
    kernels_.setValues(plan_.valuesAt(time));
    const long begin = now_;
    int together = 0;  // steps that nobody looks between
    const auto go = [&] {
      kernels_.advance(now_, together, first_);
      now_ += std::exchange(together, 0);
    };
    for (int i = 1; i <= steps; ++i) {
      ++together;
      const auto strokes = plan_.strokesAt(time, i);
      if (strokes.empty() && !watch) continue;
      go();
      for (const auto& [stroke, species] : strokes) kernels_.paint(stroke, species);
      if (!watch) continue;
      gl::barrier();
      watch(i);
    }
    go();
    SIMREEL_CHECK_EQ(now_, begin + steps);
    gl::barrier();
  }

  /// In pieces that take a moment each, so that they can be watched and ended.
  void prestep(const Setting& setting) {
    const int total = plan_.parameters().presteps;
    constexpr int piece = 32;
    for (int done = 0; done < total; done += piece) {
      const int steps = std::min(piece, total - done);
      kernels_.advance(first_ + done, steps, first_);
      if (!setting.presteps) continue;
      gl::barrier();
      glFinish();
      setting.presteps(done + steps, total);
    }
  }

  std::string name_;
  std::vector<std::string> speciesNames_;
  ReactionPlan plan_;
  ReactionKernels kernels_;
  std::vector<glm::vec3> colors_;
  Tally tally_;
  std::vector<std::string> countNames_;
  long first_, now_;  ///< numbers of steps: of the first state, and of the present
};

}  // namespace

SimulationKind reactionKind() {
  SimulationKind kind = kindOf<ReactionParameters>(
      "reaction",
      "Equations of your own on a grid: du/dt = D laplacian(u) + an expression, or one of many presets.",
      [](const scene::Object& object, const Setting& setting) {
        ReactionPlan(parametersOf<ReactionParameters>(object), object.name, setting.seed,
                     setting.frameSeconds)
            .checkPictures();
      },
      makeSimulation<Reaction>);
  kind.kind.appendix = reactionPresetsText;
  return kind;
}

}  // namespace simreel::sim
