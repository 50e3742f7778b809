// Tests report.json. A written report must be read back, and a damaged one must be rejected with a message
// of one line.
#include "base/error.hpp"
#include "golden/report/json.hpp"
#include "unit/frame/help.hpp"
#include "unit/golden/suite.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using namespace simreel::golden;
using frame::test::contains;
using frame::test::errorOf;
using Json = nlohmann::ordered_json;

namespace {

std::string messageFor(const std::string& text) {
  const auto [code, message] = errorOf([&] { (void)parseReport(text, "out/report.json"); });
  CHECK(code == ExitCode::usage);
  CHECK(!contains(message, "\n"));
  return message;
}

/// Applies `change` to the full report and returns the error message of parsing it.
template <class Change>
std::string refusalOf(const Change& change) {
  Json json = Json::parse(reportText(golden::test::fullSuite()));
  change(json);
  return messageFor(json.dump());
}

std::string keysOf(const Json& object) {
  std::string keys;
  for (const auto& item : object.items()) keys += (keys.empty() ? "" : " ") + item.key();
  return keys;
}

}  // namespace

TEST_CASE("every status has a name that maps back to it") {
  for (int i = 0; i < statusCount; ++i) {
    const auto status = static_cast<Status>(i);
    CHECK(statusOfName(statusName(status)) == status);
  }
  CHECK(statusName(Status::nondeterministic) == std::string("nondeterministic"));
  CHECK(!statusOfName("passed"));
  CHECK(!statusOfName(""));
  CHECK(isFailure(Status::flaky, false));
  CHECK(!isFailure(Status::flaky, true));
  CHECK(isFailure(Status::xpass, true));
  CHECK(!isFailure(Status::xfail, false));
}

TEST_CASE("a report is read back as written") {
  for (const SuiteResult& suite : {golden::test::fullSuite(), golden::test::oddSuite(), SuiteResult{}}) {
    const std::string text = reportText(suite);
    CHECK(text.ends_with("}\n"));
    CHECK(parseReport(text, "report.json") == suite);
  }
  SuiteResult flaky = golden::test::fullSuite();
  flaky.allowFlaky = true;
  CHECK(parseReport(reportText(flaky), "report.json").allowFlaky);
  CHECK(parseReport(reportText(flaky), "report.json") != golden::test::fullSuite());
}

TEST_CASE("invalid UTF-8 in a report is replaced, and valid text is kept") {
  const std::string text = reportText(golden::test::brokenSuite());
  const SuiteResult back = parseReport(text, "report.json");
  CHECK(contains(back.scenes[1].messages[1], "bad \xEF\xBF\xBD"));
  CHECK(contains(back.scenes[1].messages[1], " end "));
  CHECK(back.scenes[1].messages[0] == golden::test::odd);
  CHECK(reportText(back) == text);
}

TEST_CASE("NaN and infinity in a report are written as null or large numbers and read back") {
  SuiteResult suite = golden::test::fullSuite();
  const double infinity = std::numeric_limits<double>::infinity();
  suite.scenes[1].checks[0].value = std::nan("");
  suite.scenes[1].checks[0].max = infinity;
  suite.scenes[1].tolerance["hardFail"] = {infinity, "test"};
  const Json json = Json::parse(reportText(suite));
  CHECK(json["scenes"][0]["frames"][0]["metrics"]["psnr"].is_null());
  CHECK(json["scenes"][1]["checks"][0]["value"].is_null());
  const SuiteResult back = parseReport(reportText(suite), "report.json");
  CHECK(back.scenes[0].frames[0].metrics->psnr == infinity);
  CHECK(!back.scenes[1].checks[0].value);
  CHECK(!back.scenes[1].checks[0].max);
  CHECK(back.scenes[1].checks[0].min == -0.5);
  CHECK(back.scenes[1].tolerance.at("hardFail").value > 1e308);
}

