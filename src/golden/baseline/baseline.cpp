#include "golden/baseline/baseline.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "base/text.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/files/damage.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr int baselineFormat = 1;

int frameNumber(const std::string& key) {
  std::string_view rest = key;
  const auto frame = takeInteger(rest);
  if (!frame || !rest.empty() || *frame < 0)
    throw JsonError(fmt::format("frame \"{}\" is no number", oneLine(key)));
  return *frame;
}

void checkFormat(JsonObject& root) {
  if (const int format = root.at("format").integer(); format != baselineFormat)
    throw JsonError(fmt::format("its format is {}, this program reads {}", format, baselineFormat));
}

/// Parses the origin of a frame. Older files contain only the numerics fingerprint.
Origin parseOrigin(JsonObject& frame) {
  if (const auto rasterizer = frame.find("rasterizer")) {
    if (!rasterizer->is("exact")) rasterizer->wrong("is not \"exact\"");
    return exactOrigin;
  }
  Origin origin;
  origin.numerics = frame.at("fingerprint").text();
  origin.drawing = textIfThere(frame, "drawing");
  const auto found = frame.find("machine");
  if (!found) return origin;
  JsonObject machine(*found);
  origin.processor = machine.at("processor").text();
  origin.driver = machine.at("driver").text();
  machine.finish();
  return origin;
}

PictureBaseline::Frame parseFrame(const JsonValue& value) {
  JsonObject frame(value);
  PictureBaseline::Frame stored;
  stored.pixels = frame.at("pixels").text();
  stored.origin = parseOrigin(frame);
  if (const auto alternates = frame.find("alternates")) stored.alternates = alternates->texts();
  if (stored.alternates.size() > maxAlternates)
    value.wrong(fmt::format("has more than {} alternates", maxAlternates));
  if (const auto passes = frame.find("passes"))
    passes->eachMember(
        [&](const std::string& pass, const JsonValue& hash) { stored.passes[pass] = hash.text(); });
  frame.finish();
  return stored;
}

PictureBaseline picturesOf(JsonObject& root) {
  PictureBaseline result;
  result.version = root.at("simreel").text();
  result.driver = root.at("driver").text();
  result.reason = textIfThere(root, "reason");
  result.width = root.at("width").integer();
  result.height = root.at("height").integer();
  if (const auto found = root.find("tolerance")) {
    JsonObject tolerance(*found);
    for (const scene::Bound& field : scene::Tolerance().bounds())
      for (const std::string& name : {std::string(field.name), field.formerName()})
        if (const auto bound = tolerance.find(name)) {
          result.tolerance[field.name] = bound->number();
          break;  // If both spellings are present, the former name is not read and is reported as unknown.
        }
    tolerance.finish();
  }
  root.at("frames").eachMember([&](const std::string& key, const JsonValue& frame) {
    result.frames[frameNumber(key)] = parseFrame(frame);
  });
  return result;
}

StateBaseline stateOf(JsonObject& root) {
  StateBaseline result;
  root.at("frames").eachMember([&](const std::string& key, const JsonValue& frame) {
    StateHashes& hashes = result.frames[frameNumber(key)];
    frame.eachMember([&](const std::string& name, const JsonValue& hash) { hashes[name] = hash.text(); });
  });
  return result;
}

/// Parses a baseline file. Error messages name the file.
template <class Result>
Result parseBaseline(const std::string& text, const std::string& name, Result (*parse)(JsonObject&)) {
  try {
    const auto json = parseStrictJson(text);
    JsonObject root{JsonValue(json)};
    checkFormat(root);
    Result result = parse(root);
    root.finish();
    return result;
  } catch (const JsonError& mistake) {
    if (const auto last = text.find_last_not_of(" \t\r\n"); last == std::string::npos || text[last] != '}')
      fail(ExitCode::inputOutput, "baseline {} is cut off after {} bytes; {}", name, text.size(),
           restoreIt);
    fail(ExitCode::inputOutput,
         "baseline {} cannot be used: {}; restore it (git checkout -- FILE) or repair it", name,
         mistake.what());
  }
}

constexpr std::size_t largestFile = std::size_t{64} << 20;

std::string readWhole(const fs::path& file) {
  std::string text = readFile(file, "baseline", largestFile);
  if (const std::string other = placeholderProblem(text); !other.empty())
    fail(ExitCode::inputOutput, "baseline {} {}", file.string(), other);
  if (text.empty()) fail(ExitCode::inputOutput, "baseline {} is empty; {}", file.string(), restoreIt);
  return text;
}

