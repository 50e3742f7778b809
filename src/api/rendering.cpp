#include "api/simreel/rendering.hpp"

#include "api/failure.hpp"
#include "api/rendering_state.hpp"
#include "batch/sweep/measurements.hpp"
#include "frame/frames_spec.hpp"
#include "frame/sink/progress.hpp"
#include "scene/json/words.hpp"
#include "scene/shipped_scene.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace simreel {

namespace {

frame::Existing policyOf(Existing existing) {
  switch (existing) {
    case Existing::overwrite:
      return frame::Existing::overwrite;
    case Existing::skip:
      return frame::Existing::skip;
    case Existing::resume:
      return frame::Existing::resume;
    case Existing::error:
      break;
  }
  return frame::Existing::error;
}

/// Returns the layers with these names, in the order of the enumeration.
std::vector<draw::Layer> layersNamed(const std::vector<std::string>& names) {
  const std::vector<std::string> known(draw::layerNames.begin(), draw::layerNames.end());
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      api::fail(ErrorKind::usage,
                fmt::format("there is no layer \"{}\"; {}", name, scene::suggestion(name, known)));
  std::vector<draw::Layer> layers;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (std::find(names.begin(), names.end(), known[i]) != names.end())
      layers.push_back(static_cast<draw::Layer>(i));
  return layers;
}

void requireMeaning(const RenderOptions& options) {
  if (options.bits && *options.bits != 8 && *options.bits != 16 && *options.bits != 32)
    api::fail(ErrorKind::usage, fmt::format("bits are 8, 16 or 32, not {}", *options.bits));
  if (options.streamFormat != "rgba" && options.streamFormat != "y4m")
    api::fail(ErrorKind::usage, fmt::format("the format of a stream is \"rgba\" or \"y4m\", not \"{}\"",
                                            options.streamFormat));
  if (options.checkpoint && !(*options.checkpoint >= 0))
    api::fail(ErrorKind::usage,
              fmt::format("seconds between checkpoints are at least 0, not {}", *options.checkpoint));
}

StageTimes timesOf(const frame::StageTimes& from) {
  StageTimes times;
  times.start = from.start;
  times.simulate = from.simulate;
  times.draw = from.draw;
  times.readBack = from.readBack;
  times.encode = from.encode;
  times.wait = from.wait;
  return times;
}

/// Passes the events of a run on to the functions of a RenderEvents.
class Teller final : public frame::RunListener {
 public:
  explicit Teller(const RenderEvents& events) : events_(events) {}
  void start(int total) override {
    if (events_.start) events_.start(total);
  }
  void prepare(long done, long total) override {
    if (events_.prepare) events_.prepare(done, total);
  }
  void frame(int number, const frame::StageTimes& stages) override {
    if (events_.frame) events_.frame(number, timesOf(stages));
  }
  void counts(int frame, std::string_view names, std::string_view row) override {
    if (events_.counts) events_.counts(frame, names, row);
  }
  void clear() override {
    if (events_.complete) events_.complete();
  }
  void finish(const char* status, const frame::StageTimes& stages) override {
    if (events_.end) events_.end(status, timesOf(stages));
  }

 private:
  const RenderEvents& events_;
};

}  // namespace

scene::SceneInput api::inputOf(std::string file, std::optional<std::string> text,
                               const LoadOptions& options) {
  scene::SceneInput input{std::move(file), std::move(text), {}, {}};
  for (const Change& change : options.changes) input.overrides.push_back({change.path, change.value});
  for (const std::string& folder : options.assets) input.assets.emplace_back(folder);
  return input;
}

batch::RenderRequest api::requestOf(scene::SceneInput input, const std::string& output,
                                    const RenderOptions& options) {
  requireMeaning(options);
  batch::RenderRequest request;
  request.input = std::move(input);
  request.output = output;
  request.frames = options.frames;
  request.existing = policyOf(options.existing);
  request.fields = options.fields;
  request.counts = options.counts;
  request.manifest = options.manifest;
  request.checkpoint = options.checkpoint;
  if (options.checkpointAt) {
    const std::vector<int> kept = frame::parseFrames(*options.checkpointAt, "--checkpoint-at");
    request.checkpointAt = {kept.begin(), kept.end()};
  }
  request.from = options.from;
  request.streamFormat = options.streamFormat;
  request.layers = layersNamed(options.layers);
  request.bits = options.bits;
  request.command = options.command;
  return request;
}

std::unique_ptr<Rendering::State> Rendering::State::make(scene::SceneInput input, const std::string& output,
                                                         const RenderOptions& options) {
  const Clock::time_point began = Clock::now();
  try {
    if (!input.text) input.file = scene::sceneFile(input.file.string());
    return std::make_unique<State>(api::requestOf(std::move(input), output, options), began);
  } catch (...) {
    api::rethrowAsError(std::current_exception());
  }
}

RenderResult Rendering::State::run(Device::State& device, const RenderEvents& events) {
  if (std::exchange(hasRun, true))
    api::fail(ErrorKind::usage, "a rendering runs once; make another Rendering");
  std::optional<RenderResult> made;
  const auto work = [&] {
    std::optional<batch::Measurements> checks;
    if (events.check && !job.scene().checks.empty())
      checks.emplace(job.scene(), job.frames(), batch::CheckFiles(), [&](const golden::CheckResult& one) {
        events.check({one.what, one.frame, one.value.value_or(std::numeric_limits<double>::quiet_NaN()),
                      one.passed, one.message});
      });
    Teller teller(events);
    const frame::SequenceResult result =
        job.run(*device.context, teller, began, checks ? &*checks : nullptr);
    made = RenderResult{result.frames, result.signal != 0, result.seconds, timesOf(result.stages),
                        job.summary()};
  };
  try {
    device.run(work);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::interrupted || !made) throw;
    made->interrupted = true;
  }
  return *std::move(made);
}

Rendering::Rendering(const std::string& file, const std::string& output, const RenderOptions& options,
                     const LoadOptions& load, const std::optional<std::string>& text)
    : state_(State::make(api::inputOf(file, text, load), output, options)) {}
Rendering::~Rendering() = default;
Rendering::Rendering(Rendering&&) noexcept = default;
Rendering& Rendering::operator=(Rendering&&) noexcept = default;

RenderResult Rendering::run(const Device& device, const RenderEvents& events) {
  return state_->run(*device.state(), events);
}

}  // namespace simreel
