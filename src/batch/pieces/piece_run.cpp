#include "batch/pieces/piece_run.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/workers.hpp"
#include "batch/pieces/piece_checks.hpp"
#include "batch/render/scratch.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/output_lock.hpp"
#include "frame/interrupt.hpp"
#include "gl/driver_threads.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace simreel::batch {

namespace {

/// Task of a worker process: the simulation, or one piece.
struct Step {
  std::optional<std::size_t> piece;  ///< index of the piece; nullopt for the simulation
  [[nodiscard]] std::string name() const { return piece ? fmt::format("piece {}", *piece) : "simulation"; }
};

int runStep(const PiecePlan& plan, const Step& step, const gl::Context& context, frame::Progress& progress,
            const LocalPieces& how) {
  return step.piece ? drawPiece(plan, *step.piece, context, progress, how.command, how.scratch)
                    : simulatePieces(plan, context, progress, how.command);
}

/// Runs steps in parallel. Throws the first error.
void runSteps(const PiecePlan& plan, const std::vector<Step>& steps, const LocalPieces& how) {
  WorkerPool force;
  force.workers = std::min(how.workers, steps.size());
  force.items = steps.size();
  gl::shareProcessors(force.workers);
  force.work = [&](WorkerLine& line) {
    const gl::Context context(how.on.ofWorker(line.place()));
    line.ready("");
    while (const auto task = line.next()) {
      frame::Progress progress(how.ndjson ? frame::Progress::Mode::ndjson : frame::Progress::Mode::none);
      progress.ofJob(steps[task->item].name());
      // The worker's answer is the exit code as one character, followed by the message.
      std::string answer = "0";
      try {
        if (const int signal = runStep(plan, steps[task->item], context, progress, how); signal != 0)
          throw frame::Interrupted{signal};
      } catch (const UserError& error) {
        if (frame::interruptSignal() != 0) throw frame::Interrupted{frame::interruptSignal()};
        answer = static_cast<char>('0' + static_cast<int>(error.code())) + std::string(error.what());
      }
      line.answer(task->item, answer);
    }
  };
  std::optional<UserError> mistake;
  const auto note = [&](std::size_t item, ExitCode code, const std::string& what) {
    if (!mistake) mistake.emplace(code, fmt::format("{}: {}", steps[item].name(), what));
  };
  force.ready = [](const std::string& /*text*/) {};
  force.done = [&](std::size_t item, const std::string& answer) {
    if (answer[0] == '0')
      info("{}: done", steps[item].name());
    else
      note(item, static_cast<ExitCode>(answer[0] - '0'), answer.substr(1));
  };
  force.lost = [&](std::size_t item, const Loss& loss) {
    note(item, ExitCode::device, "its process " + loss.how);
  };
  force.alone = [](std::size_t /*item*/) { return false; };
  force.interrupted = [] { return frame::interruptSignal(); };
  if (!steps.empty()) runWorkers(force);
  if (mistake && frame::interruptSignal() == 0) throw UserError(*mistake);
}

void requireState(const PiecePlan& plan, const std::filesystem::path& checkpoint) {
  if (checkpoint.empty()) return;
  try {
    static_cast<void>(frame::Checkpoint::load(checkpoint));
  } catch (const UserError& error) {
    fail(error.code(), "{}; `simreel pieces simulate {}` makes it again", error.what(),
         plan.folder.string());
  }
}

/// Locks a piece in the shared folder. A lock in a scratch folder would not be visible to other machines.
frame::OutputLock lockOf(const std::filesystem::path& folder, std::size_t piece) {
  constexpr std::array all{0};
  try {
    return {folder / "piece", std::to_string(piece), all};
  } catch (const UserError&) {
    if (!frame::isOutputLocked(folder / "piece")) throw;
    fail(ExitCode::inputOutput, "piece {} is in use by another simreel process", piece);
  }
}

}  // namespace

bool isSimulated(const PiecePlan& plan, bool read) {
  for (std::size_t i = 1; i < plan.pieces.size(); ++i) {
    const auto checkpoint = plan.drawing(i, "").from;
    if (!pathExists(checkpoint)) return false;
    if (!read) continue;
    try {
      static_cast<void>(frame::Checkpoint::load(checkpoint));
    } catch (const UserError&) {
      return false;
    }
  }
  return true;
}

bool isDrawn(const PiecePlan& plan, std::size_t piece) {
  try {
    const auto manifest = frame::readManifest(plan.pieceOutput(piece).manifestFile());
    const auto& frames = plan.pieces[piece].frames;
    return manifest && std::all_of(frames.begin(), frames.end(),
                                   [&](int frame) { return manifest->frames.contains(frame); });
  } catch (const UserError&) {
    return false;
  }
}

int simulatePieces(const PiecePlan& plan, const gl::Context& context, frame::Progress& progress,
                   const std::string& command) {
  if (plan.pieces.size() < 2) return 0;
  RenderJob job(plan.simulation(command));
  auto checks = checksOfSimulation(plan, job.scene(), progress);
  return job.run(context, progress, Clock::now(), checks ? &*checks : nullptr).signal;
}

int drawPiece(const PiecePlan& plan, std::size_t piece, const gl::Context& context,
              frame::Progress& progress, const std::string& command, const std::filesystem::path& scratch) {
  RenderRequest request = plan.drawing(piece, command);
  requireState(plan, request.from);
  const std::filesystem::path folder = plan.pieceOutput(piece).folder;
  makeFolders(folder);
  const frame::OutputLock lock = lockOf(folder, piece);
  Scratch place(folder, scratch);
  // The output keeps the file name of a pattern such as frame_####.png.
  const std::string name = std::filesystem::path(request.output).filename().string();
  request.output = name.empty() ? place.folder().string() + "/" : (place.folder() / name).string();
  int signal = 0;
  try {
    RenderJob job(std::move(request));
    auto checks = checksOfPiece(plan, piece, job.scene(), progress);
    signal = job.run(context, progress, Clock::now(), checks ? &*checks : nullptr).signal;
  } catch (...) {
    place.deliver();
    throw;
  }
  place.deliver();
  return signal;
}

int makePieces(const PiecePlan& plan, const LocalPieces& how) {
  // The first piece needs no checkpoint, so it is drawn while the simulation runs.
  std::vector<Step> first, rest;
  if (!isSimulated(plan, true)) first.push_back({});
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    if (!isDrawn(plan, i)) (i == 0 ? first : rest).push_back({i});
  runSteps(plan, first, how);
  if (frame::interruptSignal() == 0) runSteps(plan, rest, how);
  return frame::interruptSignal();
}

}  // namespace simreel::batch
