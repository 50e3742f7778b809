// simreel test --expected DIR (--actual DIR | --run COMMAND): compares pictures made by any program with
// their baselines.
#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/options/job_count.hpp"
#include "cli/test/test_options.hpp"
#include "frame/interrupt.hpp"
#include "golden/baseline/inputs.hpp"
#include "golden/pictures/picture_folder.hpp"
#include "golden/pictures/picture_test.hpp"
#include "golden/pictures/render_command.hpp"
#include "golden/suite/suite.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// Creates a temporary folder and removes it in the destructor.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "simreel-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) fail(ExitCode::inputOutput, "cannot make a folder {}", name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void checkOptions(const TestOptions& o) {
  if (o.expected.empty())
    fail(ExitCode::usage, "{} is only for pictures; add --expected FOLDER, the folder of their baselines",
         !o.run.empty()      ? "--run"
         : !o.actual.empty() ? "--actual"
                             : "--rules");
  if (o.actual.empty() && o.run.empty())
    fail(ExitCode::usage,
         "--expected needs --actual, the folder of the pictures, or --run, a command that makes them");
  if (o.run.empty() && !o.paths.empty())
    fail(ExitCode::usage, "{} cannot be combined with --expected; scenes need --run", o.paths.front());
  if (!o.paths.empty() && o.run.find("{scene}") == std::string::npos)
    fail(ExitCode::usage, "{} is given, but the command of --run does not contain {{scene}}",
         o.paths.front());
  if (!o.shard.empty() && o.updateMode() == golden::Update::prune)
    fail(ExitCode::usage, "--update=prune needs all pictures, so it cannot be combined with --shard");
  if (!o.profile.empty() || !o.reason.empty())
    fail(ExitCode::usage, "--profile and --reason are for scenes, not for pictures");
  if (o.run.empty() && (o.retries > 0 || o.timeout > 0))
    fail(ExitCode::usage,
         "--retries and --timeout have no effect with --actual, because nothing is rendered");
  if (o.run.empty() && o.jobs != "1")
    fail(ExitCode::usage, "--jobs has no effect with --actual, because nothing is rendered");
  std::error_code unknown;
  if (!fs::is_directory(o.expected, unknown) && o.updateMode() != golden::Update::all &&
      o.updateMode() != golden::Update::missing)
    fail(ExitCode::usage, "--expected {} is not a folder; --update creates it", o.expected);
  if (o.run.empty() && !fs::is_directory(o.actual, unknown))
    fail(ExitCode::usage, "--actual {} is no folder", o.actual);
  if (fs::equivalent(o.expected, o.actual, unknown))
    fail(ExitCode::usage, "--expected and --actual are the same folder {}", o.expected);
  for (const auto& [inner, outer] : {std::pair(&o.expected, &o.actual), std::pair(&o.actual, &o.expected)})
    if (!outer->empty() && !inner->empty() && liesBelow(*inner, *outer))
      fail(ExitCode::usage,
           "the folder {} lies below {}, so its pictures would count twice; give --expected and --actual "
           "folders beside each other",
           *inner, *outer);
  if (o.updateMode() == golden::Update::prune && o.run.find("{scene}") != std::string::npos)
    for (const std::string& path : o.paths)
      if (!fs::is_directory(path, unknown))
        fail(ExitCode::usage, "--update=prune needs all scenes, and {} is only one; give their folder",
             path);
}

/// Returns the rules of the file followed by the rules of the command line, which take precedence.
std::vector<golden::Rule> rulesOf(const TestOptions& o) {
  std::vector<golden::Rule> rules;
  if (!o.rules.empty()) rules = golden::readRules(o.rules);
  for (const auto& [field, value] : o.tolerance.given()) {
    golden::Rule rule;
    rule.tolerance[field] = value;
    rule.origin = "command line";
    rules.push_back(std::move(rule));
  }
  golden::Rule flags;
  flags.origin = "command line";
  if (o.allowance.ignoreAntialiased) flags.ignoreAntialiased = true;
  flags.searchRadius = o.allowance.searchRadius;
  if (!o.allowance.mask.empty()) flags.masks.emplace_back(o.allowance.mask);
  rules.push_back(std::move(flags));
  return rules;
}

bool chosen(const TestOptions& o, const std::string& name) {
  return o.globs.empty() || std::any_of(o.globs.begin(), o.globs.end(), [&](const std::string& glob) {
           return golden::nameMatches(glob, name);
         });
}

/// One run of `simreel test` on pictures. Renders them if requested, and compares all selected pictures
/// with their baselines.
class PictureRun {
 public:
  explicit PictureRun(const TestOptions& o) : o_(o), begin_(Clock::now()) {
    checkOptions(o);
    jobs_ = jobCount(o.jobs);
    options_.expected = o.expected;
    options_.rules = rulesOf(o);
    options_.update = o.updateMode();
    options_.measures = o.measures();
    options_.reportFolder = o.outputs.folder();
    options_.artifacts = o.outputs.artifacts();
    command_.text = o.run;
    command_.timeout = o.timeout;
    command_.retries = o.retries;
    if (!o.run.empty()) command_.check();
    suite_.version = version();
    suite_.unit = "picture";
    suite_.expected = fs::path(o.expected).generic_string();
    suite_.command = o.command;
    suite_.strict = o.strict;
    suite_.allowFlaky = o.allowFlaky;
    suite_.shard = o.shard;
  }

