#include "frame/file/shared_manifest.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"

#include <exception>
#include <optional>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace simreel::frame {

namespace {

/// Returns the frame numbers to lock. For a single picture or a video, this is the number 0, because all
/// its frames are in one file.
std::vector<int> claimed(const OutputName& output, std::span<const int> frames) {
  if (output.kind != OutputName::Kind::sequence) return {0};
  return {frames.begin(), frames.end()};
}

std::string contentOf(const std::filesystem::path& file) {
  if (!pathExists(file)) return {};
  try {
    return readFile(file, "table of counts");
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace

SharedManifest::SharedManifest(const OutputName& output, const RunInfo& run, std::span<const int> frames)
    : output_(output),
      own_(frames.begin(), frames.end()),
      lock_(output.manifestFile(), runIdentity(run), claimed(output, frames),
            output.kind == OutputName::Kind::sequence ? std::filesystem::path() : output.file(0)),
      record_(beginRecord(run)) {
  others_.run = run;
}

std::map<int, ManifestFrame> SharedManifest::inherit(Existing existing) {
  known_ = versionOnDisk();
  std::optional<Manifest> old;
  try {
    old = readManifest(output_.manifestFile());
  } catch (const UserError& error) {
    if (existing == Existing::resume) warn("{}; all frames are drawn again", error.what());
    if (existing == Existing::skip) warn("{}", error.what());
  }
  if (!old) return {};
  if (const auto difference = runDifference(others_.run, old->run)) {
    if (existing == Existing::resume || existing == Existing::skip)
      fail(ExitCode::usage, "cannot {}: {} ({}); use --overwrite to start afresh",
           existing == Existing::resume ? "resume" : "skip existing frames", *difference,
           output_.manifestFile().string());
    return {};
  }
  others_.counts = old->counts;
  log_ = readRunLog(output_.runFile());
  std::map<int, ManifestFrame> own;
  for (auto& [number, frame] : old->frames) {
    if (number < 0 || frame.file != output_.fileName(number) || !pathExists(output_.file(number))) continue;
    if (own_.contains(number))
      own[number] = std::move(frame);
    else if (output_.kind == OutputName::Kind::sequence)
      others_.frames[number] = std::move(frame);
  }
  return own;
}

void SharedManifest::write(Manifest manifest, std::string_view counts) {
  const OutputLock::Shared shared(lock_);
  merge();
  std::exception_ptr failure;
  try {
    if (!counts.empty() && (!manifest.frames.empty() || !others_.frames.empty())) storeCounts(counts);
  } catch (const UserError&) {
    // The frames are complete nevertheless, so the manifest is still written.
    failure = std::current_exception();
  }
  try {
    if (output_.manifest) storeRuns(manifest);
  } catch (const UserError&) {
    if (!failure) failure = std::current_exception();
  }
  if (output_.manifest) store(std::move(manifest));
  if (failure) std::rethrow_exception(failure);
}

void SharedManifest::storeCounts(std::string_view counts) {
  const std::string present = contentOf(output_.countFile());
  if (present.starts_with(counts) && hashHex(present) == others_.counts) return;
  writeFileAtomically(output_.countFile(), counts, NameSync::later);
  others_.counts = hashHex(counts);
}

std::string SharedManifest::otherMachineOf(int frame) const {
  if (others_.run.exact()) return {};
  const std::string machine = log_.machineOf(frame);
  return machine == record_.machine() ? std::string() : machine;
}

void SharedManifest::storeScene() {
  if (std::exchange(hasScene_, true) || others_.run.asRun.empty()) return;
  writeFileAtomically(output_.sceneFile(), others_.run.asRun, NameSync::later);
}

/// Adds this run to run.json and keeps the records of other programs. Called before store(), so that a
/// manifest never exists without run.json.
void SharedManifest::storeRuns(const Manifest& manifest) {
  record_.frames.clear();
  for (const auto& [number, frame] : manifest.frames)
    if (frame.drawn) record_.frames.insert(number);
  if (record_.frames.empty()) return;
  record_.seconds = secondsSince(began_);
  RunLog log = readRunLog(output_.runFile());
  log.put(record_);
  writeFileAtomically(output_.runFile(), runLogText(log), NameSync::later);
}

SharedManifest::Version SharedManifest::versionOnDisk() const {
  struct stat status {};
  if (::stat(output_.manifestFile().c_str(), &status) != 0) return {};
  return {status.st_ino, status.st_ctim.tv_sec, status.st_ctim.tv_nsec};
}

void SharedManifest::merge() {
  const Version present = versionOnDisk();
  if (present == known_ || output_.kind != OutputName::Kind::sequence) return;
  known_ = present;
  try {
    auto found = readManifest(output_.manifestFile());
    if (!found || runDifference(others_.run, found->run)) return;
    others_.counts = found->counts;
    others_.frames.clear();
    for (auto& [number, frame] : found->frames) {
      if (!own_.contains(number)) others_.frames[number] = std::move(frame);
    }
  } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): an unreadable manifest is replaced.
  }
}

void SharedManifest::store(Manifest manifest) {
  manifest.counts = others_.counts;
  // insert() adds only frames that are not in the manifest yet.
  manifest.frames.insert(others_.frames.begin(), others_.frames.end());
  if (manifest.frames.empty()) return;
  storeScene();
  syncFolder(output_.folder);
  writeFileAtomically(output_.manifestFile(), manifestText(manifest));
  known_ = versionOnDisk();
}

}  // namespace simreel::frame
