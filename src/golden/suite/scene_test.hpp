#pragma once
#include "golden/baseline/inputs.hpp"
#include "golden/suite/judge.hpp"
#include "golden/suite/suite.hpp"
#include "golden/trace/passes.hpp"
#include "golden/trace/trace.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simreel::golden {

/// One try at one scene: run, repeat, judge, update, keep what a report needs.
class SceneTest {
 public:
  /// `attempt` counts from 1: each keeps its pictures in a folder of its own where there may be several.
  SceneTest(const SceneFile& file, const SuiteOptions& options, const Device& device, int attempt);
  ~SceneTest();
  SceneTest(SceneTest&&) = delete;
  SceneTest& operator=(SceneTest&&) = delete;
  SceneTest(const SceneTest&) = delete;
  SceneTest& operator=(const SceneTest&) = delete;
  /// Throws UserError for what makes the scene unusable.
  void run();
  [[nodiscard]] SceneResult& result() { return result_; }
  /// Whether some pixel is beyond the scene's hardFail, which nothing excuses.
  [[nodiscard]] bool hardFailed() const;
  /// What of the scene's baselines nothing is tested against.
  [[nodiscard]] std::vector<Stale>& stale() { return stale_; }

 private:
  void load();
  void describeBaseline();
  void noteUnused();
  void resolveTolerance();
  void repeat();
  void judge();
  void readStepsOfBaseline();
  void locate();
  void findFormerName();
  void locatePasses();
  void update();
  void takeFormerBaseline();
  void judgeAgain(const std::string& profile);
  void keepPictures();
  void keepPicture(FrameResult& frame, const frame::Image& made);
  [[nodiscard]] bool keepRuns(std::size_t index);
  void keepCandidate();
  /// The folder of this attempt's pictures.
  [[nodiscard]] std::filesystem::path artifacts() const;
  [[nodiscard]] bool stateIs(const char* what) const;
  [[nodiscard]] bool checkFails() const;
  [[nodiscard]] std::string profileToPromote() const;
  [[nodiscard]] Candidate candidate(bool withSteps);
  /// Of every frame, drawn once more where that is not known yet.
  const std::map<int, PassHashes>& passes();
  /// Writes below the artifacts; the path is relative to the report.
  [[nodiscard]] std::string keep(const std::string& name, const frame::Image& image) const;

  SceneFile file_;
  const SuiteOptions& options_;
  const Device& device_;
  int attempt_;
  scene::Scene scene_;
  bool exactPictures_ = false;  ///< the same on every machine
  Origin origin_;               ///< of the pictures
  std::string profile_;         ///< of the baselines that are asked for first
  std::vector<int> frames_;
  Reference reference_;
  SceneRun run_;
  /// Runs that came out alike, but not as the first.
  struct OtherRun {
    std::vector<int> numbers;
    SceneRun run;
  };
  std::vector<OtherRun> others_;
  std::vector<int> likeFirst_ = {1};  ///< runs that came out as the first, with it
  int uncounted_ = 0;                 ///< further ones, which are not in others_
  std::set<int> failedPictures_;
  std::optional<StepTrace> steps_;  ///< of the baseline
  Inputs inputs_;
  bool damaged_ = false;  ///< some file of the baseline cannot be used
  bool damagedSteps_ = false;
  std::vector<Stale> stale_;
  std::map<int, PassHashes> passes_;  ///< filled when somebody asks
  SceneResult result_;
};

}  // namespace simreel::golden
