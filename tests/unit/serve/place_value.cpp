#include "serve/edit/place_value.hpp"

#include "base/error.hpp"
#include "unit/help.hpp"

#include <string>

#include <doctest/doctest.h>

using simreel::UserError;
using simreel::serve::withValue;

namespace {

const std::string text = R"({
  // Who reads this, smile.
  "version": 1,
  "time": {"fps":   30, "duration": 2.0 /* s */},
  "objects": {
    "flag": {"cloth": {"size": [9, 7], "wind": "\"a, b\""}} // last
  },
  "lights": [
    {"color": [1, 1, 1]},
    {"color": [0, 0, 0]} // dark
  ]
}
)";

std::string with(const std::string& path, const std::string& value) {
  return withValue(text, {path, value});
}

/// Returns the text with `part`, which occurs once, replaced.
std::string replaced(const std::string& part, const std::string& by) {
  std::string result = text;
  const std::size_t at = result.find(part);
  REQUIRE_NE(at, std::string::npos);
  REQUIRE_EQ(result.find(part, at + 1), std::string::npos);
  return result.replace(at, part.size(), by);
}

}  // namespace

TEST_CASE("serve: replacing a value changes only its bytes") {
  CHECK_EQ(with("time.fps", "60"), replaced("  30", "  60"));
  CHECK_EQ(with("time.duration", "0.1"), replaced("2.0", "0.1"));
  CHECK_EQ(with("objects.flag.cloth.size", "[3,\n4]"), replaced("[9, 7]", "[3,\n4]"));
  CHECK_EQ(with("objects.flag.cloth.size.1", "8"), replaced("[9, 7]", "[9, 8]"));
  CHECK_EQ(with("objects.flag.cloth.wind", "\"west\""), replaced(R"("\"a, b\"")", "\"west\""));
  CHECK_EQ(with("lights.1.color", "[0.5, 0, 0]"), replaced("[0, 0, 0]", "[0.5, 0, 0]"));
  CHECK_EQ(with("time", "{}"), replaced(R"({"fps":   30, "duration": 2.0 /* s */})", "{}"));
  CHECK_EQ(with("time.fps", "30"), text);
}

TEST_CASE("serve: a value that is not JSON is written as a string") {
  CHECK_EQ(with("objects.flag.cloth.wind", "north \"1\""), replaced(R"("\"a, b\"")", R"("north \"1\"")"));
}

TEST_CASE("serve: a new member is appended to its group in the same style") {
  CHECK_EQ(with("time.start", "1"), replaced("2.0 /* s */", "2.0, \"start\": 1 /* s */"));
  CHECK_EQ(with("sun.intensity", "3"),
           replaced("// dark\n  ]", "// dark\n  ],\n  \"sun\": {\"intensity\": 3}"));
  CHECK_EQ(withValue("{}", {"sun.intensity", "3"}), R"({"sun": {"intensity": 3}})");
}

TEST_CASE("serve: a new list item is appended after the last, and comments are kept") {
  CHECK_EQ(with("lights.2", "{}"),
           replaced("{\"color\": [0, 0, 0]} // dark", "{\"color\": [0, 0, 0]}, // dark\n    {}"));
  CHECK_EQ(with("objects.flag.cloth.size.2", "1"), replaced("[9, 7]", "[9, 7, 1]"));
}

TEST_CASE("serve: an invalid path is refused") {
  for (const char* path : {"lights.3", "lights.x", "time.fps.x", "objects.flag.cloth.size.7"})
    CHECK_THROWS_AS(with(path, "1"), UserError);
  CHECK_THROWS_AS(withValue("{", {"a", "1"}), UserError);
}
