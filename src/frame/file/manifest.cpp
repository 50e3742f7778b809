#include "frame/file/manifest.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/strict_json.hpp"
#include "base/version.hpp"
#include "frame/file/run_info.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <string_view>

#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* manifestFormat = "simreel-manifest";
// Version 2 added hashes of files, version 3 moved machines to run.json, and version 4 added the manifest's
// hash.
constexpr int formatVersion = 4;
constexpr int oldestVersion = 3;

/// Returns the closing text of a manifest, which contains a hash of the text `before`.
std::string closing(std::string_view before) {
  return fmt::format(",\n  \"hash\": \"{}\"\n}}\n", hashHex(before));
}

void checkHash(std::string_view text, const JsonValue& object) {
  if (object.at("version").integer() < formatVersion) return;
  const std::size_t length = closing("").size();
  const auto before = text.substr(0, text.size() - std::min(length, text.size()));
  if (text.substr(before.size()) != closing(before))
    throw JsonError("it was changed after it was written: its hash does not match");
}

ManifestFrame readFrame(const JsonValue& item) {
  ManifestFrame frame = {item.at("file").text(), item.at("bytes").text(), item.at("pixels").text(),
                         item.at("state").text()};
  if (const auto files = item.find("files"))
    files->eachMember(
        [&](const std::string& name, const JsonValue& hash) { frame.files[name] = hash.text(); });
  return frame;
}

}  // namespace

std::string manifestText(const Manifest& manifest) {
  const RunInfo& run = manifest.run;
  Json object = {{"format", manifestFormat}, {"version", formatVersion},     {"program", version()},
                 {"title", run.title},       {"scene", run.sceneHash},       {"seed", run.seed},
                 {"width", run.width},       {"height", run.height},         {"fps", run.fps},
                 {"numerics", run.numerics}, {"rasterizer", run.rasterizer}, {"overrides", run.overrides}};
  if (!run.exact()) object["fingerprint"] = run.fingerprint;
  if (!run.asRunHash.empty()) object["asRun"] = run.asRunHash;
  if (!run.camera.empty()) object["camera"] = run.camera;
  const auto dump = [](const Json& value, int indent) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
  };
  std::string text = dump(object, 2);
  text.resize(text.size() - 2);  // Removes the closing " }", so that more members can be appended.
  if (!manifest.counts.empty()) text += ",\n  \"counts\": " + dump(manifest.counts, -1);
  text += ",\n  \"frames\": [";
  // Each frame is one line, so that a text diff of two manifests shows the frames.
  const char* separator = "\n";
  for (const auto& [number, frame] : manifest.frames) {
    Json item = {{"frame", number},
                 {"file", frame.file},
                 {"bytes", frame.bytes},
                 {"pixels", frame.pixels},
                 {"state", frame.state}};
    if (!frame.files.empty()) item["files"] = frame.files;
    text += separator + ("    " + dump(item, -1));
    separator = ",\n";
  }
  text += manifest.frames.empty() ? "]" : "\n  ]";
  return text + closing(text);
}

Manifest manifestOf(const JsonValue& object) {
  const auto format = object.find("format");
  if (!format || !format->is(manifestFormat)) throw JsonError("it is not a simreel manifest");
  if (const int version = object.at("version").integer();
      version < oldestVersion || version > formatVersion)
    throw JsonError(fmt::format("its version is {}, this program reads {} and {}", version, oldestVersion,
                                formatVersion));
  Manifest result;
  RunInfo& run = result.run;
  run.title = object.at("title").text();
  run.sceneHash = object.at("scene").text();
  if (const auto overrides = object.find("overrides")) run.overrides = overrides->texts();
  run.seed = object.at("seed").integer();
  run.width = object.at("width").integer();
  run.height = object.at("height").integer();
  run.fps = object.at("fps").number();
  run.numerics = object.at("numerics").text();
  run.rasterizer = object.at("rasterizer").text();
  run.fingerprint = textIfThere(object, "fingerprint");
  run.asRunHash = textIfThere(object, "asRun");
  if (const auto camera = object.find("camera")) run.camera = camera->texts();
  result.counts = textIfThere(object, "counts");
  object.at("frames").eachItem(
      [&](const JsonValue& item) { result.frames[item.at("frame").integer()] = readFrame(item); });
  return result;
}

Manifest parseManifest(const std::string& text, const std::string& name) {
  try {
    const auto json = parseStrictJson(text);
    Manifest manifest = manifestOf(JsonValue(json));
    checkHash(text, JsonValue(json));
    return manifest;
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "manifest {} cannot be read: {}", name, error.what());
  }
}

std::optional<Manifest> readManifest(const std::filesystem::path& path) {
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return std::nullopt;
  return parseManifest(readFile(path, "manifest"), path.string());
}

bool isForeignManifest(const std::filesystem::path& path) {
  std::error_code error;
  if (path.empty() || !std::filesystem::is_regular_file(path, error)) return false;
  try {
    const auto json = parseStrictJson(readFile(path, "manifest"));
    const bool own = json.is_object() && json.contains("format") && json["format"] == manifestFormat;
    return json.is_object() && !json.empty() && !own;
  } catch (const JsonError&) {
    return false;
  } catch (const UserError&) {
    return false;
  }
}

std::optional<std::string> runDifference(const RunInfo& wanted, const RunInfo& stored) {
  const auto say = [](const char* item, const auto& here, const auto& there) {
    return fmt::format("{} is {} in this run and {} in the earlier one", item, here, there);
  };
  if (wanted.overrides != stored.overrides) {
    const auto listed = [](const RunInfo& run) {
      return run.overrides.empty() ? std::string("nothing") : scene::asArguments(run.overrides);
    };
    return say("what is changed in the scene", listed(wanted), listed(stored));
  }
  if (wanted.sceneHash != stored.sceneHash) return say("scene hash", wanted.sceneHash, stored.sceneHash);
  if (wanted.seed != stored.seed) return say("seed", wanted.seed, stored.seed);
  if (wanted.width != stored.width || wanted.height != stored.height)
    return say("size", fmt::format("{}x{}", wanted.width, wanted.height),
               fmt::format("{}x{}", stored.width, stored.height));
  if (wanted.fps != stored.fps) return say("fps", wanted.fps, stored.fps);
  if (wanted.numerics != stored.numerics) return say("numerics", wanted.numerics, stored.numerics);
  if (wanted.rasterizer != stored.rasterizer)
    return say("rasterizer", wanted.rasterizer, stored.rasterizer);
  if (!wanted.exact() && wanted.fingerprint != stored.fingerprint)
    return say("numerics fingerprint (driver and memory path)", wanted.fingerprint, stored.fingerprint);
  return std::nullopt;
}

std::string runIdentity(const RunInfo& run) {
  return hashHex(fmt::format("{} {} {} {}x{} {} {} {} {}", scene::asArguments(run.overrides), run.sceneHash,
                             run.seed, run.width, run.height, run.fps, run.numerics, run.rasterizer,
                             run.exact() ? "" : run.fingerprint));
}

}  // namespace simreel::frame
