// simreel render --pieces, and simreel pieces, which runs the steps individually as a cluster does.
#include "cli/pieces.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "batch/pieces/join.hpp"
#include "batch/pieces/piece_plan.hpp"
#include "batch/pieces/piece_run.hpp"
#include "batch/render/scratch.hpp"
#include "batch/slurm/queue.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/job_count.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/output_name.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/progress.hpp"
#include "scene/as_run.hpp"
#include "scene/scene_source.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

void checkRequest(const PiecesRequest& request, const frame::OutputName& output) {
  const batch::RenderRequest& render = request.render;
  if (output.kind != frame::OutputName::Kind::sequence && output.kind != frame::OutputName::Kind::video)
    fail(ExitCode::usage, "--pieces makes a folder of pictures or a video, not {}", render.output);
  if (output.isLight())
    fail(ExitCode::usage, "--pieces makes PNG pictures or a video, not {}", render.output);
  if (!render.from.empty() || !render.checkpointAt.empty())
    fail(ExitCode::usage, "--pieces keeps its own checkpoints; leave out --from and --checkpoint-at");
  if (render.bits.value_or(8) != 8)
    fail(ExitCode::usage, "--bits {} has no effect with --pieces, which makes pictures of 8 bits",
         *render.bits);
  if (render.checkpoint)
    fail(ExitCode::usage, "--pieces keeps the state of each piece every 60 s; leave out --checkpoint");
  if (render.existing == frame::Existing::skip)
    fail(ExitCode::usage, "--pieces does not support --skip-existing; use --resume or --overwrite");
  if (output.kind == frame::OutputName::Kind::video && render.fields)
    fail(ExitCode::usage,
         "--fields: raw values are written beside pictures, and a video has no pictures; render a folder "
         "of pictures");
}

/// Throws UserError if an unfinished plan or an output file exists that the new plan would overwrite.
void refuseExisting(const batch::PiecePlan& plan, const frame::OutputName& output) {
  if (pathExists(plan.planFile()))
    fail(ExitCode::inputOutput, "{} belongs to pieces that were not joined; use --resume or --overwrite",
         plan.planFile().string());
  for (const int frame : plan.allFrames())
    if (pathExists(output.file(frame)))
      fail(ExitCode::inputOutput, "{} exists; use --overwrite", output.file(frame).string());
}

batch::PiecePlan planOf(const PiecesRequest& request) {
  batch::RenderJob job(request.render);  // The constructor throws on any error before any file is written.
  checkRequest(request, job.output());
  const batch::RenderRequest& render = request.render;
  batch::PiecePlan plan;
  plan.folder = job.output().piecesFolder();
  // The trailing slash marks a folder. Without it, parseOutput() would decide between file and folder by
  // what exists on disk at that time.
  plan.output = fs::absolute(render.output).lexically_normal().string();
  if (job.output().wholeFolder && !plan.output.ends_with('/')) plan.output += '/';
  if (render.input.file != "-")
    plan.assets.push_back(fs::absolute(render.input.file).lexically_normal().parent_path());
  for (const fs::path& folder : render.input.assets)
    plan.assets.push_back(fs::absolute(folder).lexically_normal());
  plan.overrides = render.input.overrides;
  plan.fields = render.fields.value_or("");
  plan.counts = render.counts;
  plan.pieces = batch::splitFrames(job.frames(), request.pieces);
  return plan;
}

/// True if an earlier run with --resume has finished, in which case its pieces have been removed.
bool isWhole(const batch::PiecePlan& plan, const PiecesRequest& request) {
  const frame::OutputName output = plan.wholeOutput();
  if (request.render.existing != frame::Existing::resume || !pathExists(output.manifestFile()))
    return false;
  try {
    const auto manifest = frame::readManifest(output.manifestFile());
    const std::string asRun = request.render.input.asRun(sim::kinds());
    if (!manifest || manifest->run.asRunHash != hashHex(asRun)) return false;
    const bool video = output.kind == frame::OutputName::Kind::video;
    const auto frames = plan.allFrames();
    return std::all_of(frames.begin(), frames.end(), [&](int number) {
      const auto frame = manifest->frames.find(number);
      if (frame == manifest->frames.end() || !pathExists(output.file(number))) return false;
      if (!plan.fields.empty() && frame->second.files.empty()) return false;
      return video || hashHex(readFile(output.file(number), "frame")) == frame->second.bytes;
    });
  } catch (const UserError&) {
    return false;
  }
}