TEST_CASE("a report's keys have a fixed order") {
  const Json json = Json::parse(reportText(golden::test::fullSuite()));
  CHECK(keysOf(json) ==
        "simreel format unit expected environment command shard acceptCommand allowFlaky strict seconds "
        "notes stale counts scenes");
  CHECK(keysOf(json["environment"]) == "driver processor profile fingerprint drawing memoryPath");
  const Json& scene = json["scenes"][1];
  CHECK(keysOf(scene) ==
        "name file baselines status messages notes xfail profile asked baselineDriver baselineProcessor "
        "baselineVersion "
        "baselineReason tolerance seconds simulateSeconds repeats attempts frames checks divergence "
        "candidate inputs blame renamedFrom");
  CHECK(keysOf(scene["tolerance"]["maxDiffRatio"]) == "value origin");
  CHECK(keysOf(scene["attempts"][0]) == "status messages");
  CHECK(keysOf(scene["frames"][1]) ==
        "frame time status message pixels expectedPixels alternate state asked metrics pass expectedImage "
        "actualImage "
        "differenceImage flipImage others");
  CHECK(
      keysOf(scene["frames"][1]["metrics"]) ==
      "worst worstX worstY differentPixels pixelsBeyond ratioBeyond windowRatio windowX windowY psnr ssim "
      "flipMean maskedPixels antialiasedPixels movedPixels");
  CHECK(keysOf(scene["frames"][1]["pass"]) == "pass x y shows message");
  CHECK(keysOf(scene["checks"][0]) == "what frame value least most passed message");
  CHECK(keysOf(scene["divergence"]) == "frame step steps object buffer firstElement lastElement message");
  CHECK(json["format"] == 5);
  CHECK(json["counts"].dump() ==
        R"({"pass":1,"updated":1,"xfail":1,"flaky":1,"fail":1,"nondeterministic":1,"missing":1,"xpass":1,)"
        R"("error":1})");
  CHECK(Json::parse(reportText(SuiteResult{}))["counts"].dump() == "{}");
  CHECK(json["scenes"][0]["divergence"].is_null());
}

TEST_CASE("a wrong value in a report is reported with its path") {
  const auto scene = [](Json& json) -> Json& { return json["scenes"][1]; };
  CHECK(refusalOf([&](Json& j) { scene(j)["frames"][1]["pixels"] = 3; }) ==
        "out/report.json: scenes[1].frames[1].pixels must be text");
  CHECK(refusalOf([&](Json& j) { scene(j)["frames"][1]["frame"] = 1.5; }) ==
        "out/report.json: scenes[1].frames[1].frame must be a whole number");
  CHECK(refusalOf([&](Json& j) { scene(j)["frames"][1]["frame"] = 3000000000; }) ==
        "out/report.json: scenes[1].frames[1].frame must be between -2147483648 and 2147483647");
  CHECK(refusalOf([&](Json& j) { scene(j)["divergence"]["lastElement"] = 18446744073709551615U; }) ==
        "out/report.json: scenes[1].divergence.lastElement must be between -9223372036854775808 and "
        "9223372036854775807");
  CHECK(refusalOf([&](Json& j) { scene(j)["seconds"] = "2"; }) ==
        "out/report.json: scenes[1].seconds must be a number");
  CHECK(refusalOf([&](Json& j) { scene(j)["checks"][0]["passed"] = 1; }) ==
        "out/report.json: scenes[1].checks[0].passed must be true or false");
  CHECK(refusalOf([&](Json& j) { scene(j)["status"] = "passed"; }) ==
        "out/report.json: scenes[1].status is \"passed\", which is no status");
  CHECK(refusalOf([&](Json& j) { scene(j)["notes"] = "one"; }) ==
        "out/report.json: scenes[1].notes must be a list");
  CHECK(refusalOf([&](Json& j) { scene(j)["divergence"] = 1; }) ==
        "out/report.json: scenes[1].divergence must be an object");
  CHECK(refusalOf([&](Json& j) { j["environment"]["driver"] = nullptr; }) ==
        "out/report.json: environment.driver must be text");
  CHECK(refusalOf([&](Json& j) { scene(j)["tolerance"]["maxDiffRatio"]["value"] = nullptr; }) ==
        "out/report.json: scenes[1].tolerance.maxDiffRatio.value must be a number");
  CHECK(refusalOf([&](Json& j) { j = Json::array(); }) == "out/report.json: it must be an object");
}

TEST_CASE("missing, unknown and repeated keys of a report are refused") {
  CHECK(refusalOf([](Json& j) { j.erase("scenes"); }) == "out/report.json: scenes is missing");
  CHECK(refusalOf([](Json& j) { j["scenes"][1]["frames"][0].erase("state"); }) ==
        "out/report.json: scenes[1].frames[0].state is missing");
  CHECK(refusalOf([](Json& j) { j["scenes"][0]["colour"] = 1; }) ==
        "out/report.json: scenes[0].colour is unknown");
  CHECK(refusalOf([](Json& j) { j["environment"]["a\nb"] = 1; }) ==
        "out/report.json: environment[\"a\\nb\"] is unknown");
  CHECK(messageFor(R"({"format": 1, "format": 1})") ==
        "out/report.json: the key \"format\" occurs twice in one object");
  // Objects may have equal keys, and the order of keys is arbitrary.
  Json json = Json::parse(reportText(golden::test::fullSuite()));
  json["simreel"].swap(json["command"]);
  const auto sorted = nlohmann::json::parse(json.dump());
  CHECK(parseReport(sorted.dump(), "report.json").version == golden::test::fullSuite().command);
}