  void run() {
    if (o_.list) return list();
    o_.outputs.prepare();
    makeFolders(o_.expected);
    frame::catchInterrupts();
    frame::ignoreBrokenPipes();
    int signal = 0;
    try {
      render();
      compare();
    } catch (const frame::Interrupted& interrupted) {
      signal = interrupted.signal;
    }
    finish(signal);
  }

 private:
  void list() {
    if (command_.eachScene()) {
      chooseScenes();
      for (const golden::SceneFile& scene : scenes_)
        printText(oneLine(scene.name) + "\t" + oneLine(command_.of(scene)) + "\n");
      return;
    }
    if (o_.actual.empty())
      fail(ExitCode::usage, "--list needs existing pictures; give their folder with --actual");
    folder_ = o_.actual;
    for (const golden::PictureCase& one : cases()) printText(oneLine(one.name) + "\n");
  }

  void chooseScenes() {
    if (o_.paths.empty())
      fail(ExitCode::usage, "--run with {{scene}} needs scenes: files or folders of them");
    std::erase_if(scenes_ = golden::findInputs(o_.paths),
                  [&](const golden::SceneFile& scene) { return !chosen(o_, scene.name); });
    if (scenes_.empty()) fail(ExitCode::nothingRan, "no scene matches --filter");
    takeShard(scenes_, "scene");
  }

  /// Reduces `all` to the items of this run's shard.
  template <class Item>
  void takeShard(std::vector<Item>& all, const char* unit) {
    if (o_.shard.empty()) return;
    const std::size_t whole = all.size();
    all = golden::shardOf(all, o_.shard);
    emptyShard_ = all.empty();
    shardNote_ = golden::shardNote(o_.shard, all.size(), whole, unit);
  }

  void render() {
    folder_ = o_.actual;
    if (o_.run.empty()) return;
    if (command_.eachScene()) chooseScenes();
    if (folder_.empty()) folder_ = temporary_.emplace().path();
    makeFolders(folder_);
    command_.folder = folder_;
    if (!command_.eachScene()) scenes_ = {{}};
    for (const golden::SceneFile& scene : scenes_)
      if (command_.eachScene()) inputs_[scene.name] = golden::inputsOf(scene.file, {});
    std::vector<std::size_t> all(scenes_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    ends_ = command_.runAll(scenes_, std::move(all), jobs_);
    if (!command_.eachScene() && ends_.front().mistake) throw UserError(*ends_.front().mistake);
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      if (!ends_[i].mistake) continue;
      golden::SceneResult result;
      result.name = scenes_[i].name;
      result.file = scenes_[i].file.generic_string();
      result.status = golden::Status::error;
      result.messages.emplace_back(ends_[i].mistake->what());
      addFailures(i, result);
      add(std::move(result), ends_[i].mistake->code());
    }
  }

  /// Adds the failed attempts of a scene's command to its result.
  void addFailures(std::size_t scene, golden::SceneResult& result) const {
    std::vector<golden::Attempt> attempts;
    for (const std::string& message : ends_[scene].failures)
      attempts.push_back({golden::Status::error, {message}});
    golden::addAttempts(std::move(attempts), result);
  }

  /// Returns the index of the scene from which a picture is rendered. Returns nullopt if no command of this
  /// run makes the picture.
  [[nodiscard]] std::optional<std::size_t> sceneOf(const std::string& picture) const {
    if (o_.run.empty()) return std::nullopt;
    if (!command_.eachScene()) return 0;
    const golden::SceneFile* owner = golden::ownerOf(picture, scenes_);
    if (owner == nullptr) return std::nullopt;
    return static_cast<std::size_t>(owner - scenes_.data());
  }

  [[nodiscard]] golden::PictureSet pairs() const {
    // A baseline without a scene can be reported as stale only if the run covers whole folders, without
    // filter or shard.
    std::error_code unknown;
    const bool whole = o_.globs.empty() && o_.shard.empty() &&
                       std::all_of(o_.paths.begin(), o_.paths.end(), [&](const std::string& path) {
                         return fs::is_directory(path, unknown);
                       });
    return golden::pairPictures(o_.expected, folder_, [&](const std::string& name, bool made) {
      if (!command_.eachScene()) return true;
      const auto scene = sceneOf(name);
      return scene ? made || !ends_[*scene].mistake : whole;
    });
  }

  /// Returns the selected pictures of the scenes that were rendered.
  std::vector<golden::PictureCase> cases() {
    golden::PictureSet set = pairs();
    if (!set.passedOver.empty())
      suite_.notes.push_back("skipped, not pictures: " + golden::someOf(set.passedOver));
    auto& all = set.cases;
    if (!command_.eachScene()) {
      for (std::string& unused : golden::unusedRules(options_.rules, all))
        suite_.notes.push_back(std::move(unused));
      std::erase_if(all, [&](const golden::PictureCase& one) { return !chosen(o_, one.name); });
      if (!all.empty()) takeShard(all, "picture");
      return std::move(all);
    }
    return std::move(all);
  }