/// Reads a file of the baseline. Returns nothing if it does not exist.
template <class Result>
std::optional<Result> readBaseline(const fs::path& file,
                                   Result (*parse)(const std::string&, const std::string&)) {
  if (!pathExists(file)) return std::nullopt;
  return parse(readWhole(file), file.string());
}

/// Throws UserError(inputOutput) if the file to be written is a Git LFS pointer or has merge conflicts,
/// because the real file would be lost.
void refuseToReplace(const fs::path& file) {
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown)) return;
  if (const std::string other = placeholderProblem(readFile(file, "baseline", largestFile)); !other.empty())
    fail(ExitCode::inputOutput, "baseline {} {}; it is not overwritten", file.string(), other);
}

template <class Bytes>
void writeBaseline(const fs::path& file, const Bytes& bytes) {
  refuseToReplace(file);
  writeFileAtomically(file, bytes);
}

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Adds an accepted picture to the frame's entry. Returns 0 if the picture is the baseline, and otherwise
/// the number of the alternate.
int accept(PictureBaseline::Frame& stored, const PictureBaseline::Frame& made, bool alternate, int frame) {
  if (!alternate || stored.pixels.empty()) {
    stored = made;
    return 0;
  }
  if (stored.pixels == made.pixels) return 0;
  const auto known = std::find(stored.alternates.begin(), stored.alternates.end(), made.pixels);
  if (known != stored.alternates.end()) return static_cast<int>(known - stored.alternates.begin()) + 1;
  if (stored.alternates.size() == maxAlternates)
    fail(ExitCode::usage,
         "frame {} has {} alternates already; accept it as the baseline instead, without --alternate",
         frame, maxAlternates);
  stored.alternates.push_back(made.pixels);
  return static_cast<int>(stored.alternates.size());
}

/// Removes the pictures in the profile's folder that baseline.json does not list.
void removeUnlisted(const fs::path& folder, const PictureBaseline& baseline) {
  std::vector<std::string> listed;
  for (const auto& [number, frame] : baseline.frames)
    for (int i = 0; i <= static_cast<int>(frame.alternates.size()); ++i)
      listed.push_back(pictureName(number, i));
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".png" &&
        std::find(listed.begin(), listed.end(), entry.path().filename().string()) == listed.end())
      removeFile(entry.path());
}

/// Returns the existing baseline. If it cannot be read, returns an empty one, so that it is written again.
/// writeBaseline() still refuses to overwrite Git LFS pointers and files with merge conflicts.
template <class Result>
Result orFresh(const std::function<std::optional<Result>()>& read) {
  try {
    return read().value_or(Result());
  } catch (const UserError&) {
    return {};
  }
}

void promotePictures(const fs::path& folder, const std::string& profile, const Candidate& candidate,
                     const Promotion& how) {
  const fs::path place = folder / profile;
  makeFolders(place);
  auto merged = orFresh<PictureBaseline>([&] { return readPictures(folder, profile); });
  const PictureBaseline& made = candidate.pictures;
  const bool sameSize = merged.width == made.width && merged.height == made.height;
  if (!how.keepOthers || !sameSize) {
    auto kept = std::exchange(merged.frames, {});
    if (sameSize)
      for (const auto& [frame, entry] : made.frames)
        if (kept.contains(frame)) merged.frames[frame] = kept[frame];
  }
  merged.width = made.width;
  merged.height = made.height;
  for (const auto& [frame, png] : candidate.png) {
    const int number = accept(merged.frames[frame], made.frames.at(frame), how.alternate, frame);
    writeBaseline(place / pictureName(frame, number), png);
  }
  merged.version = made.version;
  merged.driver = made.driver;
  if (!how.reason.empty()) merged.reason = how.reason;
  writeBaseline(place / "baseline.json", picturesText(merged));
  removeUnlisted(place, merged);
}

void promoteState(const fs::path& place, const Candidate& candidate, const Promotion& how) {
  makeFolders(place);
  auto merged = orFresh<StateBaseline>([&] { return readState(place); });
  // Mixing frames of two different simulations would make a state baseline that no run can match.
  if (!how.keepOthers) merged.frames.clear();
  for (const auto& [frame, hashes] : candidate.state.frames) merged.frames[frame] = hashes;
  if (!candidate.steps.empty()) writeBaseline(place / "steps.bin", candidate.steps);
  writeBaseline(place / "state.json", stateText(merged));
}

}  // namespace

fs::path baselineFolder(const fs::path& sceneFile) {
  return sceneFile.parent_path() / "golden" / sceneFile.stem();
}

std::string pictureName(int frame, int alternate) {
  return alternate == 0 ? fmt::format("{:06}.png", frame)
                        : fmt::format("{:06}.alt{}.png", frame, alternate);
}

