#include "golden/report/merge.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/report/json.hpp"
#include "golden/report/words.hpp"
#include "golden/suite/scene_set.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// Copies pictures and candidates from one report's folder to another, and adjusts their paths.
class ReportFiles {
 public:
  ReportFiles(fs::path from, fs::path to, std::vector<std::string>& notes)
      : from_(std::move(from)), to_(std::move(to)), notes_(notes) {}

  void carry(SceneResult& scene) {
    for (FrameResult& frame : scene.frames) {
      for (std::string* path :
           {&frame.expectedImage, &frame.actualImage, &frame.differenceImage, &frame.flipImage})
        carryOne(scene, *path);
      for (OtherPicture& other : frame.others) carryOne(scene, other.image);
    }
    carryOne(scene, scene.candidate);
  }

 private:
  /// Returns the new path of a path such as "files/a/1.png" or "report-files/a/1.png".
  static std::string placeOf(const std::string& path) {
    const std::size_t slash = path.find('/');
    return "files/" + (slash == std::string::npos ? path : path.substr(slash + 1));
  }

  void carryOne(const SceneResult& scene, std::string& path) {
    if (path.empty()) return;
    const fs::path source = from_ / path;
    path = placeOf(path);
    std::error_code unknown;
    // Links are not followed, because a report from an untrusted source must not cause copies of other
    // files of this machine.
    const fs::file_status status = fs::symlink_status(source, unknown);
    if (fs::is_directory(status)) {
      // Completes the list before copying, because the copies may be written below `source`.
      std::vector<fs::path> files;
      for (const auto& entry : fs::recursive_directory_iterator(source, unknown))
        if (entry.is_regular_file(unknown) && !entry.is_symlink(unknown)) files.push_back(entry.path());
      for (const fs::path& file : files) copy(file, to_ / path / file.lexically_relative(source));
    } else if (fs::is_regular_file(status)) {
      copy(source, to_ / path);
    } else {
      notes_.push_back(fmt::format("{} of {} is missing; copy the whole folder of a report",
                                   source.generic_string(), scene.name));
      path.clear();
    }
  }

  static void copy(const fs::path& from, const fs::path& to) {
    if (pathExists(to)) return;  // A candidate's picture may also be a frame's picture.
    makeFolders(to.parent_path());
    const std::string bytes = readFile(from, "picture");
    writeFileAtomically(to, std::string_view(bytes), NameSync::later);
  }

  fs::path from_, to_;
  std::vector<std::string>& notes_;
};

void checkTogether(const PartReport& first, const PartReport& part) {
  const auto requireEqual = [&](const char* what, const std::string& a, const std::string& b) {
    if (a != b)
      fail(ExitCode::usage, "{} and {} do not belong together: the {} is {} and {}", first.file.string(),
           part.file.string(), what, a.empty() ? "none" : a, b.empty() ? "none" : b);
  };
  requireEqual("unit", first.suite.unit, part.suite.unit);
  requireEqual("folder of baselines", first.suite.expected, part.suite.expected);
  requireEqual("version", first.suite.version, part.suite.version);
}

/// Adds a stale baseline, or merges it with the entry of another report. Keeps the more detailed message,
/// which tells where a moved baseline went.
void addStale(const Stale& stale, std::vector<Stale>& all) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const Stale& other) {
    return other.path == stale.path &&
           (other.message == stale.message || stale.message.starts_with("its scene is gone"));
  });
  if (known == all.end()) {
    all.push_back(stale);
    return;
  }
  if (stale.message.size() > known->message.size()) known->message = stale.message;
  known->removed = known->removed || stale.removed;
}

std::string shardNotes(const std::vector<PartReport>& parts, std::vector<std::string>& missing) {
  // report file by number of shards n and by shard number k
  std::map<std::size_t, std::map<std::size_t, fs::path>> reports;
  for (const PartReport& part : parts) {
    if (part.suite.shard.empty()) continue;
    const auto [k, n] = shardNumbers(part.suite.shard);
    const auto [known, isNew] = reports[n].emplace(k, part.file);
    if (!isNew)
      fail(ExitCode::usage, "{} and {} are both of shard {}; give one of them", known->second.string(),
           part.file.string(), part.suite.shard);
  }
  for (const auto& [n, known] : reports)
    for (std::size_t k = 1; k <= n; ++k)
      if (!known.contains(k)) missing.push_back(fmt::format("{}/{}", k, n));
  return "merged from " + counted(static_cast<long>(parts.size()), "report");
}

void mergeEnvironment(const SuiteResult& part, SuiteResult& all) {
  if (part.driver.empty()) return;  // The part is a shard without scenes.
  if (all.driver.empty()) {
    all.driver = part.driver;
    all.processor = part.processor;
    all.profile = part.profile;
    all.fingerprint = part.fingerprint;
    all.drawing = part.drawing;
    all.memoryPath = part.memoryPath;
  } else if (all.driver != part.driver || all.processor != part.processor) {
    all.notes.push_back(
        fmt::format("not all ran on one machine: also on {}, {}", part.driver, part.processor));
  }
}

void addNotes(const PartReport& part, std::vector<std::string>& notes) {
  for (const std::string& note : part.suite.notes)
    if (!note.starts_with("shard ")) notes.push_back(note);
}

}  // namespace

PartReport readPart(const fs::path& report) {
  std::error_code unknown;
  const fs::path file = fs::is_directory(report, unknown) ? report / "report.json" : report;
  return {file, parseReport(readFile(file, "report"), file.string())};
}

Merged mergeReports(const std::vector<PartReport>& parts, const fs::path& folder) {
  Merged merged;
  SuiteResult& all = merged.suite;
  const PartReport& first = parts.front();
  all.version = first.suite.version;
  all.unit = first.suite.unit;
  all.expected = first.suite.expected;
  all.allowFlaky = true;
  all.notes.push_back(shardNotes(parts, merged.missingShards));
  for (const std::string& shard : merged.missingShards)
    all.notes.push_back(fmt::format("there is no report of shard {}", shard));
  std::map<std::string, fs::path> owner;
  for (const PartReport& part : parts) {
    checkTogether(first, part);
    for (const SceneResult& scene : part.suite.scenes)
      if (const auto [known, isNew] = owner.emplace(scene.name, part.file); !isNew)
        fail(ExitCode::usage, "{} is in {} and in {}; give each {} once", scene.name,
             known->second.string(), part.file.string(), all.unit);
  }
  for (const PartReport& part : parts) {
    mergeEnvironment(part.suite, all);
    all.allowFlaky = all.allowFlaky && part.suite.allowFlaky;
    all.strict = all.strict || part.suite.strict;
    // The parts ran in parallel, so their times are not added.
    all.seconds = std::max(all.seconds, part.suite.seconds);
    addNotes(part, all.notes);
    for (const Stale& stale : part.suite.stale) addStale(stale, all.stale);
    ReportFiles luggage(part.file.parent_path(), folder, all.notes);
    for (SceneResult scene : part.suite.scenes) {
      luggage.carry(scene);
      all.scenes.push_back(std::move(scene));
    }
  }
  std::sort(all.scenes.begin(), all.scenes.end(),
            [](const SceneResult& a, const SceneResult& b) { return a.name < b.name; });
  // Every report contains the same notes about whole folders, so duplicates are removed.
  std::vector<std::string> once;
  for (std::string& note : all.notes)
    if (std::find(once.begin(), once.end(), note) == once.end()) once.push_back(std::move(note));
  all.notes = std::move(once);
  return merged;
}

}  // namespace simreel::golden