  void compare() {
    const auto all = cases();
    if (all.empty() && suite_.scenes.empty() && !emptyShard_)
      fail(ExitCode::nothingRan, "no picture to test: neither {} nor {} has one{}", o_.expected,
           folder_.string(), o_.globs.empty() ? "" : " that matches --filter");
    // A picture whose baseline is being updated is not retried.
    const bool retries = o_.retries > 0 && options_.update == golden::Update::none;
    std::vector<golden::SceneResult> results;
    golden::testPictures(all, options_, [&](golden::SceneResult&& result) {
      if (retries)
        results.push_back(std::move(result));
      else
        tell(std::move(result));
    });
    for (int attempt = 0; retries && attempt < o_.retries; ++attempt) retry(results);
    for (golden::SceneResult& result : results) tell(std::move(result));
  }

  /// Renders the scenes of failed pictures again, and compares these pictures again.
  void retry(std::vector<golden::SceneResult>& results) {
    std::vector<golden::SceneResult*> failed;
    std::vector<std::size_t> chosen;
    for (golden::SceneResult& result : results) {
      const auto scene = sceneOf(result.name);
      const bool may = result.status == golden::Status::fail || result.status == golden::Status::error;
      if (!may || !scene || ends_[*scene].mistake) continue;
      failed.push_back(&result);
      if (std::find(chosen.begin(), chosen.end(), *scene) == chosen.end()) chosen.push_back(*scene);
    }
    if (failed.empty()) return;
    golden::RenderCommand once = command_;
    once.retries = 0;
    const auto ends = once.runAll(scenes_, chosen, jobs_);
    const std::vector<golden::PictureCase> again = pairs().cases;
    for (golden::SceneResult* result : failed) {
      std::vector<golden::Attempt> attempts = std::move(result->attempts);
      attempts.push_back({result->status, result->messages});
      const auto one = std::find_if(again.begin(), again.end(), [&](const golden::PictureCase& found) {
        return found.name == result->name;
      });
      const std::optional<UserError>& mistake = ends[*sceneOf(result->name)].mistake;
      if (one != again.end() && !mistake) {
        std::error_code ignored;
        if (!options_.artifacts.empty()) fs::remove_all(options_.artifacts / result->name, ignored);
        *result = golden::testPicture(*one, options_);
      } else if (mistake) {
        result->messages = {mistake->what()};
      }
      golden::addAttempts(std::move(attempts), *result);
    }
  }

  void tell(golden::SceneResult&& result) {
    const auto scene = sceneOf(result.name);
    if (scene) addFailures(*scene, result);
    nameScene(scene, result);
    add(std::move(result));
  }

  /// Sets the scene of a picture's result. A picture in a temporary folder is reported under the path of
  /// its baselines or its scene, which still exist later.
  void nameScene(std::optional<std::size_t> scene, golden::SceneResult& result) const {
    if (temporary_) result.file = result.baselines;
    if (!scene || !command_.eachScene()) return;
    const golden::SceneFile& owner = scenes_[*scene];
    if (temporary_) result.file = owner.file.generic_string();
    if (!result.candidate.empty()) result.inputs = inputs_.at(owner.name);
    if (golden::isFailure(result.status, false)) result.blame = {owner.file.generic_string(), 1};
  }

  void add(golden::SceneResult&& result, ExitCode error = ExitCode::inputOutput) {
    tally_.add(result.status, o_.allowFlaky, error);
    o_.outputs.print(result, suite_.unit, o_.allowFlaky);
    suite_.scenes.push_back(std::move(result));
  }

  void finish(int signal) {
    suite_.seconds = secondsSince(begin_);
    if (o_.strict && !suite_.notes.empty()) tally_.addFailure();
    if (!shardNote_.empty()) suite_.notes.push_back(shardNote_);
    o_.outputs.write(suite_);
    if (signal != 0) info("simreel: interrupted after {} pictures", suite_.scenes.size());
    // A shard without pictures counts as passed, because the other shards contain them.
    const ExitCode code = emptyShard_ && suite_.scenes.empty() ? ExitCode::ok : tally_.exitCode();
    setExitCode(signal != 0 ? 128 + signal : static_cast<int>(code));
  }

  const TestOptions& o_;
  Clock::time_point begin_;
  std::size_t jobs_ = 1;
  golden::PictureOptions options_;
  golden::RenderCommand command_;
  std::optional<TemporaryFolder> temporary_;
  fs::path folder_;  ///< folder that contains the tested pictures
  std::vector<golden::SceneFile> scenes_;
  std::map<std::string, golden::Inputs> inputs_;  ///< input files of each scene, by scene name
  std::vector<golden::CommandEnd> ends_;          ///< results of each scene's command
  bool emptyShard_ = false;
  std::string shardNote_;
  golden::Tally tally_;
  golden::SuiteResult suite_;
};

}  // namespace

void testPictures(const TestOptions& options) {
  PictureRun(options).run();
}

}  // namespace simreel::cli