TEST_CASE("a report of another format or with wrong counts is refused") {
  CHECK(refusalOf([](Json& j) { j["format"] = 1; }) ==
        "out/report.json: format must be 5: this program reads no other; run simreel test again");
  CHECK(refusalOf([](Json& j) { j["format"] = "3"; }) ==
        "out/report.json: format must be 5: this program reads no other; run simreel test again");
  CHECK(contains(refusalOf([](Json& j) { j["counts"]["pass"] = 2; }), "counts must be {\"error\":1"));
  CHECK(contains(refusalOf([](Json& j) { j["counts"].erase("fail"); }), "as the scenes say"));
}

TEST_CASE("paths in a report must stay inside its folder") {
  const auto at = [](Json& json, const char* key) -> Json& {
    return std::string(key) == "candidate" ? json["scenes"][1][key] : json["scenes"][1]["frames"][1][key];
  };
  for (const char* key : {"expectedImage", "actualImage", "differenceImage", "candidate"}) {
    INFO(key);
    for (const char* path : {"..", "../a.png", "a/../../b.png", "a/.."})
      CHECK(contains(refusalOf([&](Json& j) { at(j, key) = path; }), "must not contain \"..\""));
    for (const char* path : {"/etc/passwd", "//a", "/"})
      CHECK(contains(refusalOf([&](Json& j) { at(j, key) = path; }),
                     fmt::format("{} must be relative to the report's folder", key)));
    CHECK(contains(refusalOf([&](Json& j) { at(j, key) = std::string("a\0b", 3); }), "NUL"));
    for (const char* path : {"", "a..b/c.png", "...", "./a.png"}) {
      Json json = Json::parse(reportText(golden::test::fullSuite()));
      at(json, key) = path;
      CHECK_NOTHROW((void)parseReport(json.dump(), "report.json"));
    }
  }
}

TEST_CASE("text that is not JSON is refused as such") {
  CHECK(contains(messageFor(""), "out/report.json: not valid JSON at byte 1"));
  CHECK(contains(messageFor("# not json"), "not valid JSON"));
  CHECK(contains(messageFor("{\"a\": \"\xFF\"}"), "not valid JSON"));
  CHECK(contains(messageFor("{\"seconds\": 1e999}"), "number that is too large"));
  CHECK(contains(messageFor(std::string(200000, '[')), "nested deeper"));
  CHECK(contains(messageFor(std::string(100000, '[') + std::string(100000, ']')), "nested deeper"));
}

TEST_CASE("no damage to a report causes more than a refusal") {
  const std::string whole = reportText(golden::test::oddSuite());
  const auto survives = [](const std::string& text) {
    try {
      (void)parseReport(text, "report.json");
    } catch (const UserError& error) {
      return std::string(error.what()).find('\n') == std::string::npos;
    }
    return true;
  };
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    const auto [code, message] =
        errorOf([&] { (void)parseReport(whole.substr(0, length), "report.json"); });
    if (length + 2 < whole.size()) REQUIRE(code == ExitCode::usage);
  }
  std::uint32_t random = 1;
  const auto next = [&] { return (random = random * 747796405U + 2891336453U) >> 8U; };
  const std::string_view put[] = {"\"",   "\\", "{",    "}",    "[",   "]",  ",", "9",   "-",
                                  "null", "\n", "\xFF", "e999", "1e9", "..", ":", "true"};
  for (int round = 0; round < 4000; ++round) {
    std::string damaged = whole;
    for (unsigned n = next() % 3 + 1; n > 0; --n) {
      const std::size_t at = next() % damaged.size();
      damaged.replace(at, next() % 4, put[next() % std::size(put)]);
    }
    if (round % 5 == 0) damaged.erase(next() % damaged.size(), next() % 400);
    REQUIRE_MESSAGE(survives(damaged), round);
  }
}

TEST_CASE("any value of a report replaced by a value of any type causes at most a refusal") {
  const Json whole = Json::parse(reportText(golden::test::fullSuite()));
  const Json flat = whole.flatten();
  const Json values[] = {nullptr,
                         true,
                         -1,
                         18446744073709551615U,
                         1e300,
                         "",
                         "\n",
                         Json::array(),
                         Json::object(),
                         Json::array({Json::array()})};
  // All elements of an array are parsed in the same way, so the first element with a member represents all.
  const auto kind = [](std::string path) {
    std::erase_if(path, [](char c) { return c >= '0' && c <= '9'; });
    return path;
  };
  std::set<std::string> done;
  for (const auto& item : flat.items()) {
    const Json::json_pointer pointer(item.key());
    for (Json::json_pointer at = pointer; !at.empty() && done.insert(kind(at.to_string())).second;
         at.pop_back())
      for (const Json& value : values) {
        Json changed = whole;
        changed[at] = value;
        try {
          (void)parseReport(changed.dump(), "report.json");
        } catch (const UserError& error) {
          REQUIRE(error.code() == ExitCode::usage);
        }
      }
  }
}
