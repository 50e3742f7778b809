#include "sim/gray_scott/gray_scott.hpp"

#include "base/clock.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/retunable.hpp"
#include "sim/gray_scott/kernels.hpp"
#include "sim/gray_scott/quantities.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

class GrayScott : public Simulation, public Retunable {
 public:
  GrayScott(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        uName_(object.name + ".u"),
        plan_(parametersOf<GrayScottParameters>(object), object.name, setting.seed, setting.frameSeconds),
        kernels_(name_, plan_, setting.fast),
        colors_(plan_.parameters().display.colors()) {
    kernels_.setRates(plan_.ratesAt(0));
    prestep(setting);
    for (const shader::Stroke& stroke : plan_.strokesAt(setting.startTime, 0)) kernels_.paint(stroke);
    gl::barrier();
  }

  void step(double time, const StepWatch& watch) override {
    const int steps = plan_.parameters().steps;
    kernels_.setRates(plan_.ratesAt(time));
    int together = 0;  // Number of steps that can run without interruption, because nothing observes the
                       // states between them.
    for (int i = 1; i <= steps; ++i) {
      ++together;
      const auto strokes = plan_.strokesAt(time, i);
      if (strokes.empty() && !watch) continue;
      kernels_.advance(std::exchange(together, 0));
      for (const shader::Stroke& stroke : strokes) kernels_.paint(stroke);
      if (watch) watch(i);
    }
    kernels_.advance(together);
    gl::barrier();
  }

  [[nodiscard]] bool retune(const scene::Parameters& now) override {
    plan_.retune(dynamic_cast<const GrayScottParameters&>(now));
    return true;
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.parameters().steps; }
  [[nodiscard]] std::string elementName(long element) const override {
    const int x = static_cast<int>(element % plan_.columns()) * 2;
    return fmt::format("cells ({}, {}) and ({}, {})", x, element / plan_.columns(),
                       (x + 1) % plan_.parameters().size.x, element / plan_.columns());
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    const GrayScottParameters& p = plan_.parameters();
    Field field;
    field.name = &name_;
    field.words = &kernels_.words();
    field.cells = Field::Cells::floats;
    field.size = p.size;
    field.rowWords = 4 * plan_.columns();
    field.firstWord = 1;  // Index of v in a cell's pair (u, v).
    field.cellWords = 2;
    field.range = {static_cast<float>(p.display.low), static_cast<float>(p.display.high)};
    field.colors = &colors_;
    field.display = &p.display;
    drawables.fields.push_back(field);
    // This field is for files and is not drawn over the picture.
    field.name = &uName_;
    field.firstWord = 0;
    field.display = nullptr;
    drawables.fields.push_back(field);
  }

  void visitCheckpointData(CarryOver& carry) override { carry.array("cells", kernels_.cells().buffer()); }

  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &kernels_.cells().buffer()}};
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &kernels_.status(); }
  [[nodiscard]] std::string remark(int frame) const override {
    return fmt::format(
        "grayScott \"{}\": u or v left 0 to 1 by frame {} and is held there, so the model's sums no longer "
        "hold "
        "(mass is not kept); smaller \"dt\", \"diffuseU\" and \"diffuseV\", or other rates, keep it within",
        name_, frame);
  }
  [[nodiscard]] std::vector<double> measure() const override {
    return measureGrayScott(kernels_.cells().buffer().readAll<glm::vec4>(), plan_.parameters().size);
  }

 private:
  /// Runs the presteps in short batches, so that progress can be reported and the run can be interrupted.
  void prestep(const Setting& setting) {
    const int total = plan_.parameters().presteps;
    if (!setting.presteps) return kernels_.advance(total);
    int piece = 64;
    for (int done = 0; done < total;) {
      const int steps = std::min(piece, total - done);
      const auto begin = Clock::now();
      kernels_.advance(steps);
      gl::barrier();
      glFinish();
      done += steps;
      const double seconds = secondsSince(begin);
      if (seconds < 0.05) piece = std::min(piece * 2, 1 << 20);
      if (seconds > 0.2) piece = std::max(piece / 2, 8);
      setting.presteps(done, total);
    }
  }

  std::string name_, uName_;
  GrayScottPlan plan_;
  GrayScottKernels kernels_;
  std::vector<glm::vec3> colors_;
};

}  // namespace

SimulationKind grayScottKind() {
  return kindOf<GrayScottParameters>(
      "grayScott",
      "Two substances that react and spread: spots, stripes, mazes (Gray-Scott); u and v are held to "
      "0 to 1.",
      [](const scene::Object& object, const Setting& setting) {
        GrayScottPlan(parametersOf<GrayScottParameters>(object), object.name, setting.seed,
                      setting.frameSeconds)
            .checkPictures();
      },
      makeSimulation<GrayScott>);
}

}  // namespace simreel::sim
