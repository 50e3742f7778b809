#include "sim/fluid/fluid.hpp"

#include "sim/core/kind.hpp"
#include "sim/fluid/kernels.hpp"
#include "sim/fluid/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

class Fluid : public Simulation {
 public:
  Fluid(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(parametersOf<FluidParameters>(object), object.name, setting.seed, setting.frameSeconds),
        frameSeconds_(setting.frameSeconds),
        kernels_(name_, plan_, setting.fast, setting.startTime),
        wind_(plan_.parameters().plane, plan_.size(), plan_.parameters().speed,
              [this]() -> const FluidArray& { return kernels_.arrays().flow(); }),
        colors_(plan_.parameters().display.colors()),
        counts_(name_ + " counts", 3 * sizeof(glm::vec4)) {
    for (const std::string& part : FluidParameters::fieldParts())
      channelNames_.push_back(fmt::format("{}.{}", name_, part));
    const FluidParameters& p = plan_.parameters();
    if (p.tracers)
      tracers_ = Tracers(name_, *p.tracers, wind_, plan_.solidsAt(setting.startTime, 0)->solid(),
                         tracerStep(*p.tracers, setting.frameSeconds / plan_.substeps(), setting.seed,
                                    p.wrapsX(), p.wrapsY()),
                         setting.frameSeconds, setting.fast);
    kernels_.start(setting.startTime);
    if (p.tracers) tracers_.drawOver(kernels_.arrays().shown());
    count();
    if (!p.chart) return;
    chart_ = FluidChart(name_, *p.chart, setting.frameSeconds);
    chart_.add(measure());
  }

  void step(double time, const StepWatch& watch) override {
    advance(time, watch);
    prepareDrawing(time + frameSeconds_);
  }
  void pass(double time) override { advance(time, {}); }
  void resumed(double time) override {
    time_ = time;
    kernels_.resume(time);
    prepareDrawing(time);
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.substeps(); }
  [[nodiscard]] std::string elementName(long element) const override {
    const long width = plan_.size().x + 2;
    return fmt::format("cell ({}, {})", element % width - 1, element / width - 1);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    const FluidParameters& p = plan_.parameters();
    Field field;
    field.name = &name_;
    field.words = &kernels_.shownWords();
    field.cells = Field::Cells::colors;
    field.size = p.size;
    field.rowWords = 4 * (p.size.x + 2);
    field.firstWord = field.rowWords + 4;
    field.cellWords = 4;
    field.range = {static_cast<float>(p.display.low), static_cast<float>(p.display.high)};
    field.colors = &colors_;
    field.display = &p.display;
    field.ownColors = p.show == FluidParameters::Show::dye || p.show == FluidParameters::Show::lines;
    if (p.show == FluidParameters::Show::lines) {
      field.size = p.size * p.lineDetail;
      field.rowWords = 4 * field.size.x;
      field.firstWord = 0;
    }
    drawables.fields.push_back(field);
    if (p.chart) chart_.publish(drawables);
    // These fields are for files and are not drawn over the picture.
    field.cells = Field::Cells::floats;
    field.ownColors = false;
    field.display = nullptr;
    field.size = p.size;
    field.cellWords = kernels_.arrays().cellWords();
    field.rowWords = field.cellWords * (p.size.x + 2);
    for (int i = 0; i < static_cast<int>(channelNames_.size()); ++i) {
      field.name = &channelNames_[static_cast<std::size_t>(i)];
      const FluidArrays& arrays = kernels_.arrays();
      field.words = i < 4 ? &arrays.flow().words() : &arrays.dye().words();
      field.firstWord = field.rowWords + field.cellWords + i % 4 * arrays.floatWords();
      drawables.fields.push_back(field);
    }
  }

  void visitCheckpointData(CarryOver& carry) override {
    kernels_.arrays().visitCheckpointData(carry);
    carry.array("solver", kernels_.pressure().control());
    carry.number("steps", steps_);
    if (plan_.parameters().tracers) tracers_.visitCheckpointData(carry);
    if (plan_.parameters().chart) chart_.visitCheckpointData(carry);
  }
  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays = {kernels_.arrays().flowState(), kernels_.arrays().dyeState()};
    if (plan_.parameters().tracers)
      for (const StateArray& array : tracers_.state()) arrays.push_back(array);
    return arrays;
  }
  [[nodiscard]] CountTable counts() const override {
    CountTable table = kernels_.counts();
    if (!isPushed()) return table;
    table.columns.insert(table.columns.end(), {"drag", "lift"});
    table.steps = &counts_;
    table.elements = 3;
    return table;
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &kernels_.status(); }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    const auto width = static_cast<unsigned>(plan_.size().x);
    return fmt::format(
        "fluid \"{}\" blew up in substep {} at cell ({}, {}): its flow is not a number or goes beyond {:g} "
        "times \"speed\" ({:g} "
        "cells/s); use more substeps ({} per frame now), a greater \"speed\" or weaker forces",
        name_, step, element % width, element / width, lostFluidSpeed, plan_.parameters().speed,
        plan_.substeps());
  }
  [[nodiscard]] std::string remark(int frame) const override {
    const FluidPressure::Report report = kernels_.pressure().report();
    std::string text;
    if (report.worstShare > maxFluidDivergence)
      text += fmt::format(
          "max|div u| is {:.2g} of max|u| after a projection, above {:.0e}; use more \"cycles\" than {}",
          report.worstShare, maxFluidDivergence, plan_.parameters().cycles);
    if (report.worstSpeed > plan_.fastest())
      text += (text.empty() ? "" : "; ") + plan_.speedRemark(report.worstSpeed);
    return fmt::format("fluid \"{}\": by frame {} {}", name_, frame, text);
  }
  [[nodiscard]] std::vector<double> measure() const override {
    return measureFluid(plan_, kernels_.solids(), kernels_.arrays().flowState().readAll<glm::vec4>(),
                        kernels_.arrays().dyeState().readAll<glm::vec4>(), kernels_.pressure().report(),
                        time_);
  }

  void connect(Outlets& outlets) override { outlets.provide(&wind_); }

 private:
  void prepareDrawing(double time) {
    kernels_.prepareDrawing(time);
    if (plan_.parameters().tracers) tracers_.drawOver(kernels_.arrays().shown());
    count();
  }
  /// Returns true if the force on at least one obstacle is measured.
  [[nodiscard]] bool isPushed() const {
    return std::ranges::any_of(plan_.parameters().obstacles, &FluidObstacle::measured);
  }
  /// Fills a row of the counts table: the quantities summed on the GPU, then the force on obstacles.
  void count() {
    kernels_.measure();
    if (!isPushed()) return;
    const FluidParameters& p = plan_.parameters();
    const auto flow = kernels_.arrays().flowState().readAll<glm::vec4>();
    const glm::dvec2 force = forceOn(p, kernels_.solids(), p.viscosity.at(time_), flow).all();
    std::array<glm::vec4, 3> row{};
    kernels_.counts().steps->read(0, std::as_writable_bytes(std::span(row).first(2)));
    row[2] = glm::vec4(glm::dvec4(force.x, -force.y, 0, 0));
    counts_.write(0, std::as_bytes(std::span(row)));
  }
  void advance(double time, const StepWatch& watch) {
    time_ = time;
    kernels_.beginFrame(time);
    if (plan_.parameters().tracers) tracers_.beginFrame();
    for (int i = 1; i <= plan_.substeps(); ++i) {
      kernels_.advance(time, i, static_cast<unsigned>(++steps_));
      if (plan_.parameters().tracers) {
        if (plan_.parameters().obstaclesMove()) tracers_.setSolid(kernels_.solids().solid());
        tracers_.advance();
      }
      if (watch) watch(i);
    }
    if (plan_.parameters().chart) chart_.add(measure());
  }

  std::string name_;
  FluidPlan plan_;
  double frameSeconds_;
  FluidKernels kernels_;
  FluidWind wind_;
  Tracers tracers_;
  FluidChart chart_;
  std::vector<glm::vec3> colors_;
  std::vector<std::string> channelNames_;
  gl::Buffer counts_;  ///< Table row filled by count().
  long steps_ = 0;
  double time_ = 0;  ///< Time of the current state in seconds.
};

}  // namespace

SimulationKind fluidKind() {
  return kindOf<FluidParameters>(
      "fluid", "Incompressible flow with dye and heat: jets, plumes, wakes.",
      [](const scene::Object& object, const Setting& setting) {
        const FluidPlan plan(parametersOf<FluidParameters>(object), object.name, setting.seed,
                             setting.frameSeconds);
      },
      makeSimulation<Fluid>);
}

}  // namespace simreel::sim