void storePlan(const batch::PiecePlan& plan, const PiecesRequest& request,
               const frame::OutputName& output) {
  const std::string scene = scene::readSceneSource(request.render.input.file, sim::kinds()).first;
  const std::string text = planText(plan);
  if (request.render.existing == frame::Existing::resume && pathExists(plan.planFile())) {
    if (readFile(plan.planFile(), "plan") == text && readFile(plan.sceneFile(), "scene") == scene) return;
    fail(ExitCode::usage, "cannot resume: {} belongs to another run; use --overwrite to start afresh",
         plan.planFile().string());
  }
  if (request.render.existing == frame::Existing::error) refuseExisting(plan, output);
  std::error_code ignored;
  fs::remove_all(plan.folder, ignored);
  makeFolders(plan.folder);
  writeFileAtomically(plan.sceneFile(), scene);
  writeFileAtomically(plan.planFile(), text);
}

struct StepOptions {
  std::string folder;
  std::vector<std::size_t> pieces;
  gl::ContextOptions on;
  std::string progress = "auto";
  SlurmOptions cluster;
};

void endedBy(int signal) {
  if (signal == 0) return;
  info("simreel: interrupted; the same command goes on from there");
  setExitCode(128 + signal);
}

void simulate(const StepOptions& o) {
  const batch::PiecePlan plan = batch::readPiecePlan(o.folder);
  frame::Progress progress(frame::parseProgressMode(o.progress));
  frame::catchInterrupts();
  const gl::Context context(o.on);
  endedBy(batch::simulatePieces(plan, context, progress, commandLine()));
}

void draw(const StepOptions& o) {
  const batch::PiecePlan plan = batch::readPiecePlan(o.folder);
  for (const std::size_t piece : o.pieces)
    if (piece >= plan.pieces.size())
      fail(ExitCode::usage, "there is no piece {}; the sequence has 0 to {}", piece,
           plan.pieces.size() - 1);
  frame::Progress progress(frame::parseProgressMode(o.progress));
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const fs::path scratch = batch::scratchRoot(o.cluster.scratch);
  const gl::Context context(o.on);
  for (const std::size_t piece : o.pieces)
    if (const int signal = batch::drawPiece(plan, piece, context, progress, commandLine(), scratch);
        signal != 0)
      return endedBy(signal);
}

void joinAll(const batch::PiecePlan& plan) {
  try {
    batch::joinPieces(plan);
    info("{} frames of {} pieces -> {}", plan.allFrames().size(), plan.pieces.size(), plan.output);
  } catch (const frame::Interrupted& interrupted) {
    endedBy(interrupted.signal);
  }
}

void join(const StepOptions& o) {
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  joinAll(batch::readPiecePlan(o.folder));
}

/// Returns the manifest of an output whose pieces' folder was removed after joining. It is next to that
/// folder. Returns an empty text if there is no such manifest.
std::string joinedOutput(const std::string& folder) {
  fs::path pieces(folder);
  if (!pieces.has_filename()) pieces = pieces.parent_path();
  const std::string name = pieces.filename().string();
  constexpr std::string_view ending = "pieces";
  if (!name.ends_with(ending) || pathExists(pieces / "plan.json")) return {};
  const fs::path manifest =
      pieces.parent_path() / (name.substr(0, name.size() - ending.size()) + "manifest.json");
  return pathExists(manifest) ? manifest.string() : std::string();
}

fs::path slurmFolder(const batch::PiecePlan& plan) {
  return plan.folder / "slurm";
}

/// Prints the state of each piece. The exit code is 7 if every piece is drawn or queued and the cluster's
/// queue still holds jobs of the plan, 3 if other pieces are missing, and 0 if all pieces are drawn and no
/// jobs are left, or if the pieces are joined.
void status(const StepOptions& o) {
  if (const std::string whole = joinedOutput(o.folder); !whole.empty())
    return printText(fmt::format("all pieces are joined: {}\n", whole));
  const batch::PiecePlan plan = batch::readPiecePlan(o.folder);
  // Reads the queue before the pieces, because a piece may start between the two reads.
  const batch::SlurmQueue queue(slurmFolder(plan));
  std::size_t drawn = 0, queued = 0;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const bool whole = batch::isDrawn(plan, i);
    const bool waits = !whole && queue.has("draw", i);
    drawn += whole ? 1 : 0;
    queued += waits ? 1 : 0;
    const auto& frames = plan.pieces[i].frames;
    printText(fmt::format("{:04}  {:7}  frames {} to {}\n", i,
                          whole   ? "done"
                          : waits ? "queued"
                                  : "missing",
                          frames.front(), frames.back()));
  }
  const char* const states = batch::isSimulated(plan)   ? "there"
                             : queue.has("simulate", 0) ? "under way"
                                                        : "missing";
  printText(fmt::format("{} pieces: {} done{}, states {}\n", plan.pieces.size(), drawn,
                        queued > 0 ? fmt::format(", {} queued or being drawn", queued) : "", states));
  constexpr int underWay = 7;
  if (drawn + queued == plan.pieces.size() && !queue.empty()) return setExitCode(underWay);
  if (drawn < plan.pieces.size()) setExitCode(static_cast<int>(ExitCode::baselineMissing));
}

