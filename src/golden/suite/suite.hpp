#pragma once
#include "base/error.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/compare/compare.hpp"
#include "golden/result.hpp"
#include "golden/suite/scene_run.hpp"
#include "golden/suite/scene_set.hpp"
#include "golden/update.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace simreel::golden {

struct SuiteOptions {
  int repeats = 2;  ///< runs of each scene, which have to agree
  int retries = 0;  ///< further tries of a scene that fails
  bool allowFlaky = false;
  Measures measures = Measures::all;  ///< quick: SSIM and FLIP only where a verdict needs them
  Update update = Update::none;
  std::string reason;                          ///< kept in baselines that are written
  std::string profile;                         ///< instead of the driver's own; empty: that
  std::vector<std::filesystem::path> assets;   ///< folders that scenes may read beside the usual ones
  std::map<std::string, double> tolerance;     ///< bounds from the command line, by field name
  std::filesystem::path reportFolder;          ///< of report.json; image paths are relative to it
  std::filesystem::path artifacts;             ///< pictures of failures go below it; empty: nowhere
  std::vector<std::filesystem::path> orphans;  ///< folders of baselines whose scene is gone
};

/// The device of this run.
struct Device {
  Origin origin;  ///< of the pictures it draws
  std::string profile, memoryPath;
  std::string inexact;  ///< why exact numerics do not hold; empty: they do
};

/// Runs a scene on the current context, compares and, where asked, updates. A mistake in the scene or its
/// baseline, or a lost device, is the scene's result; only Interrupted leaves. `losses`: processes that
/// ended with this scene in hand before, each of which was a try.
[[nodiscard]] Outcome testScene(const SceneFile& scene, const SuiteOptions& options, const Device& device,
                                int losses = 0);

/// Puts failed tries before those of a result, which is flaky where it passed. `losses`: tries before them
/// that are added later.
void addAttempts(std::vector<Attempt> attempts, SceneResult& result, int losses = 0);

/// Puts tries whose processes ended, with what each said of it, before those of a scene that was then done.
void addLosses(const std::vector<std::string>& losses, Outcome& made);

}  // namespace simreel::golden
