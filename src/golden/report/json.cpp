// Reads and writes report.json. fields.hpp defines the keys, which Writer and Reader visit.
#include "golden/report/json.hpp"

#include "base/error.hpp"
#include "base/strict_json.hpp"
#include "golden/report/fields.hpp"
#include "golden/report/words.hpp"
#include "golden/result.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <limits>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using Json = nlohmann::ordered_json;

constexpr int reportFormat = 5;

Json statusCounts(const SuiteResult& suite) {
  Json counts = Json::object();
  for (int i = 0; i < statusCount; ++i) {
    const auto status = static_cast<Status>(i);
    if (const long n = countOf(suite, status); n > 0) counts[statusName(status)] = n;
  }
  return counts;
}

class Writer {
 public:
  template <class T>
  void operator()(const char* key, const T& value) {
    object_[key] = json(value);
  }
  void decibels(const char* key, double value) {
    object_[key] = std::isfinite(value) ? Json(value) : Json(nullptr);
  }
  void path(const char* key, const std::string& value) { object_[key] = value; }
  void format(const char* key) { object_[key] = reportFormat; }
  void counts(const char* key, const SuiteResult& suite) { object_[key] = statusCounts(suite); }
  template <class Inside>
  void group(const char* key, const Inside& inside) {
    Writer writer;
    inside(writer);
    object_[key] = std::move(writer.object_);
  }

  template <class T>
  static Json json(const T& value) {
    if constexpr (std::is_class_v<T>) {
      Writer writer;
      fields(writer, value);
      return std::move(writer.object_);
    } else {
      return value;
    }
  }
  static Json json(Status value) { return statusName(value); }
  static Json json(const std::string& value) { return value; }
  /// Replaces infinity by the largest double and NaN by null, because JSON has neither infinity nor NaN.
  static Json json(double value) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::isnan(value) ? Json(nullptr) : Json(std::clamp(value, -largest, largest));
  }
  static Json json(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
  }
  template <class T>
  static Json json(const std::optional<T>& value) {
    return value ? json(*value) : Json(nullptr);
  }
  template <class T>
  static Json json(const std::vector<T>& list) {
    Json array = Json::array();
    for (const T& item : list) array.push_back(json(item));
    return array;
  }
  template <class T>
  static Json json(const std::map<std::string, T>& map) {
    Json object = Json::object();
    for (const auto& [key, value] : map) object[key] = json(value);
    return object;
  }

 private:
  Json object_ = Json::object();
};

template <std::integral Int>
void read(const JsonValue& json, Int& value) {
  value = json.integer<Int>();
}
void read(const JsonValue& json, double& value) {
  value = json.number();
}
void read(const JsonValue& json, bool& value) {
  value = json.boolean();
}
void read(const JsonValue& json, std::string& value) {
  value = json.text();
}
void read(const JsonValue& json, Status& value) {
  const std::string name = json.text();
  const std::optional<Status> status = statusOfName(name);
  if (!status)
    json.wrong(fmt::format("is {}, which is no status", scene::inQuotes(scene::printable(name))));
  value = *status;
}

template <class T>
  requires std::is_class_v<T>
void read(const JsonValue& json, T& value);
template <class T>
void read(const JsonValue& json, std::optional<T>& value);
template <class T>
void read(const JsonValue& json, std::map<std::string, T>& value);

template <class T>
void read(const JsonValue& json, std::vector<T>& value) {
  value.resize(json.size());
  for (std::size_t i = 0; i < value.size(); ++i) read(json.at(i), value[i]);
}

template <class T>
void read(const JsonValue& json, std::optional<T>& value) {
  if (!json.isNull()) read(json, value.emplace());
}

template <class T>
void read(const JsonValue& json, std::map<std::string, T>& value) {
  json.eachMember([&](const std::string& key, const JsonValue& member) { read(member, value[key]); });
}

class Reader {
 public:
  explicit Reader(const JsonValue& json) : object_(json) {}

  template <class T>
  void operator()(const char* key, T& value) {
    read(object_.at(key), value);
  }
  void decibels(const char* key, double& value) {
    const JsonValue json = object_.at(key);
    value = json.isNull() ? std::numeric_limits<double>::infinity() : json.number();
  }
  /// Reads a path that must stay below the report's folder. `simreel accept` copies the file at this path,
  /// and a report from an untrusted source must not make it copy other files.
  void path(const char* key, std::string& value) {
    const JsonValue json = object_.at(key);
    value = json.text();
    const std::filesystem::path path(value);
    if (path.is_absolute()) json.wrong("must be relative to the report's folder");
    if (std::find(path.begin(), path.end(), "..") != path.end()) json.wrong("must not contain \"..\"");
    if (value.find('\0') != std::string::npos) json.wrong("must not contain a NUL character");
  }
  void format(const char* key) {
    const JsonValue json = object_.at(key);
    if (json.json() != reportFormat)
      json.wrong(
          fmt::format("must be {}: this program reads no other; run simreel test again", reportFormat));
  }
  void counts(const char* key, const SuiteResult&) { counts_.emplace(object_.at(key)); }
  template <class Inside>
  void group(const char* key, const Inside& inside) {
    Reader reader(object_.at(key));
    inside(reader);
    reader.finish();
  }
  void finish() const { object_.finish(); }
  /// Checks the counts in the report. Call it after the scenes have been read.
  void checkCounts(const SuiteResult& suite) const {
    const nlohmann::json wanted = statusCounts(suite);
    if (counts_->json() != wanted)
      counts_->wrong(fmt::format("must be {}, as the scenes say", wanted.dump()));
  }

 private:
  JsonObject object_;
  std::optional<JsonValue> counts_;
};

template <class T>
  requires std::is_class_v<T>
void read(const JsonValue& json, T& value) {
  Reader reader(json);
  fields(reader, value);
  reader.finish();
  if constexpr (std::same_as<T, SuiteResult>) reader.checkCounts(value);
}

}  // namespace

std::string reportText(const SuiteResult& suite) {
  return Writer::json(suite).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SuiteResult parseReport(const std::string& text, const std::string& name) {
  try {
    const auto json = parseStrictJson(text);
    if (json.is_object() && !json.contains("simreel"))
      fail(ExitCode::usage,
           "{} is no report of `simreel test`; give the folder of its --report, or the file of its --json",
           name);
    SuiteResult suite;
    read(JsonValue(json), suite);
    return suite;
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "{}: {}", name, error.what());
  }
}

}  // namespace simreel::golden
