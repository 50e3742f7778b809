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
  int repeats = 2;  ///< number of runs of each scene; their results must be equal
  int retries = 0;  ///< number of further attempts for a scene that fails
  bool allowFlaky = false;
  Measures measures = Measures::all;  ///< selection of measurements; with `quick`, SSIM and FLIP are
                                      ///< measured only if a verdict needs them
  Update update = Update::none;
  std::string reason;                          ///< reason for the update, stored in the baselines
  std::string profile;                         ///< profile to use instead of the driver's profile; may be
                                               ///< empty
  std::vector<std::filesystem::path> assets;   ///< additional folders that scenes may read
  std::map<std::string, double> tolerance;     ///< bounds from the command line, by field name
  std::filesystem::path reportFolder;          ///< folder of report.json; image paths are relative to it
  std::filesystem::path artifacts;             ///< folder for pictures of failures; if empty, no pictures
                                               ///< are stored
  std::vector<std::filesystem::path> orphans;  ///< baseline folders whose scene does not exist
};

/// Properties of the device that runs the tests.
struct Device {
  Origin origin;  ///< origin of the pictures that it draws
  std::string profile, memoryPath;
  std::string inexact;  ///< reason why the device does not support exact numerics; empty if it supports
                        ///< them
};

/// Tests a scene on the current context and optionally updates its baseline. A mistake in the scene or its
/// baseline and a lost device become the scene's result. Only Interrupted is thrown. `losses`: number of
/// earlier processes that died while testing this scene. Each counts as an attempt.
[[nodiscard]] Outcome testScene(const SceneFile& scene, const SuiteOptions& options, const Device& device,
                                int losses = 0);

/// Inserts failed attempts before the attempts of a result. A result that passed becomes flaky. `losses`:
/// number of attempts before these, which are added later.
void addAttempts(std::vector<Attempt> attempts, SceneResult& result, int losses = 0);

/// Inserts an attempt for each process that died while testing the scene, before the scene's other
/// attempts. `losses`: messages of these processes.
void addLosses(const std::vector<std::string>& losses, Outcome& made);

}  // namespace simreel::golden
