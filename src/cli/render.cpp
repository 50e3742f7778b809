#include "api/rendering_state.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "cli/options/slurm_options.hpp"
#include "cli/pieces.hpp"
#include "frame/file/output_name.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"
#include "sim/automata/rule/cell_rule.hpp"
#include "sim/life/cell_pattern.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <simreel/simreel.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct RenderFlags {
  SceneOptions scene;
  std::string output;
  std::optional<std::string> rule;
  RenderOptions more;
  gl::ContextOptions on;
  std::string progress = "auto";
  bool overwrite = false;
  bool resume = false;
  bool skipExisting = false;
  bool noCounts = false, noManifest = false;
  std::optional<std::size_t> pieces;
  std::string jobs = "1";
  std::optional<std::string> streamFormat;
  SlurmOptions cluster;
};

Existing existingPolicy(const RenderFlags& o) {
  if (int{o.overwrite} + int{o.resume} + int{o.skipExisting} > 1)
    fail(ExitCode::usage, "--overwrite, --resume and --skip-existing exclude each other");
  return o.overwrite      ? Existing::overwrite
         : o.resume       ? Existing::resume
         : o.skipExisting ? Existing::skip
                          : Existing::error;
}

/// Adds --rule as overrides of the scene that is generated for a cell pattern.
void changeRule(const RenderFlags& o, std::vector<scene::Override>& changes) {
  const std::string& text = *o.rule;
  if (!sim::isPatternName(o.scene.file))
    fail(ExitCode::usage,
         "--rule needs a file of cells (.rle, .cells, .lif, .mc), not {}; change the rule of a scene with "
         "-D objects.NAME.life.rule=RULE",
         o.scene.file);
  sim::CellRule rule;
  if (const sim::RuleProblem problem = sim::parseCellRule(text, rule); !problem.message.empty())
    fail(ExitCode::usage, "--rule \"{}\", character {}: {}", text, problem.at + 1, problem.message);
  changes.push_back({"objects.cells.life.rule", "\"" + rule.text() + "\""});
  if (rule.states > 2) changes.push_back({"objects.cells.life.trail", "0"});
}

LoadOptions loadOptionsOf(const RenderFlags& o) {
  std::vector<scene::Override> overrides = o.scene.changes();
  if (o.rule) changeRule(o, overrides);
  LoadOptions load;
  for (const scene::Override& one : overrides) load.changes.push_back({one.path, one.value});
  for (const std::filesystem::path& folder : assetFolders(o.scene.assets))
    load.assets.push_back(folder.string());
  return load;
}

RenderOptions optionsOf(const RenderFlags& o) {
  RenderOptions options = o.more;
  // A model with an animation is rendered as a single picture if the output is a single picture file.
  const std::string ending = lowerExtension(o.output);
  if (sim::isMeshFile(o.scene.file) && !options.frames && !o.scene.turn &&
      (ending == ".png" || ending == ".exr") && o.output.find('#') == std::string::npos)
    options.frames = "0";
  options.existing = existingPolicy(o);
  options.counts = !o.noCounts;
  options.manifest = !o.noManifest;
  if (o.streamFormat) options.streamFormat = *o.streamFormat;
  options.command = commandLine();
  return options;
}

frame::StageTimes timesOf(const StageTimes& from) {
  return {.simulate = from.simulate,
          .draw = from.draw,
          .readBack = from.readBack,
          .encode = from.encode,
          .start = from.start,
          .wait = from.wait};
}

/// Returns events that a Progress shows. With --progress=ndjson, they include the results of the scene's
/// checks.
RenderEvents shownBy(frame::Progress& progress) {
  RenderEvents events;
  events.start = [&](int frames) { progress.start(frames); };
  events.prepare = [&](long done, long total) { progress.prepare(done, total); };
  events.frame = [&](int number, const StageTimes& stages) { progress.frame(number, timesOf(stages)); };
  events.counts = [&](int number, std::string_view names, std::string_view row) {
    progress.counts(number, names, row);
  };
  events.complete = [&] { progress.clear(); };
  events.end = [&](std::string_view status, const StageTimes& stages) {
    progress.finish(std::string(status).c_str(), timesOf(stages));
  };
  if (progress.tellsEvents())
    events.check = [&](const CheckResult& one) {
      progress.check(one.what, one.frame, one.value, one.passed);
    };
  return events;
}

/// Returns a sentence about the files of an interrupted run.
std::string leftBehind(const RenderFlags& o, const RenderResult& result) {
  if (result.frames == 0) return "interrupted before the first picture; nothing was drawn";
  if (o.output == "-") return fmt::format("interrupted after {} pictures", result.frames);
  if (frame::parseOutput(o.output, 1).kind == frame::OutputName::Kind::video)
    return fmt::format("interrupted; {} has the {} frames so far", o.output, result.frames);
  return o.noManifest ? "interrupted; the pictures that were written are whole"
                      : "interrupted; what is listed in the manifest is whole, --resume goes on from there";
}

