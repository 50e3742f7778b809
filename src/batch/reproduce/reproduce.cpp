#include "batch/reproduce/reproduce.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "batch/render/render_job.hpp"
#include "batch/slurm/slurm.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/run_log.hpp"
#include "frame/image.hpp"
#include "frame/png_text.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <stdlib.h>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;

/// Known facts about the frame to be rendered again.
struct Wanted {
  int frame = 0;
  std::string program, sceneHash, state, pixels;
  std::string drawn;  ///< hash of the pixels in the picture file; empty if no picture was given
  std::optional<frame::RunInfo> run;  ///< run in the manifest, if a manifest exists
  frame::RunRecord record;            ///< record of the process that drew the frame, if it is known
  std::vector<std::string> overrides;
  fs::path asRun;  ///< scene as run; empty if it is not in the picture's folder
};

/// Returns the path of another file of a manifest's output. The file's name ends in `ending` instead of
/// "manifest.json".
fs::path besideManifest(const fs::path& manifest, const std::string& ending) {
  constexpr std::string_view own = "manifest.json";
  const std::string name = manifest.filename().string();
  return manifest.parent_path() / (name.substr(0, name.size() - own.size()) + ending);
}

bool isManifestName(const fs::path& file) {
  return file.filename().string().ends_with("manifest.json");
}

/// Returns the program version in a manifest file. frame::Manifest does not contain it.
std::string programOf(const fs::path& manifest) {
  try {
    const auto json = parseStrictJson(readFile(manifest, "manifest"));
    return JsonValue(json).at("program").text();
  } catch (const JsonError&) {
    return {};
  }
}

void takeManifest(const fs::path& file, const frame::Manifest& manifest, int number, Wanted& wanted) {
  const frame::ManifestFrame& frame = manifest.frames.at(number);
  wanted.frame = number;
  wanted.program = programOf(file);
  wanted.sceneHash = manifest.run.sceneHash;
  wanted.state = frame.state;
  wanted.pixels = frame.pixels;
  wanted.run = manifest.run;
  wanted.overrides = manifest.run.overrides;
  for (const frame::RunRecord& record : frame::readRunLog(besideManifest(file, "run.json")).runs)
    if (record.frames.contains(number)) wanted.record = record;
  if (const fs::path scene = besideManifest(file, "as-run.json"); pathExists(scene)) wanted.asRun = scene;
}

/// Returns the manifest in the picture's folder that lists the picture, and the frame's number.
std::optional<std::pair<fs::path, int>> manifestFor(const fs::path& picture, frame::Manifest& found) {
  std::error_code error;
  const fs::path folder = picture.parent_path().empty() ? fs::path(".") : picture.parent_path();
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!isManifestName(entry.path())) continue;
    try {
      auto manifest = frame::readManifest(entry.path());
      for (const auto& [number, frame] : manifest->frames)
        if (frame.file == picture.filename().string()) {
          found = std::move(*manifest);
          return std::pair(entry.path(), number);
        }
    } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): another manifest may list it.
    }
  }
  return std::nullopt;
}

/// Returns the path of the manifest. This is `file` itself, or the manifest of the folder or video `file`.
/// Returns an empty path for a picture.
fs::path manifestNamed(const fs::path& file) {
  if (isManifestName(file)) return file;
  std::error_code error;
  if (fs::is_directory(file, error)) return file / "manifest.json";
  const fs::path beside = file.string() + ".manifest.json";
  return pathExists(beside) ? beside : fs::path();
}

Wanted wantedOf(const ReproduceRequest& request) {
  Wanted wanted;
  if (const fs::path file = manifestNamed(request.file); !file.empty()) {
    const auto manifest = frame::parseManifest(readFile(file, "manifest"), file.string());
    if (manifest.frames.empty()) fail(ExitCode::usage, "manifest {} lists no frame", file.string());
    const int number = request.frame.value_or(manifest.frames.rbegin()->first);
    if (!manifest.frames.contains(number))
      fail(ExitCode::usage, "manifest {} has no frame {}", file.string(), number);
    takeManifest(file, manifest, number, wanted);
    return wanted;
  }
  if (request.frame) fail(ExitCode::usage, "--frame needs a manifest; a picture has only one frame");
  const std::string bytes = readFile(request.file, "picture");
  const auto file = std::as_bytes(std::span(bytes));
  std::map<std::string, std::string> texts;
  for (auto& [keyword, text] : frame::readPngText(file)) texts[keyword] = std::move(text);
  if (!texts.contains("simreel:frame") || !texts.contains("simreel:scene"))
    fail(ExitCode::usage, "{} is not a picture that simreel rendered: it does not name its scene and frame",
         request.file.string());
  wanted.drawn = frame::pixelHash(frame::decodeImage(file, request.file.string()));
  frame::Manifest manifest;
  if (const auto place = manifestFor(request.file, manifest)) {
    takeManifest(place->first, manifest, place->second, wanted);
    return wanted;
  }
  std::string_view number = texts["simreel:frame"];
  const auto frame = takeInteger(number);
  if (!frame || *frame < 0 || !number.empty())
    fail(ExitCode::usage, "{} names the frame \"{}\", which is not a number", request.file.string(),
         texts["simreel:frame"]);
  wanted.frame = *frame;
  wanted.program = texts["Software"].substr(std::min<std::size_t>(8, texts["Software"].size()));
  wanted.sceneHash = texts["simreel:scene"];
  wanted.state = texts["simreel:state"];
  wanted.pixels = wanted.drawn;
  wanted.record.driver = texts["simreel:driver"];
  const auto words = shellWords(texts["simreel:overrides"]);
  for (std::size_t i = 1; i < words.size(); i += 2) wanted.overrides.push_back(words[i]);
  return wanted;
}

