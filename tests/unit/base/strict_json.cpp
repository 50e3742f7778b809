#include "base/strict_json.hpp"

#include <cstdint>
#include <limits>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;

namespace {

/// Returns the message of the JsonError that `action` throws, or "" if it throws none.
template <class Action>
std::string mistake(const Action& action) {
  try {
    action();
  } catch (const JsonError& error) {
    return error.what();
  }
  return "";
}

std::string parsing(const std::string& text, const JsonLimits& limits = {}) {
  return mistake([&] { static_cast<void>(parseStrictJson(text, limits)); });
}

std::string times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// Returns the message about a member "v" with this value that `read` reads.
template <class Read>
std::string reading(const std::string& value, const Read& read) {
  const auto json = parseStrictJson(R"({"v": )" + value + "}");
  return mistake([&] { static_cast<void>(read(JsonValue(json).at("v"))); });
}

}  // namespace

TEST_CASE("text that is not JSON, or exceeds the limits, is refused") {
  CHECK(parsing(R"({"a": [1, {"a": 2}], "b": {"a": null}})").empty());
  CHECK(parsing("") == "not valid JSON at byte 1");
  CHECK(parsing("{\"a\": 1,}") == "not valid JSON at byte 9");
  CHECK(parsing("{} []") == "not valid JSON at byte 4");
  CHECK(parsing("[1e999]") == "it holds a number that is too large");
  CHECK(parsing(R"({"a": 1, "b": {}, "a": 1})") == "the key \"a\" occurs twice in one object");
  CHECK(parsing(R"([{"a\nb": 1, "a\nb": 1}])") == "the key \"a\\nb\" occurs twice in one object");
  CHECK(parsing("// no\n1") == "not valid JSON at byte 1");
  CHECK(parsing("1 // yes", {.comments = true}).empty());
}

TEST_CASE("zero bytes may follow JSON, but nothing may follow them") {
  CHECK(parsing(std::string("{}\0\0", 4)).empty());
  CHECK(parsing(std::string("{}\0{", 4)) == "not valid JSON: it contains a zero byte");
}

TEST_CASE("nesting, objects and lists are counted outside of strings only") {
  CHECK(parsing(times(100, "[") + times(100, "]")).empty());
  CHECK(parsing(times(101, "[") + times(101, "]")) == "nested deeper than 100 levels");
  CHECK(parsing(times(200'000, R"({"a":)")) == "nested deeper than 100 levels");
  CHECK(parsing("\"" + times(200, "[") + "\"").empty());
  CHECK(parsing("[[], {}, []]", {.containers = 4}).empty());
  CHECK(parsing("[[], {}, []]", {.containers = 3}) == "it holds more than 3 objects and lists");
}

TEST_CASE("a value of the wrong type is reported with its path") {
  const auto json = parseStrictJson(R"({"a": [{"b": "text", "c d": true, "": null}], "n": 1.5})");
  const JsonValue root(json);
  const JsonValue item = root.at("a").at(0);
  CHECK(item.at("b").text() == "text");
  CHECK(item.at("c d").boolean());
  CHECK(item.at("").isNull());
  CHECK(root.at("n").number() == 1.5);
  CHECK(mistake([&] { static_cast<void>(root.text()); }) == "it must be text");
  CHECK(mistake([&] { static_cast<void>(item.at("b").number()); }) == "a[0].b must be a number");
  CHECK(mistake([&] { static_cast<void>(item.at("c d").text()); }) == "a[0][\"c d\"] must be text");
  CHECK(mistake([&] { static_cast<void>(item.at("b").boolean()); }) == "a[0].b must be true or false");
  CHECK(mistake([&] { static_cast<void>(root.at("n").size()); }) == "n must be a list");
  CHECK(mistake([&] { static_cast<void>(root.at("a").at("b")); }) == "a must be an object");
  CHECK(mistake([&] { static_cast<void>(item.at("x")); }) == "a[0].x is missing");
  CHECK(mistake([&] { static_cast<void>(root.at("a").at(1)); }) ==
        "a has 1 items, but no item 1 (counted from 0)");
  CHECK(mistake([&] { static_cast<void>(root.at("a").texts()); }) == "a[0] must be text");
  CHECK(!item.find("x"));
}

TEST_CASE("integers must fit the type and the bounds") {
  const auto asInt = [](const JsonValue& v) { return v.integer(); };
  for (const char* good : {"0", "-2147483648", "2147483647"}) CHECK(reading(good, asInt).empty());
  for (const char* none : {"1.5", "1.0", "1e300", "true", "\"1\"", "null", "[]"})
    CHECK(reading(none, asInt) == "v must be a whole number");
  for (const char* large : {"2147483648", "4294967296", "18446744073709551615", "-2147483649"})
    CHECK(reading(large, asInt) == "v must be between -2147483648 and 2147483647");
  const auto asLong = [](const JsonValue& v) { return v.integer<std::int64_t>(); };
  CHECK(reading("9223372036854775807", asLong).empty());
  CHECK(!reading("9223372036854775808", asLong).empty());
  CHECK(!reading("18446744073709551615", asLong).empty());
  const auto bounded = [](const JsonValue& v) { return v.integer(1, 4); };
  CHECK(reading("4", bounded).empty());
  CHECK(reading("0", bounded) == "v must be between 1 and 4");
  CHECK(reading("5", bounded) == "v must be between 1 and 4");
}

TEST_CASE("an unknown member is an error") {
  const auto json = parseStrictJson(R"({"a": {"b": 1, "c": 2}})");
  JsonObject root{JsonValue(json)};
  CHECK(mistake([&] { root.finish(); }) == "a is unknown");
  JsonObject inner(root.at("a"));
  CHECK(root.find("later") == std::nullopt);
  CHECK(mistake([&] { root.finish(); }).empty());
  CHECK(inner.at("b").integer() == 1);
  CHECK(mistake([&] { inner.finish(); }) == "a.c is unknown");
}
