#include "sim/kernels/kernels.hpp"

#include "base/error.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/numerics.hpp"
#include "sim/core/race_checked.hpp"
#include "sim/core/state_layout.hpp"
#include "sim/kernels/drawn.hpp"
#include "sim/kernels/finite.hpp"
#include "sim/kernels/inputs.hpp"
#include "sim/kernels/layouts.hpp"
#include "sim/kernels/memory.hpp"
#include "sim/kernels/pace.hpp"
#include "sim/kernels/parameters.hpp"
#include "sim/kernels/plan.hpp"
#include "sim/kernels/programs.hpp"
#include "sim/kernels/races.hpp"
#include "sim/kernels/reports.hpp"
#include "sim/kernels/wind.hpp"
#include "sim/ports/landform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::sim {

void checkKernels(const scene::Object& object, const Setting& /*setting*/) {
  const auto& parameters = parametersOf<KernelsParameters>(object);
  if (parameters.file.empty())
    fail(ExitCode::usage, "{} \"{}\" needs \"file\", a shader", object.kind, object.name);
  if (parameters.plan != nullptr) return;
  if (parameters.problemIsReport)
    throw UserError(ExitCode::usage, parameters.problem, UserError::Form::report);
  fail(ExitCode::usage, "{} \"{}\": {}", object.kind, object.name, parameters.problem);
}

std::vector<std::filesystem::path> shaderFiles(const scene::Scene& scene) {
  std::vector<std::filesystem::path> files;
  for (const scene::Object& object : scene.objects)
    if (const auto* kernels = dynamic_cast<const KernelsParameters*>(object.parameters.get()))
      for (const auto& file : kernels->shaderFiles()) files.push_back(file);
  return files;
}