/// Output folder. It is temporary unless the user names one.
class Place {
 public:
  explicit Place(const fs::path& kept) : path_(kept), kept_(!kept.empty()) {
    if (kept_) {
      makeFolders(path_);
      return;
    }
    std::string name = (fs::temp_directory_path() / "simreel-again-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      fail(ExitCode::inputOutput, "cannot create a folder in {}", fs::temp_directory_path().string());
    path_ = name;
  }
  ~Place() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  Place(Place&&) = delete;
  Place& operator=(Place&&) = delete;
  [[nodiscard]] std::string output() const { return path_.string() + "/"; }
  [[nodiscard]] fs::path manifest() const { return path_ / "manifest.json"; }
  [[nodiscard]] fs::path runs() const { return path_ / "run.json"; }

 private:
  fs::path path_;
  bool kept_;
};

RenderRequest renderingOf(const ReproduceRequest& request, const Wanted& wanted, const Place& place) {
  RenderRequest render;
  if (request.scene.empty() && wanted.asRun.empty())
    fail(ExitCode::usage,
         "no as-run.json beside {}; give the scene with --scene FILE (changes of its values are recorded)",
         request.file.string());
  render.input.file = request.scene.empty() ? wanted.asRun : request.scene;
  if (!request.scene.empty())
    for (const std::string& change : wanted.overrides)
      render.input.overrides.push_back(scene::parseOverride(change));
  render.input.assets = request.assets;
  render.output = place.output();
  render.frames = std::to_string(wanted.frame);
  render.existing = frame::Existing::overwrite;
  render.counts = false;
  render.checkpoint = 0;
  return render;
}

/// Returns the folders named in run.json as command-line arguments for a message. They are not read
/// automatically, because run.json may come from an untrusted source.
std::string assetWords(const ReproduceRequest& request, const Wanted& wanted) {
  std::string words;
  for (const std::string& folder : wanted.record.folders)
    if (std::error_code error; request.assets.empty() && fs::is_directory(folder, error))
      words += " --assets " + inShellQuotes(folder);
  return words;
}

/// Adds possible causes of differences if the results differ. If the results are equal, still adds the
/// differences in origin.
void compareOrigins(const ReproduceRequest& request, const Wanted& wanted, const frame::Manifest& again,
                    const frame::RunLog& log, Reproduction& result) {
  const auto say = [&](std::string line) { result.differences.push_back(std::move(line)); };
  if (!wanted.program.empty() && wanted.program != version())
    say(fmt::format("version: simreel {} made it, this is {}", wanted.program, version()));
  if (!request.scene.empty() && again.run.sceneHash != wanted.sceneHash)
    say(fmt::format("scene: {} is not the scene of the picture, or its overrides differ",
                    request.scene.string()));
  if (request.scene.empty() && wanted.run && !wanted.run->asRunHash.empty() &&
      hashHex(readFile(wanted.asRun, "scene")) != wanted.run->asRunHash)
    say(fmt::format("scene: {} was changed afterwards", wanted.asRun.string()));
  if (!wanted.drawn.empty() && wanted.drawn != wanted.pixels)
    say(fmt::format("picture: {} was changed after it was made", request.file.string()));
  if (again.run.exact() || log.runs.empty()) return;
  const frame::RunRecord& here = log.runs.front();
  if (wanted.run && wanted.run->fingerprint != again.run.fingerprint)
    say(fmt::format("numerics: its driver's fingerprint was {}, this one's is {}", wanted.run->fingerprint,
                    again.run.fingerprint));
  if (!wanted.record.driver.empty() && wanted.record.driver != here.driver)
    say(fmt::format("driver: it was {}, and is {} here", wanted.record.driver, here.driver));
  if (!wanted.record.processor.empty() && wanted.record.processor != here.processor)
    say(fmt::format("processor: it was {}, and is {} here", wanted.record.processor, here.processor));
}

}  // namespace

Reproduction reproduce(const ReproduceRequest& request) {
  const Wanted wanted = wantedOf(request);
  const Place place(request.output);
  std::optional<RenderJob> job;
  try {
    job.emplace(renderingOf(request, wanted, place));
  } catch (const UserError&) {
    if (const std::string words = assetWords(request, wanted); !words.empty())
      info(
          "run.json names folders from which the scene read files. If you trust the author of run.json, "
          "allow these folders with:{}",
          words);
    throw;
  }
  const gl::Context context(request.on);
  frame::Progress progress(frame::Progress::Mode::none);
  if (const auto done = job->run(context, progress, Clock::now()); done.signal != 0)
    fail(ExitCode::inputOutput, "interrupted");
  const auto again =
      frame::parseManifest(readFile(place.manifest(), "manifest"), place.manifest().string());
  const frame::ManifestFrame& made = again.frames.at(wanted.frame);
  Reproduction result;
  result.frame = wanted.frame;
  result.state = made.state;
  result.pixels = made.pixels;
  result.same = made.state == wanted.state && made.pixels == wanted.pixels;
  if (made.state != wanted.state)
    result.differences.push_back(fmt::format("state: it was {}, and is {} now", wanted.state, made.state));
  if (made.pixels != wanted.pixels)
    result.differences.push_back(
        fmt::format("pixels: they were {}, and are {} now", wanted.pixels, made.pixels));
  compareOrigins(request, wanted, again, frame::readRunLog(place.runs()), result);
  if (!wanted.drawn.empty() && wanted.drawn != made.pixels) result.same = false;
  return result;
}

}  // namespace simreel::batch
