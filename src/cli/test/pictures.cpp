// simreel test --expected DIR (--actual DIR | --run COMMAND): pictures of any program against their
// baselines.
#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/job_count.hpp"
#include "cli/test/test_options.hpp"
#include "frame/interrupt.hpp"
#include "golden/baseline/inputs.hpp"
#include "golden/pictures/picture_folder.hpp"
#include "golden/pictures/picture_test.hpp"
#include "golden/pictures/render_command.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// A folder that goes when it does.
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
    fail(ExitCode::usage, "{} belongs to pictures; give --expected, the folder of their baselines",
         !o.run.empty()      ? "--run"
         : !o.actual.empty() ? "--actual"
                             : "--rules");
  if (o.actual.empty() && o.run.empty())
    fail(ExitCode::usage,
         "--expected needs --actual, the folder of the pictures, or --run, a command that makes them");
  if (o.run.empty() && !o.paths.empty())
    fail(ExitCode::usage, "{} is given beside --expected; scenes go with --run", o.paths.front());
  if (!o.paths.empty() && o.run.find("{scene}") == std::string::npos)
    fail(ExitCode::usage, "{} is given, but the command of --run has no {{scene}} to put it in",
         o.paths.front());
  if (!o.shard.empty() && o.updateMode() == golden::Update::prune)
    fail(ExitCode::usage,
         "--update=prune has to know all pictures, and --shard leaves some out; give one of them");
  if (!o.profile.empty() || !o.reason.empty() || o.retries > 0 || o.timeout > 0)
    fail(ExitCode::usage, "--profile, --reason, --retries and --timeout are for scenes, not for pictures");
  std::error_code unknown;
  if (!fs::is_directory(o.expected, unknown) && o.updateMode() != golden::Update::all &&
      o.updateMode() != golden::Update::missing)
    fail(ExitCode::usage, "--expected {} is no folder; with --update it is made", o.expected);
  if (o.run.empty() && !fs::is_directory(o.actual, unknown))
    fail(ExitCode::usage, "--actual {} is no folder", o.actual);
  if (fs::equivalent(o.expected, o.actual, unknown))
    fail(ExitCode::usage, "--expected and --actual are the same folder {}", o.expected);
}

/// The rules of the file and, stronger, of the command line.
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

/// One run of the test.
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
    if (!o.run.empty()) command_.check();
    suite_.version = version();
    suite_.unit = "picture";
    suite_.expected = fs::path(o.expected).generic_string();
    suite_.command = o.command;
    suite_.strict = o.strict;
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
      fail(ExitCode::usage, "--list knows the pictures once --run has made them; give --actual");
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

  /// The part of this run.
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
    if (!command_.eachScene()) {
      if (const auto mistake = command_.runAll({{}}, 1).front()) throw UserError(*mistake);
      return;
    }
    for (const golden::SceneFile& scene : scenes_) inputs_[scene.name] = golden::inputsOf(scene.file, {});
    const auto mistakes = command_.runAll(scenes_, jobs_);
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      if (!mistakes[i]) continue;
      golden::SceneResult result;
      result.name = scenes_[i].name;
      result.file = scenes_[i].file.generic_string();
      result.status = golden::Status::error;
      result.messages.emplace_back(mistakes[i]->what());
      failed_.push_back(scenes_[i].name);
      add(std::move(result), mistakes[i]->code());
    }
  }

  /// Those that were chosen, of scenes that were rendered.
  std::vector<golden::PictureCase> cases() {
    golden::PictureSet set = golden::pairPictures(o_.expected, folder_);
    if (!set.passedOver.empty())
      suite_.notes.push_back("passed over, no pictures: " + golden::someOf(set.passedOver));
    auto& all = set.cases;
    if (!command_.eachScene()) {
      for (std::string& unused : golden::unusedRules(options_.rules, all))
        suite_.notes.push_back(std::move(unused));
      std::erase_if(all, [&](const golden::PictureCase& one) { return !chosen(o_, one.name); });
      if (!all.empty()) takeShard(all, "picture");
      return std::move(all);
    }
    const bool whole = o_.globs.empty() && o_.shard.empty();
    std::erase_if(all, [&](const golden::PictureCase& one) {
      const golden::SceneFile* owner = golden::ownerOf(one.name, scenes_);
      if (owner == nullptr) return !whole;  // of a scene that is gone, or was not chosen
      return one.actual.empty() && std::find(failed_.begin(), failed_.end(), owner->name) != failed_.end();
    });
    return std::move(all);
  }

  void compare() {
    const auto all = cases();
    if (all.empty() && suite_.scenes.empty() && !emptyShard_)
      fail(ExitCode::nothingRan, "no picture to test: neither {} nor {} has one{}", o_.expected,
           folder_.string(), o_.globs.empty() ? "" : " that matches --filter");
    golden::testPictures(all, options_, [&](golden::SceneResult&& result) {
      if (command_.eachScene()) nameScene(result);
      add(std::move(result));
    });
  }

  /// What a picture was rendered from.
  void nameScene(golden::SceneResult& result) const {
    const golden::SceneFile* owner = golden::ownerOf(result.name, scenes_);
    if (owner == nullptr) return;
    if (!result.candidate.empty()) result.inputs = inputs_.at(owner->name);
    if (golden::isFailure(result.status, false)) result.blame = {owner->file.generic_string(), 1};
  }

  void add(golden::SceneResult&& result, ExitCode error = ExitCode::inputOutput) {
    tally_.add(result.status, false, error);
    o_.outputs.show(result, suite_.unit);
    suite_.scenes.push_back(std::move(result));
  }

  void finish(int signal) {
    suite_.seconds = secondsSince(begin_);
    if (o_.strict && !suite_.notes.empty()) tally_.addFailure();
    if (!shardNote_.empty()) suite_.notes.push_back(shardNote_);
    o_.outputs.write(suite_);
    if (signal != 0) info("simreel: interrupted after {} pictures", suite_.scenes.size());
    // A part that no picture falls into is tested well: the other parts have them.
    const ExitCode code = emptyShard_ && suite_.scenes.empty() ? ExitCode::ok : tally_.exitCode();
    setExitCode(signal != 0 ? 128 + signal : static_cast<int>(code));
  }

  const TestOptions& o_;
  Clock::time_point begin_;
  std::size_t jobs_ = 1;
  golden::PictureOptions options_;
  golden::RenderCommand command_;
  std::optional<TemporaryFolder> temporary_;
  fs::path folder_;  ///< of the pictures
  std::vector<golden::SceneFile> scenes_;
  std::map<std::string, golden::Inputs> inputs_;  ///< by scene
  std::vector<std::string> failed_;               ///< scenes whose command failed
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
