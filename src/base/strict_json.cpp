#include "base/strict_json.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel {

namespace {

using Json = nlohmann::json;

constexpr std::size_t maxShown = 60;  ///< maximum bytes of a key in a message

std::string shown(const std::string& key) {
  return fmt::format("\"{}{}\"", oneLine(key.substr(0, maxShown)), key.size() > maxShown ? "..." : "");
}

/// Builds the value from the parser's events. nlohmann's own parser with a callback would scan a whole list
/// after each of its items.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(const JsonLimits& limits) : limits_(limits) {}

  [[nodiscard]] Json release() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*written*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON text has no binary values.
  bool start_object(std::size_t /*count*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*count*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& key) override {
    const auto [member, isNew] = open_.back()->get_ref<Json::object_t&>().try_emplace(std::move(key));
    if (!isNew) throw JsonError(fmt::format("the key {} occurs twice in one object", shown(key)));
    place_ = &member->second;
    return true;
  }
  bool parse_error(std::size_t byte, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr)
      throw JsonError("it holds a number that is too large");
    throw JsonError(fmt::format("not valid JSON at byte {}", byte));
  }

 private:
  bool add(Json value) {
    if (open_.empty())
      place_ = &root_;
    else if (open_.back()->is_array())
      place_ = &open_.back()->emplace_back();
    *place_ = std::move(value);
    return true;
  }
  bool open(Json container) {
    if (open_.size() >= limits_.depth)
      throw JsonError(fmt::format("nested deeper than {} levels", limits_.depth));
    if (++containers_ > limits_.containers)
      throw JsonError(fmt::format("it holds more than {} objects and lists", limits_.containers));
    add(std::move(container));
    open_.push_back(place_);  // The pointer stays valid, because the parent adds no members before this
                              // container is closed.
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  const JsonLimits& limits_;
  Json root_;
  std::vector<Json*> open_;
  Json* place_ = nullptr;  ///< last value that was read, or the place for the value of the last key that
                           ///< was read
  std::size_t containers_ = 0;
};

}  // namespace

Json parseStrictJson(std::string_view text, const JsonLimits& limits) {
  // The parser treats a zero byte as the end of the text. Zero bytes at the end are allowed, because some
  // programs pad binary glTF with them.
  if (text.find_first_not_of('\0', text.find('\0')) != std::string_view::npos)
    throw JsonError("not valid JSON: it contains a zero byte");
  Builder builder(limits);
  Json::sax_parse(text.begin(), text.end(), &builder, Json::input_format_t::json, /*strict=*/true,
                  limits.comments);
  return builder.release();
}

void JsonValue::wrong(std::string_view what) const {
  throw JsonError(fmt::format("{} {}", path_.empty() ? "it" : path_, what));
}

void JsonValue::expect(bool kind, std::string_view what) const {
  if (!kind) wrong(fmt::format("must be {}", what));
}

bool JsonValue::is(std::string_view text) const {
  return json_->is_string() && json_->get_ref<const std::string&>() == text;
}

bool JsonValue::isNull() const {
  return json_->is_null();
}

std::string JsonValue::text() const {
  expect(json_->is_string(), "text");
  return json_->get<std::string>();
}

bool JsonValue::boolean() const {
  expect(json_->is_boolean(), "true or false");
  return json_->get<bool>();
}

double JsonValue::number() const {
  expect(json_->is_number(), "a number");
  return json_->get<double>();
}

std::int64_t JsonValue::integerBetween(std::int64_t min, std::int64_t max) const {
  expect(json_->is_number_integer(), "a whole number");
  // An unsigned number beyond int64 would wrap around.
  const bool fits =
      !json_->is_number_unsigned() || std::in_range<std::int64_t>(json_->get<std::uint64_t>());
  const auto value = json_->get<std::int64_t>();
  if (!fits || value < min || value > max) wrong(fmt::format("must be between {} and {}", min, max));
  return value;
}

std::size_t JsonValue::size() const {
  expect(json_->is_array(), "a list");
  return json_->size();
}

JsonValue JsonValue::at(std::size_t index) const {
  if (index >= size()) wrong(fmt::format("has {} items, but no item {} (counted from 0)", size(), index));
  return JsonValue((*json_)[index], fmt::format("{}[{}]", path_, index));
}

void JsonValue::eachItem(const std::function<void(const JsonValue&)>& visit) const {
  for (std::size_t i = 0; i < size(); ++i) visit(at(i));
}

std::vector<std::string> JsonValue::texts() const {
  std::vector<std::string> all;
  eachItem([&](const JsonValue& item) { all.push_back(item.text()); });
  return all;
}

JsonValue JsonValue::member(const std::string& key, const Json& json) const {
  const bool plain =
      !key.empty() && key.size() <= maxShown && std::all_of(key.begin(), key.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
      });
  if (!plain) return JsonValue(json, fmt::format("{}[{}]", path_, shown(key)));
  return JsonValue(json, path_.empty() ? key : fmt::format("{}.{}", path_, key));
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  expect(json_->is_object(), "an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return member(key, *found);
}

JsonValue JsonValue::at(const std::string& key) const {
  if (auto found = find(key)) return *std::move(found);
  member(key, *json_).wrong("is missing");
}

void JsonValue::eachMember(const std::function<void(const std::string&, const JsonValue&)>& visit) const {
  expect(json_->is_object(), "an object");
  for (const auto& [key, value] : json_->items()) visit(key, member(key, value));
}

JsonValue JsonObject::at(const std::string& key) {
  asked_.insert(key);
  return value_.at(key);
}

std::optional<JsonValue> JsonObject::find(const std::string& key) {
  asked_.insert(key);
  return value_.find(key);
}

void JsonObject::finish() const {
  value_.eachMember([&](const std::string& key, const JsonValue& member) {
    if (!asked_.contains(key)) member.wrong("is unknown");
  });
}

}  // namespace simreel
