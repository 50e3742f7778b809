#pragma once
#include "golden/result.hpp"

#include <limits>
#include <string>

namespace simreel::golden::test {

inline FrameResult failedFrame(int frame, long beyond) {
  FrameResult f;
  f.frame = frame;
  f.time = frame / 30.0;
  f.status = Status::fail;
  f.message = "frame " + std::to_string(frame) + ": " + std::to_string(beyond) + " pixels differ";
  f.pixels = "aa" + std::to_string(frame);
  f.expectedPixels = "bb";
  f.alternate = 2;
  f.state = "different";
  f.asked = "equal";
  f.metrics = Metrics{200, 3, 4, 900, beyond, 0.25, 0.75, 16, 32, 21.5, 0.875, 0.0625};
  f.pass = PassPlace{"light", 3, 4, "triangle 12 of flag", "frame 2: the first pass that differs is light"};
  const std::string stem = "images/flag/" + std::to_string(frame);
  f.expectedImage = stem + "-expected.png";
  f.actualImage = stem + "-actual.png";
  f.differenceImage = stem + "-difference.png";
  return f;
}

inline SceneResult scene(const std::string& name, Status status) {
  SceneResult s;
  s.name = name;
  s.file = "assets/scenes/" + name + ".json";
  s.baselines = "tests/golden/" + name;
  s.status = status;
  s.profile = "llvmpipe-fma";
  s.seconds = 2.125;
  s.simulateSeconds = 1.5;
  FrameResult good;
  good.state = "equal";
  good.pixels = good.expectedPixels = "cc";
  good.metrics = Metrics{};
  good.metrics->psnr = std::numeric_limits<double>::infinity();
  s.frames = {good};
  return s;
}

/// Returns a scene result in which every member is set.
inline SceneResult failedScene() {
  SceneResult s = scene("flag", Status::fail);
  s.messages = {"frame 60: 312 pixels differ", "the state differs from frame 60 on"};
  s.notes = {"maxDiffRatio is 40 times looser than this run needs", "no baseline of nvidia-ada"};
  s.asked = "equal";
  s.baselineProcessor = "Testium 3";
  s.baselineDriver = "llvmpipe (LLVM 15.0.6, 256 bits)";
  s.baselineVersion = "0.1.0";
  s.baselineReason = "wind is stronger";
  s.tolerance = {{"maxChannelDiff", {12, "default"}}, {"maxDiffRatio", {0.02, "--max-diff-ratio"}}};
  s.repeats = 3;
  s.attempts = {{Status::fail, {"frame 60: 312 pixels differ", "and more"}}, {Status::error, {}}};
  s.frames.push_back(failedFrame(60, 312));
  s.frames.push_back(failedFrame(119, 700));
  s.checks = {{"energy of flag", 60, 3.1, -0.5, 3.0, false, "frame 60: energy of flag is 3.1, above 3"},
              {"not-blank", 0, {}, {}, {}, true, ""}};
  s.divergence =
      Divergence{-2, 3, 16, "flag", "positions", 4096, 5000000000L, "frame -2, step 3 of 16: flag"};
  s.candidate = "candidates/flag";
  s.inputs = {{"assets/scenes/flag.json", "dd"}, {"<assets>/silk.png", "ee"}};
  s.blame = Place{"assets/scenes/flag.json", 12};
  return s;
}

/// Returns a suite with one scene for each status. Every member of every struct is set in some scene.
inline SuiteResult fullSuite() {
  SuiteResult suite;
  suite.version = "0.1.0";
  suite.driver = "llvmpipe (LLVM 15.0.6, 256 bits)";
  suite.profile = "llvmpipe-fma";
  suite.fingerprint = "0123456789abcdef";
  suite.processor = "Testium 4";
  suite.drawing = "fedcba9876543210";
  suite.memoryPath = "texel";
  suite.command = "simreel test assets/scenes --report out";
  suite.acceptCommand = "simreel accept out/report.json";
  suite.shard = "2/4";
  suite.seconds = 6.25;
  suite.scenes = {scene("waves", Status::pass), failedScene()};
  for (const Status status : {Status::updated, Status::xfail, Status::flaky, Status::nondeterministic,
                              Status::missing, Status::xpass, Status::error})
    suite.scenes.push_back(scene(std::string("is-") + statusName(status), status));
  suite.scenes[3].xfail = "issue 12: folds flicker";
  suite.scenes[4].attempts = {{Status::fail, {"frame 9: 5 pixels differ"}}};
  suite.scenes[6].messages = {"no baseline; run simreel test --update"};
  suite.scenes[8].messages = {"assets/scenes/is-error.json:3:4: unknown key"};
  return suite;
}

/// Text for names and messages, with characters that need escaping.
inline const std::string odd =
    "a\"b'\\ </script> ]]> & <b> | ` *x* 100% a,b:c\r\nsecond\tline \x1B[31m\x01 caf\xC3\xA9 \xE2\x82\xAC";
inline const std::string notUtf8 = "bad \xFF\xFE \xC3( \xED\xA0\x80 \xF0\x9F end \xE2\x82";

inline SuiteResult oddSuite() {
  SuiteResult suite = fullSuite();
  SceneResult& s = suite.scenes[1];
  s.name = s.file = s.messages[0] = s.notes[0] = s.checks[0].message = s.divergence->message = odd;
  s.messages.push_back("frame 1\n::error::injected\n\n```\n# heading");
  s.frames[1].message = suite.driver = suite.command = odd;
  s.tolerance[odd] = {1, odd};
  return suite;
}

/// Returns oddSuite() with invalid UTF-8 in names and messages.
inline SuiteResult brokenSuite() {
  SuiteResult suite = oddSuite();
  SceneResult& s = suite.scenes[1];
  s.name = s.file = s.messages[1] = s.notes[1] = s.frames[1].message = s.baselineReason = notUtf8;
  s.checks[0].message = s.divergence->message = s.attempts[0].messages[0] = notUtf8;
  suite.driver = suite.acceptCommand = notUtf8;
  return suite;
}

}  // namespace simreel::golden::test