namespace {

class Kernels : public Simulation,
                public RaceChecked,
                public FrameStarter,
                public LaidOut,
                public Landform {
 public:
  Kernels(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<KernelsParameters>(object)),
        frameSeconds_(setting.frameSeconds),
        seed_(setting.seed),
        plan_((checkKernels(object, setting), parameters_.plan)),
        store_(name_, *plan_, static_cast<unsigned>(setting.seed)),
        finite_(name_, *plan_, parameters_.nonFinite),
        drawn_(name_, *plan_, finite_, object.material, setting.frameSeconds),
        reports_(name_, *plan_, finite_, parameters_.bounds == KernelDescription::Bounds::ignore),
        programs_(name_, parameters_.requests),
        inputs_(*plan_, object, setting.links),
        startTime_(setting.startTime),
        kind_(object.kind) {
    checkLoops();
    if (plan_->drawn().wind) wind_.emplace(name_, *plan_, finite_.watch(KernelFinite::Part::wind));
    if (inputs_.any())
      showStart();
    else
      begin();
  }

  /// Kernels that read from other objects start when all objects exist.
  void frameStarts() override {
    inputs_.update(store_, !begun_);
    if (!begun_) begin();
  }

  void connect(Outlets& outlets) override {
    if (wind_) outlets.provide(wind_->outlet());
    if (KernelGround* ground = drawn_.ground(); ground != nullptr && ground->outlet() != nullptr)
      outlets.provide(ground->outlet());
  }
  void step(double time, const StepWatch& watch) override {
    advance(time, watch);
    finish(time + frameSeconds_);
    endFrame();
  }
  /// Other objects may use the wind and the ground of this frame, so both are updated, too.
  void pass(double time) override {
    if (wind_ || drawn_.ground() != nullptr) return step(time, {});
    advance(time, {});
    store_.settle();
    reports_.collect(frameAt(time) + 1);
  }
  void resumed(double time) override {
    store_.putBack();
    finish(time);
  }
  [[nodiscard]] const gl::Buffer* status() const override { return reports_.status(); }
  [[nodiscard]] std::string remark(int /*frame*/) const override { return reports_.message(); }
  [[nodiscard]] std::string explainLoss(unsigned /*step*/, unsigned report) const override {
    return reports_.message(report);
  }
  [[nodiscard]] int stepsPerFrame() const override { return parameters_.steps; }
  [[nodiscard]] std::string elementName(long element) const override {
    return fmt::format("bytes {} to {}", 16 * element, 16 * element + 15);
  }
  void publish(double /*time*/, Drawables& drawables) const override { drawn_.publish(drawables); }
  void visitCheckpointData(CarryOver& carry) override {
    for (std::size_t i = 0; i < plan_->buffers().size(); ++i)
      carry.array(plan_->buffers()[i].name.c_str(), store_.buffer(static_cast<int>(i)));
    for (std::size_t i = 0; i < plan_->textures().size(); ++i)
      carry.array(plan_->textures()[i].name.c_str(), store_.words(static_cast<int>(i)));
    if (KernelGround* ground = drawn_.ground()) ground->visitCheckpointData(carry);
  }
  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays;
    for (std::size_t i = 0; i < plan_->buffers().size(); ++i)
      arrays.push_back({plan_->buffers()[i].name.c_str(), &store_.buffer(static_cast<int>(i)),
                        !plan_->buffers()[i].allFloats});
    for (std::size_t i = 0; i < plan_->textures().size(); ++i)
      arrays.push_back({plan_->textures()[i].name.c_str(), &store_.words(static_cast<int>(i)),
                        plan_->textures()[i].integers()});
    return arrays;
  }
  [[nodiscard]] std::vector<StateLayout> layouts() const override {
    std::vector<StateLayout> all;
    for (const PlannedBuffer& buffer : plan_->buffers()) all.push_back(layoutOf(buffer));
    for (const PlannedTexture& texture : plan_->textures()) all.push_back(layoutOf(texture));
    return all;
  }
  [[nodiscard]] std::vector<std::string> races(double time) override {
    if (!parameters_.requests.front().pass.empty())
      return {};  // an image needs no race check, because each invocation writes only its pixel
    const KernelStore::Saved before = store_.save();
    races_ = std::make_unique<KernelRaces>(name_, parameters_.requests.front());
    run(plan_->first(), nowAt(time, 0), true);
    store_.restore(before);
    for (int i = 0; i < std::min(parameters_.steps, 2); ++i) run(plan_->step(), nowAt(time, i), false);
    store_.restore(before);
    store_.settle();
    std::vector<std::string> found = races_->found();
    races_.reset();
    return found;
  }
  bool grow() override { return drawn_.grow(); }
  [[nodiscard]] PointTable points() const override { return drawn_.points(); }
  [[nodiscard]] std::optional<MeshTable> mesh() const override { return drawn_.mesh(); }
  [[nodiscard]] MeshTable landform() const override { return drawn_.mesh().value_or(MeshTable()); }
  [[nodiscard]] std::vector<double> measure() const override {
    std::vector<double> values;
    for (const KernelMeasure& one : parameters_.measured) values.push_back(measured(one));
    return values;
  }

 private:
  /// Fails if the driver silently ends long loops and the limit in the scene does not prevent such loops.
  void checkLoops() const {
    if ((parameters_.iterations > 0 && parameters_.iterations <= 65535) ||
        parameters_.bounds == KernelDescription::Bounds::silent)
      return;
    if (const unsigned reached = probeLoop(); reached < loopProbeRounds)
      fail(ExitCode::device,
           "{} \"{}\": this driver ends each loop after {} iterations; give \"iterations\" at most that",
           kind_, name_, reached);
  }
  [[nodiscard]] long frameAt(double time) const { return std::lround(time / frameSeconds_); }
  [[nodiscard]] KernelPlan::Now nowAt(double time, int step) const {
    const double dt = frameSeconds_ / std::max(1, parameters_.steps);
    const long frame = frameAt(time);
    return {dt, time + step * dt, frame, frame * parameters_.steps + step, seed_, inputs_.quantities()};
  }

  /// Publishes the initial values, which other objects may read before these kernels start.
  void showStart() {
    store_.settle();
    drawn_.update(store_, startTime_);
    endFrame();
    if (wind_) wind_->update(store_);
  }

  void begin() {
    begun_ = true;
    run(plan_->first(), nowAt(startTime_, 0), true);
    finish(startTime_);
    endFrame();
  }

