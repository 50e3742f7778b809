// `simreel trace`: the state of a run as hashes or as raw arrays. What `simreel bisect` talks to.
#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/scene_options.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"
#include "gl/vec4_array.hpp"
#include "sim/numerics.hpp"
#include "sim/world.hpp"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

using Json = nlohmann::ordered_json;

struct TraceOptions {
  SceneOptions scene;
  std::string device, memoryPath;
  std::optional<int> last;
  std::optional<int> stepsOf;
  std::string dump;  ///< FRAME:STEP
  std::string object;
};

/// The reader may have seen enough: then there is nothing left to do. False in that case.
bool printLine(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written && errno != EPIPE) fail(ExitCode::inputOutput, "cannot write to standard output");
  if (!written)
    static_cast<void>(std::freopen("/dev/null", "w", stdout));  // what waits in the buffer goes with it
  return written;
}

Json arrayList(const sim::World& world) {
  Json list = Json::array();
  for (const auto& array : world.arrays())
    list.push_back({{"object", array.object}, {"array", array.array}, {"elements", array.elements}});
  return list;
}

Json header(const sim::World& world, const gl::Context& context, const scene::Scene& scene) {
  Json steps = Json::object();
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (!world.object(i).state().empty()) steps[world.objectName(i)] = world.object(i).stepsPerFrame();
  return {{"simreel", version()},
          {"driver", context.device().name + ", OpenGL " + context.device().version},
          {"fingerprint", sim::probeNumerics().fingerprint},
          {"frames", scene.frameCount()},
          {"first", world.firstFrame()},
          {"steps", steps},
          {"arrays", arrayList(world)}};
}

void throwIfLost(sim::World& world) {
  world.startSummary();
  static_cast<void>(world.takeSummary(true));
}

void printFrames(sim::World& world, int last) {
  const auto names = world.arrays();
  for (int frame = world.firstFrame(); frame <= last; ++frame) {
    world.advanceTo(frame);
    world.startSummary();
    const auto summary = world.takeSummary(true);
    Json hashes = Json::object();
    for (std::size_t i = 0; i < names.size(); ++i)
      hashes[names[i].object + "." + names[i].array] = summary->arrays[i];
    if (!printLine({{"frame", frame}, {"arrays", hashes}})) return;
  }
}

void printSteps(sim::World& world, int frame) {
  if (frame <= world.firstFrame())
    fail(ExitCode::usage, "--steps-of {}: the first frame that is stepped to is {}", frame,
         world.firstFrame() + 1);
  world.advanceTo(frame - 1);
  bool heard = true;
  world.advanceTo(frame, [&](std::size_t object, int step) {
    gl::barrier();
    Json hashes = Json::object();
    for (const sim::StateArray& array : world.object(object).state()) {
      const auto words = array.buffer->readAll<std::uint32_t>();
      hashes[array.name] = hashHex(std::as_bytes(std::span(words)));
    }
    if (!hashes.empty() && heard)
      heard = printLine(
          {{"frame", frame}, {"object", world.objectName(object)}, {"step", step}, {"arrays", hashes}});
  });
  throwIfLost(world);
}

/// A line of JSON that names the arrays of one object and the user's names of some elements, then the
/// arrays: 32-bit words, little endian, four an element.
void dumpArrays(const sim::World& world, std::size_t object) {
  Json list = Json::array();
  for (const sim::StateArray& array : world.object(object).state())
    list.push_back({{"array", array.name}, {"elements", array.buffer->bytes() / 16}});
  if (!printLine({{"object", world.objectName(object)}, {"arrays", list}})) return;
  for (const sim::StateArray& array : world.object(object).state()) {
    const auto words = array.buffer->readAll<std::uint32_t>();
    if (std::fwrite(words.data(), 4, words.size(), stdout) != words.size())
      fail(ExitCode::inputOutput, "cannot write to standard output");
  }
}

void dump(sim::World& world, const TraceOptions& o) {
  int frame = 0, wanted = 0;
  const char* end = o.dump.data() + o.dump.size();
  const auto first = std::from_chars(o.dump.data(), end, frame);
  const bool colon = first.ec == std::errc() && first.ptr != end && *first.ptr == ':';
  const auto second = colon ? std::from_chars(first.ptr + 1, end, wanted) : first;
  if (!colon || second.ec != std::errc() || second.ptr != end)
    fail(ExitCode::usage, "--dump takes FRAME:STEP, for example 37:4, not \"{}\"", o.dump);
  std::optional<std::size_t> chosen;
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (!world.object(i).state().empty() && (o.object.empty() || world.objectName(i) == o.object)) {
      chosen = i;
      break;
    }
  if (!chosen) fail(ExitCode::usage, "--dump: the scene has no object \"{}\" with a state", o.object);
  // Step 0 of the first frame is the state that the run starts from.
  if (frame < world.firstFrame() || (frame == world.firstFrame() ? wanted != 0 : wanted < 1) ||
      wanted > world.object(*chosen).stepsPerFrame())
    fail(ExitCode::usage, "--dump {}: frames start at {}:0 and have the steps 1 to {}", o.dump,
         world.firstFrame(), world.object(*chosen).stepsPerFrame());
  if (frame == world.firstFrame()) return dumpArrays(world, *chosen);
  world.advanceTo(frame - 1);
  world.advanceTo(frame, [&](std::size_t object, int step) {
    if (object != *chosen || step != wanted) return;
    gl::barrier();
    dumpArrays(world, object);
  });
}

void trace(const TraceOptions& o) {
  const scene::Scene scene = o.scene.load();
  frame::ignoreBrokenPipes();
  const gl::Context context({.device = o.device, .debug = false, .memoryPath = o.memoryPath});
  sim::World world(scene);
  if (!o.dump.empty()) return dump(world, o);
  if (!printLine(header(world, context, scene))) return;
  if (o.stepsOf) return printSteps(world, *o.stepsOf);
  printFrames(world, o.last.value_or(scene.frameCount() - 1));
}

}  // namespace

void addTrace(CLI::App& app) {
  auto o = std::make_shared<TraceOptions>();
  auto* command =
      app.add_subcommand("trace", "Print the hashes of a run's state, frame by frame or step by step");
  o->scene.add(*command);
  command->add_option("--device", o->device, "Index or part of a name (see `simreel doctor`)");
  command->add_option("--memory-path", o->memoryPath,
                      "How kernels read: storage or texel (default: by driver)");
  command->add_option("--last", o->last, "Last frame (default: the scene's)")
      ->check(CLI::Range(0, 10'000'000));
  auto* steps = command->add_option("--steps-of", o->stepsOf, "Print each step of one frame instead");
  command
      ->add_option("--dump", o->dump, "FRAME:STEP: write the raw arrays after that step to standard output")
      ->excludes(steps);
  command->add_option("--object", o->object,
                      "Whose arrays --dump writes (default: the first with a state)");
  command->callback([o] { trace(*o); });
}

}  // namespace simreel::cli
