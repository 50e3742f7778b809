// simreel trace: prints hashes of the state for each frame or step, or dumps the state itself.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "batch/render/chosen_frames.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "frame/frames_spec.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/stream_sink.hpp"
#include "gl/context.hpp"
#include "gl/machine.hpp"
#include "golden/trace/passes.hpp"
#include "golden/trace/stream.hpp"
#include "sim/core/numerics.hpp"
#include "sim/world/survey.hpp"

#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <signal.h>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct TraceOptions {
  SceneOptions scene;
  gl::ContextOptions on;
  std::optional<std::string> frames, dump, output;
  std::optional<int> stepsOf;
  bool passes = false;
};

struct Range {
  int first, last;
};

void checkFrame(int frame, int first) {
  if (frame < first)
    fail(ExitCode::usage, "there is no frame {}: the scene starts at frame {}", frame, first);
  if (frame > frame::largestFrame)
    fail(ExitCode::usage, "frame {} is above the largest, {}", frame, frame::largestFrame);
}

/// Parses a frame range such as "all", "7", "0-99", "-30-99" or "start-99". Frames before 0 belong to the
/// pre-roll.
Range parseRange(const std::string& text, int firstFrame, int frameCount) {
  if (text == "all") return {firstFrame, frameCount - 1};
  std::string_view rest = text;
  std::optional<int> first;
  if (rest.starts_with("start")) {
    rest.remove_prefix(5);
    first = firstFrame;
  } else {
    first = takeInteger(rest);
  }
  std::optional<int> last = first;
  if (rest.starts_with('-')) {
    rest.remove_prefix(1);
    last = takeInteger(rest);
  }
  if (!first || !last || !rest.empty())
    fail(ExitCode::usage,
         "--frames takes all, one frame, or a range such as 0-99, -30-99 or start-99, not \"{}\"", text);
  if (*last < *first) fail(ExitCode::usage, "--frames {}: the range runs backwards", text);
  checkFrame(*first, firstFrame);
  checkFrame(*last, firstFrame);
  return {*first, *last};
}

/// Returns the frame number in a text such as "37:passes", or nullopt for other text.
std::optional<int> parsePasses(const std::string& text) {
  std::string_view rest = text;
  const auto frame = takeInteger(rest);
  if (!frame || rest != ":passes") return std::nullopt;
  checkFrame(*frame, 0);
  return frame;
}

/// Parses "37:4" into frame and step.
std::pair<int, int> parseStep(const std::string& text, int firstFrame) {
  const auto frameAndStep = integerPair(text, ':');
  if (!frameAndStep)
    fail(ExitCode::usage, "--dump takes FRAME:STEP or FRAME:passes, for example 37:4, not \"{}\"", text);
  checkFrame(frameAndStep->first, firstFrame);
  return *frameAndStep;
}

/// Writes bytes to standard output without buffering. Returns false if the reader closed the pipe. The
/// caller must then stop writing.
bool putOut(std::span<const std::byte> bytes) {
  const int error = frame::writeAll(STDOUT_FILENO, bytes);
  if (error == 0) return true;
  if (error != EPIPE)
    fail(ExitCode::inputOutput, "cannot write to standard output: {}", std::strerror(error));
  setExitCode(128 + SIGPIPE);
  return false;
}

bool putLine(const std::string& line) {
  const std::string whole = line + "\n";
  return putOut(std::as_bytes(std::span(whole.data(), whole.size())));
}

void checkOptions(const TraceOptions& o) {
  if (int{o.frames.has_value()} + int{o.stepsOf.has_value()} + int{o.dump.has_value()} > 1)
    fail(ExitCode::usage, "--frames, --steps-of and --dump exclude each other");
  if (o.dump && !o.output)
    fail(ExitCode::usage, "--dump writes raw numbers; say where: -o FILE, or -o - for standard output");
  if (o.output && !o.dump) fail(ExitCode::usage, "-o needs --dump; add --dump FRAME:STEP");
  if (o.passes && (o.stepsOf || o.dump))
    fail(ExitCode::usage, "--passes works on whole frames; use it with --frames");
}

golden::TraceHeader header(const sim::World& world, const gl::Context& context) {
  golden::TraceHeader result;
  result.run = golden::describeWorld(world);
  const auto numerics = sim::probeNumerics();
  result.version = version();
  result.driver = gl::machineOf(context).driver;
  result.fingerprint = numerics.fingerprint;
  result.memoryPath = gl::memoryPath() == gl::MemoryPath::texel ? "texel" : "storage";
  if (!numerics.exactHolds) result.inexact = numerics.firstFailure;
  return result;
}

void writeDump(const TraceOptions& o, const std::vector<std::byte>& bytes) {
  if (*o.output == "-")
    (void)putOut(bytes);
  else
    writeFileAtomically(*o.output, bytes);
}

void trace(const TraceOptions& o) {
  checkOptions(o);
  scene::Scene scene = o.scene.load();
  frame::ignoreBrokenPipes();
  const gl::Context context(o.on);
  if (o.passes || o.dump) static_cast<void>(sim::frameMotion(scene));
  sim::World world(scene);
  const int first = world.firstFrame();
  if (o.dump) {
    if (const auto frame = parsePasses(*o.dump))
      return golden::drawPasses(scene, world, std::span(&*frame, 1), [&](const golden::PassDump& drawn) {
        writeDump(o, golden::encodePasses(drawn));
      });
    const auto [frame, step] = parseStep(*o.dump, first);
    return writeDump(o, golden::encodeDump(golden::dumpState(world, frame, step)));
  }
  if (o.stepsOf) {
    checkFrame(*o.stepsOf, first);
    if (*o.stepsOf == first)
      fail(ExitCode::usage, "frame {} is the initial state, so it has no steps; choose a later frame",
           first);
    if (putLine(golden::headerLine(header(world, context)))) golden::traceSteps(world, *o.stepsOf, putLine);
    return;
  }
  const Range range = parseRange(o.frames.value_or("all"), first, scene.frameCount());
  batch::warnBeyondEnd(range.last, scene);
  if (putLine(golden::headerLine(header(world, context))))
    golden::traceFrames(world, range.first, range.last, putLine, o.passes ? &scene : nullptr);
}

}  // namespace

void addTrace(CLI::App& app) {
  auto o = std::make_shared<TraceOptions>();
  auto* command = app.add_subcommand("trace", "Print hashes of the state, frame by frame or step by step");
  o->scene.add(*command);
  command->add_option(
      "--frames", o->frames,
      "all (default), one frame, or a range; frames below 0 are the pre-roll: --frames=-30-99");
  command->add_option("--steps-of", o->stepsOf, "Print one line for each step of this frame instead");
  command->add_option("--dump", o->dump,
                      "Write data instead. FRAME:STEP: the state after that step, as float32 after a line "
                      "of JSON; FRAME:passes: the buffers of the passes of its exact picture");
  command->add_flag("--passes", o->passes,
                    "Print hashes of the passes of each frame's exact picture, too: visibility, shadow, "
                    "light, glow, bloom, picture");
  command->add_option("-o,--output", o->output, "File that --dump writes, or -");
  addDevice(*command, o->on);
  command->callback([o] { trace(*o); });
}

}  // namespace simreel::cli
