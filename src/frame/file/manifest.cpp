#include "frame/file/manifest.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/json_depth.hpp"
#include "base/version.hpp"
#include "frame/file/run_info.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <new>
#include <type_traits>

#include <climits>
#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* manifestFormat = "simreel-manifest";
constexpr int formatVersion = 2;  // 2: hashes of files

template <class T>
T get(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw std::runtime_error(fmt::format("\"{}\" is missing", key));
  // A number such as 1e99 has no int; the library would convert it all the same.
  if (std::is_same_v<T, int> && (!found->is_number_integer() ||
                                 (found->is_number_unsigned() && found->get<std::uint64_t>() > INT_MAX) ||
                                 found->get<std::int64_t>() != found->get<int>()))
    throw std::runtime_error(fmt::format("\"{}\" is no whole number", key));
  try {
    return found->get<T>();
  } catch (const Json::exception&) {
    throw std::runtime_error(fmt::format("\"{}\" is of the wrong type", key));
  }
}

std::string getIfThere(const Json& object, const char* key) {
  return object.contains(key) ? get<std::string>(object, key) : std::string();
}

ManifestFrame readFrame(const Json& item) {
  ManifestFrame frame = {get<std::string>(item, "file"), get<std::string>(item, "bytes"),
                         get<std::string>(item, "pixels"), get<std::string>(item, "state")};
  frame.machine = getIfThere(item, "machine");
  if (item.contains("files")) frame.files = get<std::map<std::string, std::string>>(item, "files");
  return frame;
}

Manifest readObject(const Json& object) {
  if (!object.is_object() || get<std::string>(object, "format") != manifestFormat)
    throw std::runtime_error("it is not a simreel manifest");
  if (const int version = get<int>(object, "version"); version != formatVersion)
    throw std::runtime_error(
        fmt::format("its version is {}, this program reads {}", version, formatVersion));
  Manifest result;
  RunInfo& run = result.run;
  run.title = get<std::string>(object, "title");
  run.sceneHash = get<std::string>(object, "scene");
  if (object.contains("overrides")) run.overrides = get<std::vector<std::string>>(object, "overrides");
  run.seed = get<int>(object, "seed");
  run.width = get<int>(object, "width");
  run.height = get<int>(object, "height");
  run.fps = get<double>(object, "fps");
  run.numerics = get<std::string>(object, "numerics");
  run.fingerprint = get<std::string>(object, "fingerprint");
  run.driver = get<std::string>(object, "driver");
  run.processor = getIfThere(object, "processor");
  if (object.contains("counts")) result.counts = get<std::string>(object, "counts");
  const auto frames = object.find("frames");
  if (frames == object.end() || !frames->is_array()) throw std::runtime_error("\"frames\" is not a list");
  for (const Json& item : *frames) result.frames[get<int>(item, "frame")] = readFrame(item);
  return result;
}

}  // namespace

std::string manifestText(const Manifest& manifest) {
  const RunInfo& run = manifest.run;
  Json object = {{"format", manifestFormat},  {"version", formatVersion},       {"program", version()},
                 {"title", run.title},        {"scene", run.sceneHash},         {"seed", run.seed},
                 {"width", run.width},        {"height", run.height},           {"fps", run.fps},
                 {"numerics", run.numerics},  {"fingerprint", run.fingerprint}, {"driver", run.driver},
                 {"overrides", run.overrides}};
  if (!run.processor.empty()) object["processor"] = run.processor;
  const auto dump = [](const Json& value, int indent) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
  };
  std::string text = dump(object, 2);
  text.resize(text.size() - 2);  // the closing "\n}"
  if (!manifest.counts.empty()) text += ",\n  \"counts\": " + dump(manifest.counts, -1);
  text += ",\n  \"frames\": [";
  // One line a frame, so that a text diff of two manifests names the frames.
  const char* separator = "\n";
  for (const auto& [number, frame] : manifest.frames) {
    Json item = {{"frame", number},
                 {"file", frame.file},
                 {"bytes", frame.bytes},
                 {"pixels", frame.pixels},
                 {"state", frame.state}};
    if (!frame.machine.empty()) item["machine"] = frame.machine;
    if (!frame.files.empty()) item["files"] = frame.files;
    text += separator + ("    " + dump(item, -1));
    separator = ",\n";
  }
  return text + (manifest.frames.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

Manifest parseManifest(const std::string& text, const std::string& name) {
  try {
    refuseDeepJson(text);
    return readObject(Json::parse(text));
  } catch (const Json::parse_error& error) {
    fail(ExitCode::usage, "manifest {} cannot be read: not valid JSON at byte {}", name, error.byte);
  } catch (const std::bad_alloc&) {
    throw;  // the file may be good: nobody starts over because of it
  } catch (const std::exception& error) {
    fail(ExitCode::usage, "manifest {} cannot be read: {}", name, error.what());
  }
}

std::optional<Manifest> readManifest(const std::filesystem::path& path) {
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return std::nullopt;
  return parseManifest(readFile(path, "manifest"), path.string());
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
  if (wanted.fingerprint != stored.fingerprint)
    return say("numerics fingerprint (driver and memory path)", wanted.fingerprint, stored.fingerprint);
  return std::nullopt;
}

std::string machineOf(const RunInfo& run) {
  return run.processor.empty() ? std::string() : run.processor + "; " + run.driver;
}

std::string runIdentity(const RunInfo& run) {
  return hashHex(fmt::format("{} {} {} {}x{} {} {} {}", scene::asArguments(run.overrides), run.sceneHash,
                             run.seed, run.width, run.height, run.fps, run.numerics, run.fingerprint));
}

}  // namespace simreel::frame
