#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/device_options.hpp"
#include "cli/scene_options.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/field_files.hpp"
#include "frame/sink/open_sink.hpp"
#include "frame/sink/progress.hpp"
#include "frame/sink/sequence.hpp"
#include "gl/context.hpp"
#include "gl/machine.hpp"
#include "sim/core/numerics.hpp"

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct RenderOptions {
  SceneOptions scene;
  std::string output;
  std::optional<std::string> frames;
  std::optional<std::string> fields;
  gl::ContextOptions on;
  std::string progress = "auto";
  std::string streamFormat = "rgba";
  bool overwrite = false;
  bool resume = false;
  bool skipExisting = false;
  bool noCounts = false;
  std::optional<double> checkpoint;
};

frame::Existing existingPolicy(const RenderOptions& o) {
  if (int{o.overwrite} + int{o.resume} + int{o.skipExisting} > 1)
    fail(ExitCode::usage, "--overwrite, --resume and --skip-existing exclude each other");
  return o.overwrite      ? frame::Existing::overwrite
         : o.resume       ? frame::Existing::resume
         : o.skipExisting ? frame::Existing::skip
                          : frame::Existing::error;
}

void render(const RenderOptions& o) {
  const auto began = Clock::now();
  const auto existing = existingPolicy(o);
  frame::Progress progress(frame::parseProgressMode(o.progress));
  const scene::Scene scene = o.scene.load();
  const auto frames = chosenFrames(o.frames, scene);
  // A senseless name fails before a device starts.
  const frame::OutputName output = frame::parseOutput(o.output, frames.size());
  std::optional<frame::FieldFiles> fields;
  if (o.fields) fields.emplace(output, frame::parseFieldFormat(*o.fields), existing, frames);
  if (o.checkpoint && output.checkpointFile().empty())
    fail(ExitCode::usage, "--checkpoint: a video or stream cannot be resumed; render a folder of pictures");
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();

  const gl::Context context(o.on);
  const auto numerics = sim::probeNumerics();
  requireExact(scene, numerics);
  const auto machine = gl::machineOf(context);
  const frame::RunInfo run{
      .title = scene.title,
      .sceneHash = scene.hash,
      .seed = scene.seed,
      .width = scene.render.size.x,
      .height = scene.render.size.y,
      .fps = scene.time.fps,
      .numerics = scene.numerics == scene::Numerics::exact ? "exact" : "fast",
      .fingerprint = numerics.fingerprint,
      .driver = machine.driver,
      .processor = machine.processor,
      .rasterizer = scene.render.rasterizer == scene::Rasterizer::exact ? "exact" : "driver",
      .overrides = scene.overrides,
  };
  const auto sink = frame::openSink(output, existing, run, frames, o.streamFormat);
  frame::BesideFrames beside;
  if (fields) beside.fields = &*fields;
  beside.counts = !o.noCounts;
  beside.began = began;
  beside.checkpoints.file = output.checkpointFile();
  beside.checkpoints.resume = existing == frame::Existing::resume;
  beside.checkpoints.run = run;
  if (o.checkpoint) beside.checkpoints.seconds = *o.checkpoint;
  frame::SequenceResult result;
  try {
    result = frame::renderSequence(scene, context, frames, *sink, progress, beside);
  } catch (const UserError& error) {
    const int signal = frame::interruptSignal();
    if (signal == 0 || error.code() != ExitCode::inputOutput) throw;
    printError(error);  // of its end: the cause is the signal
    return setExitCode(128 + signal);
  }
  info("{}", frame::closingLine(result.frames, result.seconds, result.stages, sink->summary()));
  if (result.signal != 0) {
    info("simreel: interrupted; what is listed in the manifest is whole, --resume goes on from there");
    setExitCode(128 + result.signal);
  }
}

}  // namespace

void addRender(CLI::App& app) {
  auto o = std::make_shared<RenderOptions>();
  auto* command = app.add_subcommand("render", "Render a scene to pictures or a video");
  o->scene.add(*command);
  command
      ->add_option("-o,--output", o->output,
                   "Folder, pattern (out/flag_####.png), picture, video file, or -")
      ->required();
  command->add_option("--frames", o->frames, "Frames to write, for example 0-99x2,150; all are simulated");
  command
      ->add_option("--fields", o->fields,
                   "Also the raw values of every field, beside each picture: npy or pfm")
      ->check(CLI::IsMember({"npy", "pfm"}));
  addDevice(*command, o->on);
  command->add_option("--progress", o->progress, "auto, tty, ndjson or none");
  command->add_option("--stream-format", o->streamFormat, "Of -o -: rgba or y4m")
      ->check(CLI::IsMember({"rgba", "y4m"}));
  command->add_flag("--overwrite", o->overwrite, "Replace frames that exist");
  command->add_flag("--resume", o->resume,
                    "Keep the frames that the manifest and their hashes say are whole, and go on from the "
                    "last checkpoint");
  command
      ->add_option(
          "--checkpoint", o->checkpoint,
          "Seconds after which the state is kept beside the frames, for --resume to go on from; 0: "
          "never (default: 60)")
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--skip-existing", o->skipExisting, "Keep every frame whose file exists");
  command->add_flag(
      "--no-counts", o->noCounts,
      "Do not write what epidemics, fires, fluids and water count (NAME.counts.csv beside the frames)");
  command->add_flag("--debug", o->on.debug, "Ask the driver for debug messages; serious ones are errors");
  command->callback([o] { render(*o); });
}

}  // namespace simreel::cli
