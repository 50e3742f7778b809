#include "frame/file/run_log.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "base/version.hpp"
#include "frame/frames_spec.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <iterator>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* logFormat = "simreel-run";
constexpr int logVersion = 1;

std::string hostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string timeText() {
  using WallClock = std::chrono::system_clock;
  const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(WallClock::now());
  const std::time_t seconds = WallClock::to_time_t(now);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  (void)std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  return fmt::format("{}.{:03}Z", text.data(), now.time_since_epoch().count() % 1000);
}

RunRecord readRecord(const JsonValue& item) {
  RunRecord record;
  record.program = item.at("program").text();
  record.host = item.at("host").text();
  record.process = item.at("process").integer<std::int64_t>();
  record.began = item.at("began").text();
  record.seconds = item.at("seconds").number();
  record.driver = item.at("driver").text();
  record.processor = item.at("processor").text();
  record.fingerprint = item.at("fingerprint").text();
  record.command = item.at("command").text();
  record.folders = item.at("folders").texts();
  if (const std::string frames = item.at("frames").text(); !frames.empty()) {
    const auto read = parseFrames(frames);
    record.frames.insert(read.begin(), read.end());
  }
  return record;
}

}  // namespace

std::string RunRecord::machine() const {
  return processor.empty() ? std::string() : processor + "; " + driver;
}

std::string RunLog::machineOf(int frame) const {
  for (const RunRecord& record : runs)
    if (record.frames.contains(frame)) return record.machine();
  return {};
}

void RunLog::put(const RunRecord& record) {
  for (RunRecord& other : runs)
    if (!other.isOf(record))
      std::erase_if(other.frames, [&](int frame) { return record.frames.contains(frame); });
  const auto own =
      std::find_if(runs.begin(), runs.end(), [&](const RunRecord& other) { return other.isOf(record); });
  if (own != runs.end())
    *own = record;
  else
    runs.push_back(record);
  std::erase_if(runs, [](const RunRecord& other) { return other.frames.empty(); });
}

RunRecord beginRecord(const RunInfo& run) {
  RunRecord record;
  record.program = version();
  record.host = hostName();
  record.process = ::getpid();
  record.began = timeText();
  record.driver = run.driver;
  record.processor = run.processor;
  record.fingerprint = run.fingerprint;
  record.command = run.command;
  record.folders = run.folders;
  return record;
}

std::string runLogText(const RunLog& log) {
  std::string text =
      fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"runs\": [", logFormat, logVersion);
  const char* separator = "\n";
  for (const RunRecord& record : log.runs) {
    const Json item = {{"program", record.program},          {"host", record.host},
                       {"process", record.process},          {"began", record.began},
                       {"seconds", record.seconds},          {"driver", record.driver},
                       {"processor", record.processor},      {"fingerprint", record.fingerprint},
                       {"command", record.command},          {"folders", record.folders},
                       {"frames", framesText(record.frames)}};
    text += separator + ("    " + item.dump(-1, ' ', false, Json::error_handler_t::replace));
    separator = ",\n";
  }
  return text + (log.runs.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

RunLog parseRunLog(const std::string& text, const std::string& name) {
  try {
    const auto json = parseStrictJson(text);
    const JsonValue object(json);
    if (!object.at("format").is(logFormat)) throw JsonError("it is not a list of runs of simreel");
    if (const int version = object.at("version").integer(); version != logVersion)
      throw JsonError(fmt::format("its version is {}, this program reads {}", version, logVersion));
    RunLog log;
    object.at("runs").eachItem([&](const JsonValue& item) { log.runs.push_back(readRecord(item)); });
    return log;
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "{} cannot be read: {}", name, error.what());
  }
}

RunLog readRunLog(const std::filesystem::path& file) {
  if (!pathExists(file)) return {};
  try {
    return parseRunLog(readFile(file, "log of runs"), file.string());
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace simreel::frame
