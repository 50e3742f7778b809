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

/// One attempt at testing a scene. Runs the scene, repeats the run, judges the results, updates baselines,
/// and stores files for the report.
class SceneTest {
 public:
  /// `attempt` counts from 1. With retries, each attempt stores its pictures in a separate folder.
  SceneTest(const SceneFile& file, const SuiteOptions& options, const Device& device, int attempt);
  ~SceneTest();
  SceneTest(SceneTest&&) = delete;
  SceneTest& operator=(SceneTest&&) = delete;
  SceneTest(const SceneTest&) = delete;
  SceneTest& operator=(const SceneTest&) = delete;
  /// Throws UserError if the scene cannot be tested.
  void run();
  [[nodiscard]] SceneResult& result() { return result_; }
  /// True if a pixel differs by more than the scene's hardFail, which neither retries nor xfail permit.
  [[nodiscard]] bool hardFailed() const;
  /// Returns the scene's baselines that no test uses.
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
  /// Returns the folder for this attempt's pictures.
  [[nodiscard]] std::filesystem::path artifacts() const;
  [[nodiscard]] bool stateIs(const char* what) const;
  [[nodiscard]] bool checkFails() const;
  [[nodiscard]] std::string profileToPromote() const;
  [[nodiscard]] Candidate candidate(bool withSteps);
  /// Returns the pass hashes of every frame. Draws the frames again if they are not known yet.
  const std::map<int, PassHashes>& passes();
  /// Writes a picture below artifacts(). Returns its path relative to the report.
  [[nodiscard]] std::string keep(const std::string& name, const frame::Image& image) const;

  SceneFile file_;
  const SuiteOptions& options_;
  const Device& device_;
  int attempt_;
  scene::Scene scene_;
  bool exactPictures_ = false;  ///< true if pictures are equal on every machine
  Origin origin_;               ///< origin of this run's pictures
  std::string profile_;         ///< profile whose baselines are tried first
  std::vector<int> frames_;
  Reference reference_;
  SceneRun run_;
  /// A group of runs with equal results that differ from the results of the first run.
  struct OtherRun {
    std::vector<int> numbers;
    SceneRun run;
  };
  std::vector<OtherRun> others_;
  std::vector<int> likeFirst_ = {1};  ///< numbers of the runs whose results equal those of the first run,
                                      ///< including the first run
  int uncounted_ = 0;                 ///< number of differing runs that are not stored in others_
  std::set<int> failedPictures_;
  std::optional<StepTrace> steps_;  ///< step trace of the baseline
  Inputs inputs_;
  bool damaged_ = false;  ///< true if a file of the baseline is unusable
  bool damagedSteps_ = false;
  std::vector<Stale> stale_;
  std::map<int, PassHashes> passes_;  ///< pass hashes of each frame; filled by passes()
  SceneResult result_;
};

}  // namespace simreel::golden
