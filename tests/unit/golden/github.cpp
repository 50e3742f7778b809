#include "golden/report/github.hpp"

#include "golden/report/markdown.hpp"
#include "golden/report/words.hpp"
#include "unit/frame/help.hpp"
#include "unit/golden/suite.hpp"

#include <algorithm>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;
using frame::test::contains;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

long linesWith(const std::string& text, const std::string& start) {
  const auto lines = linesOf(text);
  return std::count_if(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.starts_with(start); });
}

}  // namespace

TEST_CASE(
    "control characters in text are replaced, long text is cut between characters, and counts have "
    "plurals") {
  CHECK(cleanText("a\r\nb\rc\td") == "a\nb\nc\td");
  CHECK(cleanText("\x1B[0m\x7F|") == "\xEF\xBF\xBD[0m\xEF\xBF\xBD|");
  CHECK(cleanText("\xC2\x85\xC2\xA0\xEF\xBF\xBE\xEF\xBF\xBD") ==
        "\xEF\xBF\xBD\xC2\xA0\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(cleanText(std::string("\0\xC3", 2)) == "\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(cleanText("\xF0\x9F\x8E\x88") == "\xF0\x9F\x8E\x88");
  CHECK(firstLine("a b\nc") == "a b");
  CHECK(firstLine("") == "");
  CHECK(shortened("abcdef", 6) == "abcdef");
  CHECK(shortened("abcdefg", 6) == "abc...");
  CHECK(shortened("ab\xC3\xA9"
                  "defg",
                  6) == "ab...");
  CHECK(counted(1, "scene") == "1 scene");
  CHECK(counted(0, "scene") == "0 scenes");
}

TEST_CASE("annotations: each failing scene is an error with the command that accepts it") {
  const std::string text = githubAnnotations(golden::test::fullSuite());
  CHECK(linesOf(text)[0] ==
        "::error file=assets/scenes/flag.json,line=12,title=simreel%3A flag (fail)::frame 60: 312 pixels "
        "differ%0A"
        "To accept: simreel accept out/report.json");
  CHECK(linesWith(text, "::error file=") == 6);
  CHECK(linesWith(text,
                  "::warning file=assets/scenes/flag.json,line=12,title=simreel%3A flag (tolerance)::"
                  "maxDiffRatio is 40 times looser") == 1);
  CHECK(linesWith(text, "::warning") == 1);
  CHECK(linesWith(text, "::notice file=assets/scenes/is-updated.json,") == 1);
  CHECK(linesWith(text, "::") == 8);
  CHECK(!contains(text, "waves"));
  CHECK(!contains(text, "is-xfail"));
}

TEST_CASE("annotations: an allowed flaky scene is a warning") {
  SuiteResult suite = golden::test::fullSuite();
  suite.allowFlaky = true;
  suite.acceptCommand = "";
  const std::string text = githubAnnotations(suite);
  CHECK(linesWith(text, "::error") == 5);
  CHECK(linesWith(text,
                  "::warning file=assets/scenes/is-flaky.json,title=simreel%3A is-flaky (flaky)::failed, "
                  "then passed on attempt 2") == 1);
  CHECK(!contains(text, "To accept"));
}

TEST_CASE("annotations: each annotation is one line for any names") {
  SuiteResult suite = golden::test::oddSuite();
  suite.scenes = {suite.scenes[1]};
  suite.scenes[0].notes.clear();
  suite.scenes[0].file = "./a,b:c%\n.json";
  suite.scenes[0].blame.reset();
  suite.acceptCommand = "simreel accept\n::stop-commands::x";
  const std::string text = githubAnnotations(suite);
  CHECK(linesOf(text).size() == 1);
  CHECK(text.starts_with("::error file=a%2Cb%3Ac%25%0A.json,title="));
  CHECK(contains(text, "100%25 a,b:c%0ATo accept: simreel accept%0A::stop-commands::x\n"));
  for (const SuiteResult& odd : {golden::test::oddSuite(), golden::test::brokenSuite()})
    for (const std::string& line : linesOf(githubAnnotations(odd))) {
      CHECK(line.starts_with("::"));
      CHECK(line.find_first_of("\r\x1B\xFF") == std::string::npos);
    }
}

TEST_CASE("annotations: nine annotations of a kind are written, and one with the count of the rest") {
  SuiteResult suite;
  const auto fill = [&](Status status, int count) {
    for (int i = 0; i < count; ++i)
      suite.scenes.push_back(golden::test::scene("s" + std::to_string(i), status));
  };
  fill(Status::fail, 10);
  fill(Status::updated, 30);
  CHECK(linesWith(githubAnnotations(suite), "::error file=") == 10);
  fill(Status::fail, 1);
  const std::string text = githubAnnotations(suite);
  CHECK(linesWith(text, "::error file=") == 9);
  CHECK(linesWith(text, "::error title=simreel::2 more; the summary and the report have all") == 1);
  CHECK(linesWith(text, "::notice file=") == 9);
  CHECK(linesWith(text, "::notice title=simreel::21 more;") == 1);
}

TEST_CASE("summary: pictures of the worst frame are embedded up to the size limit") {
  SuiteResult suite = golden::test::fullSuite();
  const auto plain = [](const std::string& picture) { return "at/" + picture; };
  CHECK(contains(markdownSummary(suite, plain),
                 "\n| Scene | Before | After | Difference |\n|---|---|---|---|\n"
                 "| flag | <img src=\"at/images/flag/119-expected.png\" width=\"160\" alt=\"before "
                 "(images/flag/119-expected.png)\"> | <img src=\"at/images/flag/119-actual.png\""));
  CHECK(!contains(markdownSummary(suite), "<img"));
  CHECK(!contains(markdownSummary(suite, [](const std::string&) { return std::string(); }), "<img"));
  suite.scenes.assign(40, golden::test::failedScene());
  const std::string text =
      markdownSummary(suite, [](const std::string&) { return std::string(20'000, 'x'); });
  CHECK(text.size() < 1'000'000);
  CHECK(text.size() > 900'000);
  const long shown = linesWith(text, "| flag | <img");
  CHECK(shown > 10);
  CHECK(contains(text, fmt::format("\nPictures of {} more are in the report.\n", 40 - shown)));
  suite.scenes.assign(60, golden::test::failedScene());
  CHECK(linesWith(markdownSummary(suite, plain), "| flag | <img") == 50);
}

TEST_CASE("summary: it has a heading, a table, a command and the passed scenes") {
  const std::string text = markdownSummary(golden::test::fullSuite());
  CHECK(text.starts_with(
      "## simreel: 6 of 9 scenes failed\n\n1 pass, 1 updated, 1 xfail, 1 flaky, 1 fail, "));
  CHECK(contains(
      text,
      "\n| Status | Scene | Frame | Worst | Pixels beyond | SSIM | FLIP | First divergence | "
      "Message |\n|---|---|--:|--:|--:|--:|--:|---|---|\n"
      "| fail | flag | 119 | 200 | 700 (25.00%) | 0.8750 | 0.0625 | frame -2, step 3 of 16: flag | "
      "frame 60: 312 pixels differ |\n"));
  CHECK(contains(text,
                 "| missing | is-missing | – | – | – | – | – | – | no baseline; run simreel test "
                 "--update |\n"));
  CHECK(linesWith(text, "| ") == 7);
  CHECK(contains(text, "\n```sh\nsimreel accept out/report.json\n```\n"));
  CHECK(contains(text, "<details><summary>3 scenes did not fail</summary>\n\n- waves: pass (2.1 s)\n"));
  SuiteResult good;
  good.scenes = {golden::test::scene("waves", Status::pass)};
  CHECK(markdownSummary(good).starts_with("## simreel: 1 scene good\n"));
  CHECK(!contains(markdownSummary(good), "| Status"));
  CHECK(!contains(markdownSummary(good), "```"));
}

TEST_CASE("summary: names and messages are escaped, not interpreted as Markdown") {
  SuiteResult suite = golden::test::oddSuite();
  suite.scenes = {suite.scenes[1]};
  suite.acceptCommand = "simreel accept ```` x";
  const std::string text = markdownSummary(suite);
  CHECK(!contains(text, "<b>"));
  CHECK(!contains(text, "</script>"));
  CHECK(contains(text, "&#60;b&#62; &#124; &#96; &#42;x&#42; 100% a,b:c second line"));
  CHECK(contains(text, "\n`````sh\nsimreel accept ```` x\n`````\n"));
  for (const std::string& line : linesOf(text))
    if (line.starts_with("| fail")) CHECK(std::count(line.begin(), line.end(), '|') == 10);
}

TEST_CASE("summary: thousands of scenes stay within GitHub's size limit") {
  SuiteResult suite;
  const std::string longWords(2000, '|');
  for (int i = 0; i < 3000; ++i) {
    suite.scenes.push_back(golden::test::scene(fmt::format("failing-{:04}", i), Status::fail));
    suite.scenes.back().messages = {longWords};
    suite.scenes.push_back(golden::test::scene(fmt::format("passing-{:04}", i) + longWords, Status::pass));
  }
  suite.driver = longWords;
  suite.acceptCommand = std::string(40000, 'x');
  const std::string text = markdownSummary(suite);
  CHECK(text.size() < 1'000'000);
  CHECK(text.size() > 900'000);
  const long shown = linesWith(text, "| fail ");
  CHECK(shown > 400);
  CHECK(contains(text, fmt::format("\n{} more failing scenes are left out here; report.json has all.\n",
                                   3000 - shown)));
  CHECK(contains(
      text, fmt::format("\n{} more good scenes are left out here", 3000 - linesWith(text, "- passing"))));
  CHECK(text.ends_with("</details>\n"));
  suite.acceptCommand = std::string(2'000'000, 'x');
  CHECK(markdownSummary(suite).size() < 1'000'000);
  CHECK(contains(markdownSummary(suite), "too long to be shown"));
}