/// Submits three dependent jobs: the simulation, the pieces (which start from its states), and the join.
void submitPieces(const batch::PiecePlan& plan, const PiecesRequest& request) {
  batch::Slurm slurm = request.cluster.cluster(slurmFolder(plan));
  // A second job for the same piece would find the piece locked and fail.
  if (!batch::SlurmQueue(slurmFolder(plan)).empty())
    fail(ExitCode::usage,
         "{}: the cluster still has jobs of these pieces; wait for them or end them (scancel)",
         plan.folder.string());
  if (request.on.deviceCount() > 1)
    fail(ExitCode::usage, "--device {}: with --slurm the cluster gives each job its device",
         request.on.device);
  std::vector<std::string> device;
  if (!request.on.device.empty()) device.push_back("--device=" + request.on.device);
  if (!request.on.memoryPath.empty()) device.push_back("--memory-path=" + request.on.memoryPath);
  const std::string folder = fs::absolute(plan.folder).lexically_normal().string();
  batch::Slurm::Work simulation{
      .name = "simulate", .arguments = {"pieces", "simulate", folder}, .numbers = {}};
  batch::Slurm::Work drawing{.name = "draw", .arguments = {"pieces", "draw"}, .numbers = {}};
  for (batch::Slurm::Work* work : {&simulation, &drawing})
    work->arguments.insert(work->arguments.end(), device.begin(), device.end());
  for (const std::string& word : request.cluster.arguments()) drawing.arguments.push_back(word);
  drawing.arguments.push_back(folder);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    if (!batch::isDrawn(plan, i)) drawing.numbers.push_back(i);
  if (!batch::isSimulated(plan, true)) drawing.after = slurm.submit(simulation);
  batch::Slurm::Work join{.name = "join", .arguments = {"pieces", "join", folder}, .numbers = {}};
  if (!drawing.numbers.empty()) join.after = slurm.submit(drawing);
  const auto last = slurm.submit(join);
  info("{} pieces submitted, joined by job {}; see `simreel pieces status {}`", drawing.numbers.size(),
       last.front(), plan.folder.string());
}

}  // namespace

void renderInPieces(const PiecesRequest& request) {
  const batch::PiecePlan plan = planOf(request);
  const std::size_t workers = jobCount(request.jobs, request.on);
  const bool ndjson = frame::parseProgressMode(request.progress) == frame::Progress::Mode::ndjson;
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  if (isWhole(plan, request)) {
    info("all {} frames are there: {}", plan.allFrames().size(), plan.output);
    std::error_code ignored;
    fs::remove_all(plan.folder, ignored);
    return;
  }
  storePlan(plan, request, plan.wholeOutput());
  if (request.cluster.slurm) return submitPieces(plan, request);
  const batch::LocalPieces how{workers, request.on, ndjson, batch::scratchRoot(request.cluster.scratch),
                               commandLine()};
  if (const int signal = batch::makePieces(plan, how); signal != 0) {
    info("simreel: interrupted; --resume goes on from there");
    return setExitCode(128 + signal);
  }
  joinAll(plan);
}

void addPieces(CLI::App& app) {
  auto* pieces =
      app.add_subcommand("pieces", "Run the steps of `render --pieces` one by one, on any machines");
  pieces->require_subcommand(1);
  auto o = std::make_shared<StepOptions>();
  const auto add = [&](const char* name, const char* doc, void (*act)(const StepOptions&)) {
    auto* command = pieces->add_subcommand(name, doc);
    command->add_option("folder", o->folder, "Folder of the pieces, which holds plan.json: OUTPUT/pieces")
        ->required();
    command->callback([o, act] { act(*o); });
    return command;
  };
  const auto onDevice = [&](CLI::App* command) {
    addDevice(*command, o->on);
    command->add_option("--progress", o->progress, "auto, tty, ndjson or none");
  };
  onDevice(add("simulate", "Simulate, and keep the states at which pieces begin", simulate));
  auto* drawing = add("draw", "Draw pieces, or resume them", draw);
  drawing->add_option("pieces", o->pieces, "Numbers of the pieces, from 0")->required();
  onDevice(drawing);
  o->cluster.addScratch(*drawing);
  add("join", "Verify all pieces, and join them to one output", join);
  add("status", "Print which pieces are drawn", status);
}

}  // namespace simreel::cli