void render(const RenderFlags& o) {
  if (o.pieces && o.noManifest)
    fail(ExitCode::usage,
         "--no-manifest: --pieces joins its pieces by their manifests; leave out one of both");
  if (o.streamFormat && o.output != "-")
    fail(ExitCode::usage, "--stream-format has no effect with --output {}; it is for -o -", o.output);
  const LoadOptions load = loadOptionsOf(o);
  const RenderOptions options = optionsOf(o);
  if (o.pieces)
    return renderInPieces({api::requestOf(api::inputOf(o.scene.file, {}, load), o.output, options),
                           *o.pieces, o.jobs, o.cluster, o.on, o.progress});
  frame::Progress progress(frame::parseProgressMode(o.progress));
  // The constructor throws for an invalid output name before a device starts.
  Rendering rendering(o.scene.file, o.output, options, load);
  frame::catchInterrupts();
  frame::interruptFrames();
  frame::ignoreBrokenPipes();

  const Device device = Device::open({o.on.device, o.on.memoryPath, true, o.on.debug});
  RenderResult result;
  try {
    result = rendering.run(device, shownBy(progress));
  } catch (const Error& error) {
    const int signal = frame::interruptSignal();
    if (signal == 0 || error.kind() != ErrorKind::inputOutput) throw;
    printError(userErrorOf(error));  // The signal caused the error, so the exit code contains its number.
    return setExitCode(128 + signal);
  }
  if (!result.interrupted || result.frames > 0)
    info("{}", frame::closingLine(result.frames, result.seconds, timesOf(result.stages), result.files));
  if (result.interrupted) {
    info("simreel: {}", leftBehind(o, result));
    setExitCode(128 + frame::interruptSignal());
  }
}

}  // namespace

void addRender(CLI::App& app) {
  auto o = std::make_shared<RenderFlags>();
  auto* command = app.add_subcommand("render", "Render a scene to pictures or a video");
  o->scene.add(*command);
  command
      ->add_option("-o,--output", o->output,
                   "Folder, pattern (out/flag_####.png), picture, video file, or -")
      ->required();
  command->add_option("--rule", o->rule,
                      "Rule for a file of cells, instead of its own, for example B2-a/S12; `simreel list "
                      "life` explains the notations");
  command->add_option("--frames", o->more.frames,
                      "Frames to write, for example 0-99x2,150 or last; all frames are simulated. A video "
                      "of every second frame "
                      "plays at the speed of the scene. none: draw nothing, for --checkpoint-at");
  command
      ->add_option(
          "--fields", o->more.fields,
          "Also write the raw values of fields beside each picture: of all, as npy or pfm, or of those "
          "that are named: NAME,... or pfm,NAME,...")
      ->type_name("{npy,pfm,NAME}");
  command
      ->add_option(
          "--layers", o->more.layers,
          "Layers of OpenEXR pictures (-o NAME_####.exr), besides the light (with bloom, before exposure, "
          "vignette, white balance and tone curve; premultiplied where there is alpha): depth (Z: m along "
          "the line of sight), position (P.X, P.Y, "
          "P.Z: m in the world), normal (N.X, N.Y, N.Z: in the world), albedo (albedo.R, .G, .B), uv "
          "(uv.U, .V: texture coordinates), velocity "
          "(velocity.X, .Y, .Z: m/s in the world), vector (vector.X, .Y: pixels back to the frame before), "
          "object (Cryptomatte), primitive (number of the triangle or ball in its object)")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>(draw::layerNames.begin(), draw::layerNames.end())));
  command
      ->add_option("--bits", o->more.bits,
                   "Bits of each number of a picture: PNG 8 (the default) or 16, which is not dithered; "
                   "OpenEXR 16 (the default) or 32 for light")
      ->check(CLI::IsMember({8, 16, 32}));
  addDevices(*command, o->on);
  command->add_option("--progress", o->progress, "auto, tty, ndjson or none");
  command
      ->add_option("--stream-format", o->streamFormat,
                   "Format of the stream that -o - writes (default: rgba)")
      ->check(CLI::IsMember({"rgba", "y4m"}));
  command->add_flag("--overwrite", o->overwrite, "Replace frames that exist");
  command->add_flag(
      "--resume", o->resume,
      "Keep the frames that are whole (the manifest has their hashes), and go on from the last checkpoint");
  command
      ->add_option("--checkpoint", o->more.checkpoint,
                   "Seconds between checkpoints of the state beside the frames, from which --resume goes "
                   "on; 0: none (default: 60)")
      ->check(CLI::Range(0.0, 1e6));
  command->add_option("--checkpoint-at", o->more.checkpointAt,
                      "Frames whose states are kept beside the pictures as checkpoint.000500 and so on, "
                      "for example 0,500,1000");
  command->add_option("--from", o->more.from,
                      "Begin at this checkpoint instead of at the scene's start; any run of the same "
                      "simulation can have written it");
  auto* pieces = command
                     ->add_option("--pieces", o->pieces,
                                  "Draw the sequence in this many pieces, --jobs of them at once, and join "
                                  "them; the bytes are the same as without")
                     ->check(CLI::Range(std::size_t{1}, std::size_t{10'000}));
  command->add_option("-j,--jobs", o->jobs, "Pieces at once; auto: one for each processor")
      ->capture_default_str();
  o->cluster.add(*command);
  for (const char* name : {"--jobs", "--slurm", "--scratch"}) command->get_option(name)->needs(pieces);
  command->add_flag("--skip-existing", o->skipExisting,
                    "Keep every whole picture of a frame, and draw empty or damaged ones again; frames of "
                    "another scene or size are an error");
  command->add_flag(
      "--no-manifest", o->noManifest,
      "Write the pictures without manifest.json, run.json and as-run.json beside them; the run "
      "cannot be resumed");
  command->add_flag(
      "--no-counts", o->noCounts,
      "Do not write the counts of epidemics, fires, fluids and water (NAME.counts.csv beside the frames)");
  command->add_flag("--debug", o->on.debug, "Ask the driver for debug messages; serious ones are errors")
      ->excludes(pieces);
  command->callback([o] { render(*o); });
}

}  // namespace simreel::cli
