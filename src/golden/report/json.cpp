// report.json. The keys stand in fields.hpp; Writer and Reader visit them.
#include "golden/report/json.hpp"

#include "base/error.hpp"
#include "base/json_depth.hpp"
#include "golden/report/fields.hpp"
#include "golden/result.hpp"
#include "scene/words.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using Json = nlohmann::ordered_json;

constexpr int reportFormat = 2;

Json statusCounts(const SuiteResult& suite) {
  Json counts = Json::object();
  for (int i = 0; i < statusCount; ++i) {
    const auto status = static_cast<Status>(i);
    const auto n = std::count_if(suite.scenes.begin(), suite.scenes.end(),
                                 [&](const SceneResult& scene) { return scene.status == status; });
    if (n > 0) counts[statusName(status)] = n;
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
  /// JSON has no infinity; the largest number stands for it. NaN is nobody's measurement and becomes null.
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

/// In one line, whatever the file holds.
std::string shown(const std::string& text) {
  return scene::inQuotes(scene::printable(text));
}

/// One JSON value, and where in the file it stands.
struct Place {
  const Json& json;
  const std::string& file;
  std::string path;

  template <class... Args>
  [[noreturn]] void wrong(fmt::format_string<Args...> text, Args&&... args) const {
    fail(ExitCode::usage, "{}: {} {}", file, path.empty() ? "the report" : path,
         fmt::format(text, std::forward<Args>(args)...));
  }
  [[nodiscard]] std::string pathOf(const std::string& key) const {
    const bool plain = !key.empty() && key.size() <= 60 && std::all_of(key.begin(), key.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!plain) return fmt::format("{}[{}]", path, shown(key));
    return path.empty() ? key : path + "." + key;
  }
  [[nodiscard]] Place at(const std::string& key) const {
    const auto found = json.find(key);
    if (found == json.end()) fail(ExitCode::usage, "{}: {} is missing", file, pathOf(key));
    return {*found, file, pathOf(key)};
  }
  [[nodiscard]] Place at(std::size_t index) const {
    return {json[index], file, fmt::format("{}[{}]", path, index)};
  }
};

template <class Int>
  requires std::same_as<Int, int> || std::same_as<Int, long>
void read(const Place& place, Int& value) {
  if (!place.json.is_number_integer()) place.wrong("must be a whole number");
  // An unsigned number beyond int64 would wrap.
  const bool large = place.json.is_number_unsigned() &&
                     place.json.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<Int>::max()};
  const auto wide = place.json.get<std::int64_t>();
  if (large || wide < std::numeric_limits<Int>::min() || wide > std::numeric_limits<Int>::max())
    place.wrong("is too large");
  value = static_cast<Int>(wide);
}

void read(const Place& place, double& value) {
  if (!place.json.is_number()) place.wrong("must be a number");
  value = place.json.get<double>();
}

void read(const Place& place, bool& value) {
  if (!place.json.is_boolean()) place.wrong("must be true or false");
  value = place.json.get<bool>();
}

void read(const Place& place, std::string& value) {
  if (!place.json.is_string()) place.wrong("must be text");
  value = place.json.get<std::string>();
}

void read(const Place& place, Status& value) {
  std::string name;
  read(place, name);
  const std::optional<Status> status = statusOfName(name);
  if (!status) place.wrong("is {}, which is no status", shown(name));
  value = *status;
}

template <class T>
  requires std::is_class_v<T>
void read(const Place& place, T& value);
template <class T>
void read(const Place& place, std::optional<T>& value);
template <class T>
void read(const Place& place, std::map<std::string, T>& value);

template <class T>
void read(const Place& place, std::vector<T>& value) {
  if (!place.json.is_array()) place.wrong("must be a list");
  value.resize(place.json.size());
  for (std::size_t i = 0; i < value.size(); ++i) read(place.at(i), value[i]);
}

template <class T>
void read(const Place& place, std::optional<T>& value) {
  if (!place.json.is_null()) read(place, value.emplace());
}

template <class T>
void read(const Place& place, std::map<std::string, T>& value) {
  if (!place.json.is_object()) place.wrong("must be an object");
  for (const auto& [key, item] : place.json.items()) read(place.at(key), value[key]);
}

class Reader {
 public:
  explicit Reader(Place place) : place_(std::move(place)) {
    if (!place_.json.is_object()) place_.wrong("must be an object");
  }

  template <class T>
  void operator()(const char* key, T& value) {
    read(at(key), value);
  }
  void decibels(const char* key, double& value) {
    const Place place = at(key);
    value = std::numeric_limits<double>::infinity();
    if (!place.json.is_null()) read(place, value);
  }
  /// `simreel accept` copies from there: a report from elsewhere must not name files of this machine.
  void path(const char* key, std::string& value) {
    const Place place = at(key);
    read(place, value);
    const std::filesystem::path path(value);
    if (path.is_absolute()) place.wrong("must be relative to the report's folder");
    if (std::find(path.begin(), path.end(), "..") != path.end()) place.wrong("must not contain \"..\"");
    if (value.find('\0') != std::string::npos) place.wrong("must not contain a NUL character");
  }
  void format(const char* key) {
    const Place place = at(key);
    if (place.json != reportFormat)
      place.wrong("must be {}: this program reads no other; run simreel test again", reportFormat);
  }
  void counts(const char* key, const SuiteResult&) { countsAt_.emplace(at(key)); }
  template <class Inside>
  void group(const char* key, const Inside& inside) {
    Reader reader(at(key));
    inside(reader);
    reader.finish();
  }
  void finish() const {
    for (const auto& item : place_.json.items())
      if (!known_.contains(item.key()))
        fail(ExitCode::usage, "{}: {} is not known in format {}", place_.file, place_.pathOf(item.key()),
             reportFormat);
  }
  /// Once the scenes are read.
  void checkCounts(const SuiteResult& suite) const {
    // Compared as unordered objects: the order of keys does not matter.
    const nlohmann::json wanted = statusCounts(suite);
    if (nlohmann::json(countsAt_->json) != wanted)
      countsAt_->wrong("must be {}, as the scenes say", wanted.dump());
  }

 private:
  Place at(const char* key) {
    known_.insert(key);
    return place_.at(key);
  }

  Place place_;
  std::set<std::string> known_;
  std::optional<Place> countsAt_;
};

template <class T>
  requires std::is_class_v<T>
void read(const Place& place, T& value) {
  Reader reader(place);
  fields(reader, value);
  reader.finish();
  if constexpr (std::same_as<T, SuiteResult>) reader.checkCounts(value);
}

/// Throws Json::exception for text that is no JSON, UserError for a key that one object has twice.
Json parseOnce(const std::string& text, const std::string& file) {
  std::vector<std::set<std::string>> open;
  const auto watch = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(value.get<std::string>()).second)
      fail(ExitCode::usage, "{}: the key {} stands twice in one object", file,
           shown(value.get<std::string>()));
    return true;
  };
  return Json::parse(text, watch);
}

}  // namespace

std::string reportText(const SuiteResult& suite) {
  return Writer::json(suite).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SuiteResult parseReport(const std::string& text, const std::string& name) {
  if (jsonDepth(text) > mostJsonDepth)
    fail(ExitCode::usage, "{}: nested deeper than {} levels, so no report; run simreel test again", name,
         mostJsonDepth);
  try {
    const Json json = parseOnce(text, name);
    SuiteResult suite;
    read(Place{json, name, ""}, suite);
    return suite;
  } catch (const Json::parse_error& error) {
    fail(ExitCode::usage, "{}: not JSON from byte {} on; run simreel test again", name, error.byte);
  } catch (const Json::exception&) {
    fail(ExitCode::usage, "{}: holds a number that is too large; run simreel test again", name);
  }
}

}  // namespace simreel::golden
