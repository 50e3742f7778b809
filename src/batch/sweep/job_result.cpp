#include "batch/sweep/job_result.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace simreel::batch {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* resultFormat = "simreel-job";
constexpr int resultVersion = 1;

/// Returns the value as JSON. Returns null for a missing value and for infinities and NaN, because JSON
/// cannot represent them.
Json numberOrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::optional<double> numberIn(const JsonValue& value) {
  return value.isNull() ? std::nullopt : std::optional(value.number());
}

std::string resultJson(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Returns a JSON list with one item per line, so that a text diff of two results shows which items differ.
std::string jsonLines(const std::vector<Json>& items) {
  std::string text = "[";
  for (const Json& item : items) text += (text.size() > 1 ? ",\n    " : "\n    ") + resultJson(item);
  return text + (items.empty() ? "]" : "\n  ]");
}

std::vector<Json> itemsOf(const std::vector<golden::CheckResult>& checks) {
  std::vector<Json> items;
  items.reserve(checks.size());
  for (const golden::CheckResult& check : checks)
    items.push_back({{"what", check.what},
                     {"frame", check.frame},
                     {"value", numberOrNull(check.value)},
                     {"min", numberOrNull(check.min)},
                     {"max", numberOrNull(check.max)},
                     {"passed", check.passed},
                     {"message", check.message}});
  return items;
}

std::vector<golden::CheckResult> checksIn(const JsonValue& list) {
  std::vector<golden::CheckResult> checks;
  list.eachItem([&](const JsonValue& item) {
    golden::CheckResult check;
    check.what = item.at("what").text();
    check.frame = item.at("frame").integer();
    check.value = numberIn(item.at("value"));
    check.min = numberIn(item.at("min"));
    check.max = numberIn(item.at("max"));
    check.passed = item.at("passed").boolean();
    check.message = item.at("message").text();
    checks.push_back(std::move(check));
  });
  return checks;
}

JobResult parsed(const std::string& text) {
  const auto json = parseStrictJson(text);
  const JsonValue object(json);
  if (const auto format = object.find("format"); !format || !format->is(resultFormat))
    throw JsonError("it is not the result of a job");
  if (const int version = object.at("version").integer(); version != resultVersion)
    throw JsonError(fmt::format("its version is {}, this program reads {}", version, resultVersion));
  JobResult result;
  result.hash = object.at("hash").text();
  result.code = object.at("code").integer(0, 255);
  result.message = object.at("message").text();
  result.frames = object.at("frames").integer(0);
  result.checks = checksIn(object.at("checks"));
  object.at("quantities").eachItem([&](const JsonValue& item) {
    result.quantities.push_back({item.at("what").text(), item.at("unit").text(), item.at("frame").integer(),
                                 numberIn(item.at("value"))});
  });
  object.at("counts").eachItem(
      [&](const JsonValue& item) { result.counts.emplace_back(item.at(0).text(), item.at(1).text()); });
  return result;
}

}  // namespace

bool JobResult::checksPassed() const {
  return std::all_of(checks.begin(), checks.end(), [](const auto& check) { return check.passed; });
}

std::string resultText(const JobResult& result) {
  std::vector<Json> quantities, counts;
  quantities.reserve(result.quantities.size());
  counts.reserve(result.counts.size());
  for (const MeasuredQuantity& one : result.quantities)
    quantities.push_back(
        {{"what", one.what}, {"unit", one.unit}, {"frame", one.frame}, {"value", numberOrNull(one.value)}});
  for (const auto& [name, value] : result.counts) counts.push_back(Json::array({name, value}));
  const Json head = {{"format", resultFormat}, {"version", resultVersion},  {"hash", result.hash},
                     {"code", result.code},    {"message", result.message}, {"frames", result.frames}};
  std::string text = head.dump(2, ' ', false, Json::error_handler_t::replace);
  text.resize(text.size() - 2);  // The closing " }" is removed, because more members follow.
  text += ",\n  \"checks\": " + jsonLines(itemsOf(result.checks));
  text += ",\n  \"quantities\": " + jsonLines(quantities);
  text += ",\n  \"counts\": " + jsonLines(counts);
  return text + "\n}\n";
}

JobResult parseResult(const std::string& text, const std::string& name) {
  try {
    return parsed(text);
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "result {} cannot be read: {}", name, error.what());
  }
}

std::string checksText(const std::vector<golden::CheckResult>& checks) {
  return jsonLines(itemsOf(checks)) + "\n";
}

std::vector<golden::CheckResult> readChecks(const std::filesystem::path& file) {
  if (!pathExists(file)) return {};
  try {
    const auto json = parseStrictJson(readFile(file, "results of checks"));
    return checksIn(JsonValue(json));
  } catch (const JsonError&) {
    return {};
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace simreel::batch
