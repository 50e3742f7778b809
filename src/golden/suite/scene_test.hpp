#pragma once
#include "golden/suite/judge.hpp"
#include "golden/suite/suite.hpp"
#include "golden/trace/passes.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simreel::golden {

/// One try at one scene: run, repeat, judge, update, keep what a report needs.
class SceneTest {
 public:
  SceneTest(const SceneFile& file, const SuiteOptions& options, const Device& device);
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

 private:
  void load();
  void describeBaseline();
  void noteUnused();
  void resolveTolerance();
  void repeat();
  void judge();
  void locate();
  void locatePasses();
  void update();
  void keepPictures();
  void keepPicture(FrameResult& frame, const frame::Image& made);
  void keepCandidate();
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
  scene::Scene scene_;
  bool exactPictures_ = false;  ///< the same on every machine
  Origin origin_;               ///< of the pictures
  std::string profile_;         ///< of the baselines that are asked for first
  std::vector<int> frames_;
  Reference reference_;
  SceneRun run_;
  std::optional<SceneRun> other_;  ///< a run that differs from the first
  std::set<int> failedPictures_;
  std::map<int, PassHashes> passes_;  ///< filled when somebody asks
  SceneResult result_;
};

}  // namespace simreel::golden
