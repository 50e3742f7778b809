#include "golden/baseline/strict_json.hpp"

#include "base/json_depth.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace simreel::golden {

StrictObject::StrictObject(const Json& object, std::string path) : object_(object), path_(std::move(path)) {
  if (!object_.is_object())
    throw std::runtime_error(path_.empty() ? "it is not an object" : path_ + " is not an object");
}

bool StrictObject::has(const char* key) const {
  return object_.contains(key);
}

void StrictObject::wrong(const char* key, const char* what) const {
  throw std::runtime_error(fmt::format("{}{}{} {}", path_, path_.empty() ? "" : ".", key, what));
}

const StrictObject::Json& StrictObject::member(const char* key) {
  asked_.insert(key);
  const auto found = object_.find(key);
  if (found == object_.end()) wrong(key, "is missing");
  return *found;
}

std::string StrictObject::text(const char* key) {
  const Json& value = member(key);
  if (!value.is_string()) wrong(key, "must be text");
  return value.get<std::string>();
}

std::string StrictObject::text(const char* key, const std::string& otherwise) {
  return has(key) ? text(key) : otherwise;
}

int StrictObject::integer(const char* key) {
  const Json& value = member(key);
  if (!value.is_number_integer() || value.get<double>() < -2147483648.0 ||
      value.get<double>() > 2147483647.0)
    wrong(key, "must be a whole number");
  return value.get<int>();
}

double StrictObject::number(const char* key) {
  const Json& value = member(key);
  if (!value.is_number() || !std::isfinite(value.get<double>())) wrong(key, "must be a number");
  return value.get<double>();
}

std::vector<std::string> StrictObject::texts(const char* key) {
  const Json& value = member(key);
  if (!value.is_array()) wrong(key, "must be a list");
  std::vector<std::string> all;
  for (const Json& item : value) {
    if (!item.is_string()) wrong(key, "must be a list of texts");
    all.push_back(item.get<std::string>());
  }
  return all;
}

StrictObject StrictObject::object(const char* key) {
  return {member(key), path_.empty() ? key : path_ + "." + key};
}

std::vector<std::string> StrictObject::keys() const {
  std::vector<std::string> all;
  for (const auto& item : object_.items()) all.push_back(item.key());
  return all;
}

void StrictObject::finish() const {
  for (const auto& item : object_.items())
    if (!asked_.contains(item.key()))
      throw std::runtime_error(
          fmt::format("{}{}{} is unknown", path_, path_.empty() ? "" : ".", item.key()));
}

StrictObject::Json parseStrictly(std::string_view text) {
  refuseDeepJson(text);
  try {
    return StrictObject::Json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw std::runtime_error(fmt::format("not valid JSON at byte {}", error.byte));
  }
}

}  // namespace simreel::golden
