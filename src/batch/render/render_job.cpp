#include "batch/render/render_job.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "batch/render/chosen_frames.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/file/manifest.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/open_sink.hpp"
#include "gl/machine.hpp"
#include "scene/as_run.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <utility>

namespace simreel::batch {

namespace fs = std::filesystem;

RenderJob::RenderJob(RenderRequest request)
    : request_(std::move(request)),
      scene_(request_.input.load(sim::kinds())),
      asRun_(request_.input.asRun(sim::kinds())) {
  chooseFrames();
  output_ = frame::parseOutput(request_.output, frames_.size());
  chooseManifest();
  const bool stream = output_.kind == frame::OutputName::Kind::stream;
  if (scene_.render.transparent &&
      (output_.kind == frame::OutputName::Kind::video || (stream && request_.streamFormat != "rgba")))
    fail(ExitCode::usage,
         "--output {}: {} has no alpha channel for render.transparent; write pictures, or render with -D "
         "render.transparent=false",
         request_.output, stream ? "y4m" : "a video");
  chooseLayers();
  if (request_.fields)
    fields_.emplace(output_, frame::parseFieldChoice(*request_.fields), request_.existing, frames_);
  chooseCheckpoints();
  // The output is checked before a device starts and before any simulation that places the camera.
  frame::checkOutput(output_, request_.existing, frames_);
}

void RenderJob::chooseManifest() {
  output_.manifest = request_.manifest;
  if (request_.manifest) return;
  if (request_.existing == frame::Existing::resume || request_.existing == frame::Existing::skip)
    fail(ExitCode::usage, "--no-manifest: {} needs the manifest; leave out one of the two",
         request_.existing == frame::Existing::resume ? "--resume" : "--skip-existing");
  if (const fs::path old = output_.manifestFile();
      !old.empty() && pathExists(old) && !frame::isForeignManifest(old))
    fail(
        ExitCode::inputOutput,
        "--no-manifest: {} lists earlier frames and would no longer be true; delete it first, or leave out "
        "--no-manifest",
        old.string());
}

void RenderJob::chooseLayers() {
  const int bits = request_.bits.value_or(output_.isLight() ? 16 : 8);
  if (!output_.isLight()) {
    if (!request_.layers.empty())
      fail(ExitCode::usage, "--layers: only OpenEXR pictures have layers; use --output NAME_####.exr");
    if (bits == 8) return;
    const bool picture =
        output_.kind != frame::OutputName::Kind::video && output_.kind != frame::OutputName::Kind::stream;
    if (bits != 16 || !picture)
      fail(ExitCode::usage, "--bits {}: {}", bits,
           picture ? "PNG pictures have 8 or 16 bits; for 32 bits, write OpenEXR"
                   : "videos and streams have 8 bits");
    if (scene_.render.rasterizer != scene::Rasterizer::exact)
      fail(ExitCode::usage, "--bits 16: more than 8 bits need \"rasterizer\": \"exact\"");
    layers_ = draw::LightRequest{{}, true, 16};
    return;
  }
  if (bits == 8) fail(ExitCode::usage, "--bits 8: OpenEXR pictures have 16 or 32 bits");
  if (scene_.render.rasterizer != scene::Rasterizer::exact)
    fail(ExitCode::usage, "--output {}: OpenEXR pictures need \"rasterizer\": \"exact\"", request_.output);
  layers_ = draw::LightRequest{request_.layers, false, bits};
}

void RenderJob::chooseFrames() {
  if (request_.frames == "none") {
    if (request_.checkpointAt.empty())
      fail(ExitCode::usage, "--frames none draws nothing; name the states to keep: --checkpoint-at 0,500");
    const char* const idle = request_.fields            ? "--fields"
                             : !request_.layers.empty() ? "--layers"
                             : request_.bits            ? "--bits"
                                                        : nullptr;
    if (idle != nullptr) fail(ExitCode::usage, "{} has no effect with --frames none; leave it out", idle);
    return;
  }
  if (request_.from.empty() || request_.checkpointOptional) {
    frames_ = chosenFrames(request_.frames, scene_);
    return;
  }
  const int first = frame::Checkpoint::load(request_.from).frame();
  frames_ = chosenFrames(request_.frames, scene_);
  if (!request_.frames) std::erase_if(frames_, [&](int frame) { return frame < first; });
  if (frames_.empty() || frames_.front() < first)
    fail(ExitCode::usage,
         "--from {}: the checkpoint is of frame {}, but {}; choose other frames with --frames {}-...",
         request_.from.string(), first,
         frames_.empty() ? fmt::format("the scene ends before, at {}", scene_.frameCount() - 1)
                         : fmt::format("frame {} lies before it", frames_.front()),
         first);
}

void RenderJob::chooseCheckpoints() {
  const bool none = output_.checkpointFile().empty();
  if (none && (request_.checkpoint || !request_.checkpointAt.empty()))
    fail(ExitCode::usage, "{}: {} cannot be resumed; {}",
         request_.checkpoint ? "--checkpoint" : "--checkpoint-at",
         output_.manifest ? "a video or stream" : "a run without a manifest",
         output_.manifest ? "render a folder of pictures" : "leave out --no-manifest");
  for (const int frame : request_.checkpointAt) {
    const fs::path file = output_.checkpointFile(frame);
    if (request_.existing == frame::Existing::error && pathExists(file))
      fail(ExitCode::inputOutput, "{} exists; use --overwrite or --resume", file.string());
    kept_[frame] = file;
  }
  if (!kept_.empty()) warnBeyondEnd(kept_.rbegin()->first, scene_);
}

/// Places the camera and measures ranges of colours by simulating the whole scene, independently of the
/// frames that are drawn.
void RenderJob::placeCamera() {
  if (frames_.empty()) return;
  const sim::MotionFraming framing = sim::frameMotion(scene_, frame::throwIfInterrupted);
  camera_ = framing.camera;
  camera_.insert(camera_.end(), framing.ranges.begin(), framing.ranges.end());
  for (const std::string& remark : {framing.remark, framing.rangeRemark})
    if (!remark.empty()) info("{}", remark);
}

frame::RunInfo RenderJob::runInfo(const gl::Context& context, const sim::Numerics& numerics) const {
  const auto machine = gl::machineOf(context);
  std::vector<std::string> folders;
  if (request_.input.file != "-")
    folders.push_back(fs::absolute(request_.input.file).lexically_normal().parent_path().string());
  for (const fs::path& folder : request_.input.assets)
    folders.push_back(fs::absolute(folder).lexically_normal().string());
  return {
      .title = scene_.title,
      .sceneHash = scene_.hash,
      .seed = scene_.seed,
      .width = scene_.render.size.x,
      .height = scene_.render.size.y,
      .fps = scene_.time.fps,
      .numerics = scene_.numerics == scene::Numerics::exact ? "exact" : "fast",
      .fingerprint = numerics.fingerprint,
      .driver = machine.driver,
      .processor = machine.processor,
      .rasterizer = scene_.render.rasterizer == scene::Rasterizer::exact ? "exact" : "driver",
      .overrides = scene_.overrides,
      .camera = camera_,
      .simulation = hashHex(scene::simulationHash(asRun_) + scene_.filesHash),
      .asRun = asRun_,
      .asRunHash = hashHex(asRun_),
      .command = request_.command,
      .folders = std::move(folders),
  };
}

frame::SequenceResult RenderJob::run(const gl::Context& context, frame::RunListener& progress,
                                     Clock::time_point began, frame::FrameWatch* watch) {
  const sim::Numerics numerics = sim::probeNumerics();
  sim::requireExact(scene_, numerics);
  try {
    placeCamera();
  } catch (const frame::Interrupted& interrupted) {
    frame::SequenceResult none;
    none.signal = interrupted.signal;
    none.seconds = secondsSince(began);
    return none;
  }
  const frame::RunInfo run = runInfo(context, numerics);
  const auto sink = frame::openSink(output_, request_.existing, run, frames_, request_.streamFormat);
  frame::SequenceOptions beside;
  if (fields_) beside.fields = &*fields_;
  beside.counts = request_.counts;
  beside.began = began;
  beside.checkpoints.file = output_.checkpointFile();
  beside.checkpoints.resume = request_.existing == frame::Existing::resume;
  beside.checkpoints.run = run;
  beside.checkpoints.keep = kept_;
  beside.checkpoints.from = request_.from;
  beside.checkpoints.checkpointOptional = request_.checkpointOptional;
  if (request_.checkpoint) beside.checkpoints.seconds = *request_.checkpoint;
  beside.watch = watch;
  beside.layers = layers_;
  auto result = frame::renderSequence(scene_, context, frames_, *sink, progress, beside);
  summary_ = sink->summary();
  return result;
}

}  // namespace simreel::batch
