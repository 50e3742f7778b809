#include "golden/report/text.hpp"
#include "unit/frame/help.hpp"
#include "unit/golden/suite.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;
using frame::test::contains;

TEST_CASE("console: a passed scene is one line") {
  SceneResult scene = golden::test::scene("flag", Status::pass);
  scene.messages = {"never shown"};
  CHECK(sceneLine(scene) == "pass  flag  (1 frame, 2.1 s)\n");
  scene.frames.resize(3);
  scene.status = Status::xfail;
  scene.xfail = "issue 12";
  CHECK(sceneLine(scene) == "xfail  flag  (3 frames, 2.1 s: issue 12)\n");
  scene.status = Status::updated;
  scene.notes = {"no baseline of nvidia-ada"};
  CHECK(sceneLine(scene) == "updated  flag  (3 frames, 2.1 s)\n      note: no baseline of nvidia-ada\n");
}

TEST_CASE("console: a failed scene prints the reason and the pictures' paths") {
  SceneResult scene = golden::test::failedScene();
  scene.frames.pop_back();
  scene.frames[1].differenceImage = "";
  scene.attempts.clear();
  CHECK(sceneLine(scene, false, "out") ==
        "FAIL  flag  (2 frames, 2.1 s)\n"
        "      frame 60: 312 pixels differ\n"
        "      the state differs from frame 60 on\n"
        "      frame 60: energy of flag is 3.1, above 3\n"
        "      frame -2, step 3 of 16: flag\n"
        "      pictures of frame 60: expected out/images/flag/60-expected.png, actual "
        "out/images/flag/60-actual.png\n"
        "      note: maxDiffRatio is 40 times looser than this run needs\n"
        "      note: no baseline of nvidia-ada\n");
  CHECK(contains(sceneLine(scene), "expected images/flag/60-expected.png"));
  CHECK(sceneLine(golden::test::scene("a", Status::nondeterministic)) ==
        "NONDETERMINISTIC  a  (1 frame, 2.1 s)\n      two runs of the same program differ\n");
}

TEST_CASE("console: a flaky scene lists its failed attempts") {
  CHECK(sceneLine(golden::test::fullSuite().scenes[4]) ==
        "flaky  is-flaky  (1 frame, 2.1 s: failed, then passed on attempt 2)\n"
        "      attempt 1: frame 9: 5 pixels differ\n");
}

TEST_CASE("console: colours appear only on request, and no text controls the terminal") {
  const SceneResult scene = golden::test::scene("flag", Status::fail);
  CHECK(!contains(sceneLine(scene), "\x1B"));
  CHECK(sceneLine(scene, true).starts_with("\x1B[1;31mFAIL\x1B[0m  flag"));
  CHECK(
      sceneLine(golden::test::scene("flag", Status::pass), true).starts_with("\x1B[32mpass\x1B[0m  flag"));
  const SuiteResult odd = golden::test::brokenSuite();
  for (const SceneResult& one : odd.scenes)
    CHECK(sceneLine(one).find_first_of("\x1B\x01\r\xFF") == std::string::npos);
  CHECK(closingText(odd).find_first_of("\x1B\x01\r\xFF") == std::string::npos);
  CHECK(contains(sceneLine(golden::test::oddSuite().scenes[1]),
                 "\n      ::error::injected\n      \n      ```\n"));
}

TEST_CASE("console: the closing lines give totals") {
  SuiteResult suite;
  suite.seconds = 6.2;
  suite.scenes = {golden::test::scene("a", Status::pass), golden::test::scene("flag", Status::fail),
                  golden::test::scene("b", Status::pass)};
  CHECK(closingText(suite) == "3 scenes: 2 passed, 1 failed (flag) in 6.2 s\n");
  suite.acceptCommand = "simreel accept out/report.json";
  CHECK(closingText(suite, false, "out/index.html") ==
        "3 scenes: 2 passed, 1 failed (flag) in 6.2 s\nTo accept: simreel accept out/report.json\n"
        "Report: out/index.html\n");
  CHECK(
      contains(closingText(suite, true), ": \x1B[32m2 passed\x1B[0m, \x1B[1;31m1 failed (flag)\x1B[0m in"));
  CHECK(closingText(SuiteResult{}) == "0 scenes in 0.0 s\n");
  suite = SuiteResult{};
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g"})
    suite.scenes.push_back(golden::test::scene(name, Status::missing));
  CHECK(closingText(suite) == "7 scenes: 7 without baseline (a, b, c, d, e and 2 more) in 0.0 s\n");
  CHECK(
      closingText(golden::test::fullSuite()) ==
      "9 scenes: 1 passed, 1 updated, 1 failed as expected, 1 flaky (is-flaky), 1 failed (flag), 1 "
      "nondeterministic (is-nondeterministic), 1 without baseline (is-missing), 1 passed unexpectedly "
      "(is-xpass), 1 could not be tested (is-error) in 6.2 s\nTo accept: simreel accept out/report.json\n");
}