fs::path stateFolder(const fs::path& folder, const std::string& profile, bool exact) {
  return exact ? folder : folder / profile;
}

void checkReplaceable(const fs::path& folder, const std::string& profile, bool exact) {
  refuseToReplace(folder / profile / "baseline.json");
  for (const char* name : {"state.json", "steps.bin"})
    refuseToReplace(stateFolder(folder, profile, exact) / name);
}

std::optional<PictureBaseline> readPictures(const fs::path& folder, const std::string& profile) {
  auto found = readBaseline(folder / profile / "baseline.json", parsePictures);
  if (found) found->profile = profile;
  return found;
}

std::optional<StateBaseline> readState(const fs::path& stateFolder) {
  return readBaseline(stateFolder / "state.json", parseState);
}

std::vector<std::byte> readSteps(const fs::path& stateFolder) {
  const fs::path file = stateFolder / "steps.bin";
  if (!pathExists(file)) return {};
  const std::string text = readWhole(file);
  const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
  return {bytes.begin(), bytes.end()};
}

std::optional<PictureBaseline> choosePictures(const fs::path& folder, const std::string& ownProfile) {
  if (auto own = readPictures(folder, ownProfile)) return own;
  return readPictures(folder, sharedProfile);
}

std::string profileToWrite(const fs::path& folder, const std::string& ownProfile,
                           const std::string& numerics) {
  if (pathExists(folder / ownProfile / "baseline.json")) return ownProfile;
  const auto shared = orFresh<PictureBaseline>([&] { return readPictures(folder, sharedProfile); });
  const bool ours = std::all_of(shared.frames.begin(), shared.frames.end(), [&](const auto& entry) {
    return entry.second.origin.exact || entry.second.origin.numerics == numerics;
  });
  return ours ? sharedProfile : ownProfile;
}

void promote(const fs::path& folder, const std::string& profile, const Candidate& candidate,
             const Promotion& how) {
  if (!candidate.png.empty() || !how.keepOthers) promotePictures(folder, profile, candidate, how);
  if (!candidate.state.frames.empty())
    promoteState(stateFolder(folder, profile, candidate.exact), candidate, how);
}

bool renewPasses(const fs::path& folder, const std::string& profile,
                 const std::map<int, std::map<std::string, std::string>>& passes) {
  auto listed = readPictures(folder, profile);
  bool changed = false;
  for (const auto& [frame, hashes] : passes) {
    if (!listed || !listed->frames.contains(frame)) continue;
    auto& known = listed->frames[frame].passes;
    changed = changed || known != hashes;
    known = hashes;
  }
  if (changed) writeFileAtomically(folder / profile / "baseline.json", picturesText(*listed));
  return changed;
}

PictureBaseline parsePictures(const std::string& text, const std::string& name) {
  return parseBaseline(text, name, picturesOf);
}

StateBaseline parseState(const std::string& text, const std::string& name) {
  return parseBaseline(text, name, stateOf);
}

std::string picturesText(const PictureBaseline& baseline) {
  Json json = {{"format", baselineFormat}, {"simreel", baseline.version}, {"driver", baseline.driver}};
  if (!baseline.reason.empty()) json["reason"] = baseline.reason;
  json["width"] = baseline.width;
  json["height"] = baseline.height;
  if (!baseline.tolerance.empty()) json["tolerance"] = baseline.tolerance;
  json["frames"] = Json::object();
  for (const auto& [frame, entry] : baseline.frames) {
    // Items are created with their content, because nlohmann::json would terminate the program if growing a
    // null item runs out of memory.
    Json& item = json["frames"][std::to_string(frame)] = Json{{"pixels", entry.pixels}};
    if (entry.origin.exact)
      item["rasterizer"] = "exact";
    else
      item["fingerprint"] = entry.origin.numerics;
    if (!entry.origin.drawing.empty()) item["drawing"] = entry.origin.drawing;
    if (!entry.origin.processor.empty() || !entry.origin.driver.empty())
      item["machine"] = {{"processor", entry.origin.processor}, {"driver", entry.origin.driver}};
    if (!entry.alternates.empty()) item["alternates"] = entry.alternates;
    if (!entry.passes.empty()) item["passes"] = entry.passes;
  }
  return dump(json);
}

std::string stateText(const StateBaseline& baseline) {
  Json json = {{"format", baselineFormat}, {"frames", Json::object()}};
  for (const auto& [frame, hashes] : baseline.frames) {
    Json& item = json["frames"][std::to_string(frame)] = Json::object();
    for (const auto& [name, hash] : hashes) item[name] = hash;
  }
  return dump(json);
}

}  // namespace simreel::golden
