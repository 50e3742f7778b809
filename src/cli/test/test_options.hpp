#pragma once
#include "cli/options/allowance_options.hpp"
#include "cli/options/tolerance_options.hpp"
#include "cli/test/outputs.hpp"
#include "gl/context.hpp"
#include "golden/compare/compare.hpp"
#include "golden/update.hpp"

#include <string>
#include <vector>

namespace simreel::cli {

struct TestOptions {
  std::vector<std::string> paths;
  std::vector<std::string> globs;
  std::vector<std::string> assets;
  std::string shard;
  std::string jobs = "1";
  int repeat = 2;
  int retries = 0;
  double timeout = 0;
  bool quick = false;
  bool allowFlaky = false;
  bool strict = false;
  TestOutputs outputs;
  std::string update;
  bool updateGiven = false;
  std::string reason, profile;
  gl::ContextOptions on;
  bool list = false;
  ToleranceOptions tolerance;
  // The following options apply to pictures, not to scenes.
  std::string expected, actual, run, rules;
  AllowanceOptions allowance;
  std::string command;  ///< command line as typed

  [[nodiscard]] golden::Update updateMode() const;
  /// Returns the selected metrics. Throws UserError(usage).
  [[nodiscard]] golden::Measures measures() const;
};

/// Runs `simreel test SCENES`.
void testScenes(const TestOptions& options);

/// Runs `simreel test --expected DIR ...` on pictures that any program made. Needs no device.
void testPictures(const TestOptions& options);

}  // namespace simreel::cli