  void advance(double time, const StepWatch& watch) {
    for (int i = 0; i < parameters_.steps; ++i) {
      run(plan_->step(), nowAt(time, i), false);
      if (!watch) continue;
      store_.settle();
      watch(i + 1);
    }
  }

  void finish(double time) {
    store_.settle();
    drawn_.update(store_, time);
    if (wind_) wind_->update(store_);
    reports_.collect(frameAt(time));
  }
  void endFrame() {
    if (KernelGround* ground = drawn_.ground()) ground->endFrame();
  }

  void run(const std::vector<PlannedEntry>& entries, const KernelPlan::Now& now, bool first) {
    for (const PlannedEntry& entry : entries) {
      if (!first && now.step % entry.every != 0) continue;
      for (int i = 0; i < entry.repeat; ++i) {
        if (entry.kernel >= 0) {
          dispatch(entry, now);
          pace_.dispatched();
        }
        if (entry.count >= 0) store_.copyCounter(entry);
        if (!entry.clear.empty()) store_.clear(entry.clear);
        if (!entry.swapA.empty()) store_.swap(entry.swapA, entry.swapB);
      }
    }
  }

  void dispatch(const PlannedEntry& entry, const KernelPlan::Now& now) {
    if (races_) return races_->dispatch(store_, entry, now);
    const auto& group = programs_.kernel(entry.kernel).threads;
    reports_.bind(static_cast<std::size_t>(entry.kernel),
                  KernelPrograms::groups(*plan_, entry, now) * glm::uvec3(group[0], group[1], group[2]));
    programs_.dispatch(store_, entry, now);
  }

  [[nodiscard]] double measured(const KernelMeasure& measure) const {
    const std::vector<KernelSlot> slots = plan_->slots(measure.of);
    const KernelSlot& slot = *slotNamed(slots, measure.member);
    const int place = plan_->bufferNamed(measure.of);
    const gl::Buffer& memory =
        place >= 0 ? store_.buffer(place) : store_.words(plan_->textureNamed(measure.of));
    const auto bytes = memory.readAll<std::byte>();
    std::size_t header = 0, stride = 16, count = memory.bytes() / 16;
    if (place >= 0) {
      const PlannedBuffer& buffer = plan_->buffers()[static_cast<std::size_t>(place)];
      header = buffer.header, stride = buffer.stride, count = buffer.count();
    }
    double sum = 0, minimum = std::numeric_limits<double>::infinity(), maximum = -minimum;
    for (std::size_t i = 0; i < count; ++i) {
      double value = 0;
      for (std::size_t c = 0; c < slot.offsets.size(); ++c) {
        const double part = loadSlot(bytes.data() + header + i * stride, slot, c);
        value = slot.offsets.size() == 1 ? part : value + part * part;
      }
      if (slot.offsets.size() > 1) value = std::sqrt(value);
      sum += value;
      minimum = std::min(minimum, value);
      maximum = std::max(maximum, value);
    }
    using What = KernelMeasure::What;
    return measure.what == What::sum   ? sum
           : measure.what == What::min ? minimum
           : measure.what == What::max ? maximum
                                       : sum / static_cast<double>(count);
  }

  std::string name_;
  KernelsParameters parameters_;
  double frameSeconds_;
  int seed_;
  std::shared_ptr<const KernelPlan> plan_;
  KernelStore store_;
  KernelFinite finite_;
  KernelDrawn drawn_;
  std::optional<KernelWindSource> wind_;
  KernelReports reports_;
  KernelPrograms programs_;
  DispatchPace pace_;
  KernelInputs inputs_;
  double startTime_;
  bool begun_ = false;  ///< true once the passes of `first` have run
  std::string kind_;
  std::unique_ptr<KernelRaces> races_;  ///< null unless a race check is running
};

}  // namespace

std::unique_ptr<Simulation> makeKernels(const scene::Object& object, const Setting& setting) {
  return std::make_unique<Kernels>(object, setting);
}

SimulationKind kernelsKind() {
  return kindOf<KernelsParameters>(
      "kernels", "Compute shaders of your own: Unity's .compute, HLSL or GLSL.", checkKernels, makeKernels);
}

}  // namespace simreel::sim
