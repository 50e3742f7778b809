#include "kernels/cache.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/version.hpp"
#include "kernels/source/files.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace simreel::kernels {

namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t byteLimit = std::uintmax_t{64} << 20;

std::string variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  return value == nullptr ? "" : value;
}

/// Returns the cache folder, or an empty path if caching is off.
fs::path folder() {
  if (!variable("SIMREEL_GLSL").empty()) return {};
  const std::string own = variable("XDG_CACHE_HOME"), home = variable("HOME");
  if (!own.empty()) return fs::path(own) / "simreel";
  return home.empty() ? fs::path() : fs::path(home) / ".cache/simreel";
}

/// Returns text that identifies this build of the program, because builds of the same version may generate
/// different GLSL.
std::string program() {
  std::error_code error;
  const fs::path file = programFile();
  if (file.empty()) return version();
  return fmt::format("{} {} {} {}", version(), file.string(), fs::file_size(file, error),
                     fs::last_write_time(file, error).time_since_epoch().count());
}

fs::path entryOf(const Request& request) {
  std::vector<std::string> folders;
  for (const fs::path& one : request.folders) folders.push_back(one.string());
  const std::string key =
      fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}", program(), request.file.string(),
                  fs::absolute(request.file).string(), fmt::join(folders, ":"),
                  fmt::join(request.kernels, ","), fmt::join(request.keywords, ","), request.fast,
                  request.careful, request.pass, request.upsideDown, request.report, request.maxIterations,
                  fmt::join(request.previous, ","), static_cast<int>(request.race));
  return folder() / fmt::format("{}.kernel", hashHex(key));
}

std::string hashOf(const std::string& file) {
  return hashHex(readFile(file, "shader", maxFileBytes));
}

void removeOldest(const fs::path& from) {
  std::vector<std::pair<fs::file_time_type, fs::path>> entries;
  std::uintmax_t bytes = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(from, error)) {
    if (entry.path().extension() != ".kernel") continue;
    bytes += entry.file_size(error);
    entries.emplace_back(entry.last_write_time(error), entry.path());
  }
  std::sort(entries.begin(), entries.end());
  for (const auto& [time, path] : entries) {
    if (bytes <= byteLimit) return;
    bytes -= fs::file_size(path, error);
    fs::remove(path, error);
  }
}

}  // namespace

std::optional<Shader> cachedShader(const Request& request) {
  if (folder().empty()) return std::nullopt;
  try {
    const auto entry = nlohmann::json::parse(readFile(entryOf(request), "cache"));
    Shader shader = fromJson(entry.at("shader").get<std::string>());
    const auto hashes = entry.at("hashes").get<std::vector<std::string>>();
    if (hashes.size() != shader.files.size() || hashes.empty()) return std::nullopt;
    for (std::size_t i = 0; i < hashes.size(); ++i)
      if (hashOf(shader.files[i]) != hashes[i]) return std::nullopt;
    return shader;
  } catch (const std::exception&) {
    return std::nullopt;  // The entry is missing or damaged.
  }
}

void keepShader(const Request& request, const Shader& shader) {
  if (folder().empty()) return;
  try {
    fs::create_directories(folder());
    nlohmann::json entry = {{"shader", toJson(shader)}, {"hashes", nlohmann::json::array()}};
    for (const std::string& file : shader.files) entry["hashes"].push_back(hashOf(file));
    writeFileAtomically(entryOf(request), entry.dump(), NameSync::later);
    removeOldest(folder());
  } catch (const std::exception&) {
    return;  // Nothing was stored, so the next run compiles again.
  }
}

}  // namespace simreel::kernels
