#include "scene/json/json_node.hpp"
#include "unit/scene/toy.hpp"

#include <doctest/doctest.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;

namespace {

/// Returns the first line of the error report.
std::string first(std::string_view text) {
  const std::string report = mistakes(text);
  return report.substr(0, report.find('\n'));
}

}  // namespace

TEST_CASE("syntax errors give line, column and cause") {
  CHECK(first("") == "s.json:1:1: error: the text is empty; a scene begins with {");
  CHECK(first(" \n ") == "s.json:1:1: error: the text is empty; a scene begins with {");
  CHECK(first("{\n") == "s.json:2:1: error: the text ends, but the '{' of line 1 is still open");
  CHECK(first("{\"version\": 1,}") == "s.json:1:15: error: a comma stands before this '}'; remove it");
  CHECK(first("{\"a\": [1,]}") == "s.json:1:10: error: a comma stands before this ']'; remove it");
  CHECK(first("{\"a\": ]}") == "s.json:1:7: error: expected a value");
  CHECK(first("{\"a\": [1 2]}") == "s.json:1:10: error: expected ',' or ']'; is a comma missing?");
  CHECK(first("{\"a\": 1 \"b\": 2}") == "s.json:1:9: error: expected ',' or '}'; is a comma missing?");
  CHECK(first("{\"a\" 1}") == "s.json:1:6: error: expected ':' between key and value");
  CHECK(first("{a: 1}") == "s.json:1:2: error: unknown word \"a\"; strings and keys need double quotes");
  CHECK(first("{'a': 1}") == "s.json:1:2: error: strings and keys need double quotes");
  CHECK(first("{\"a\": @}") == "s.json:1:7: error: this character does not belong here");
  CHECK(first("{\"version\": 1}\n}") ==
        "s.json:2:1: error: the scene ended before this; remove what follows");
  CHECK(first("[]") == "s.json:1:1: error: expected a scene in { }, found a list");
}

TEST_CASE("words and numbers that are not JSON are refused with advice") {
  CHECK(first("{\"a\":\n NaN}") == "s.json:2:2: error: NaN is not a number in JSON; give a finite number");
  CHECK(first("{\"a\": -Infinity}") ==
        "s.json:1:7: error: -Infinity is not a number in JSON; give a finite number");
  CHECK(first("{\"a\": 1e999}") ==
        "s.json:1:7: error: \"1e999\" is beyond the largest number there is, 1.8e308");
  CHECK(first("{\"a\": True}") == "s.json:1:7: error: unknown word True; JSON writes true");
  CHECK(first("{\"a\": tru}") ==
        "s.json:1:7: error: unknown word \"tru\"; strings and keys need double quotes");
  CHECK(first("{\"a\": .5}") ==
        "s.json:1:7: error: \".5\" is not a number in JSON; write it like -0.5 or 2e3");
  CHECK(first("{\"a\": 5.}") ==
        "s.json:1:7: error: \"5.\" is not a number in JSON; write it like -0.5 or 2e3");
  CHECK(first("{\"a\": 05}") == "s.json:1:7: error: a number has no leading zero");
}

TEST_CASE("invalid strings and bytes are refused") {
  CHECK(first("{\"a\": \"b") == "s.json:1:7: error: string without closing quote");
  CHECK(first("{\"a\": \"b\n\"}") == "s.json:1:7: error: string without closing quote");
  CHECK(has(first("{\"a\": \"\\q\"}"), "s.json:1:9: error: unknown escape"));
  CHECK(has(first("{\"a\": \"\\ud800\"}"), "error: half of a surrogate pair"));
  CHECK(first("{\"a\": \"\xFF\"}") == "s.json:1:8: error: not valid UTF-8; save the text as UTF-8");
  CHECK(has(first("{\"a\": \"\x01\"}"), "s.json:1:8: error: control character U+0001 in a string"));
  CHECK(first(std::string_view("{}\0{}", 5)) == "s.json:1:3: error: zero byte; is this a text file?");
  CHECK(first("{\"a\": /* }") == "s.json:1:7: error: comment without closing */");
}

TEST_CASE("comments and a byte order mark are allowed") {
  CHECK(mistakes("// hello\n{\"version\": /* one */ 1} // bye").empty());
  CHECK(mistakes("\xEF\xBB\xBF{\"version\": 1}").empty());
  CHECK(first("\xEF\xBB\xBF{\"version\": x}") ==
        "s.json:1:13: error: unknown word \"x\"; strings and keys need double quotes");
}

TEST_CASE("a repeated key is an error at the second key") {
  CHECK(first("{\"version\": 1,\n \"seed\": 1, \"seed\": 2}") ==
        "s.json:2:13: error: key \"seed\" is given twice in this object");
}

TEST_CASE("nesting beyond the limit is refused without exhausting the stack") {
  const std::string deep(2'000'000, '[');
  CHECK(first("{\"a\": " + deep) == "s.json:1:70: error: nested deeper than 64 levels");
  std::string objects;
  for (int i = 0; i < 100; ++i) objects += "{\"a\":";
  CHECK(has(first(objects), "nested deeper than 64 levels"));
}

TEST_CASE("the number of values and the file size are limited") {
  std::string many = "{\"a\": [0";
  for (int i = 0; i < 1'000'000; ++i) many += ",0";
  CHECK(has(first(many + "]}"), "more than 1000000 values"));
  CHECK(has(first("{\"a\": \"" + std::string(maxSceneBytes, 'x') + "\"}"),
            "larger than the limit of 4194304 bytes"));
}

TEST_CASE("every value and key has its byte range") {
  const std::string text = R"( {"a\"b\\": [ "x\\\"", -1.5e2 ,true], "n":null,"o" : {}})";
  Diagnostics diagnostics("s.json", text);
  const auto root = parseJson(text, 0, 0, diagnostics);
  REQUIRE(root.has_value());
  const Node& list = root->children.at(0);
  CHECK(list.key == "a\"b\\");
  CHECK(diagnostics.textAt(list.headPlace()) == R"("a\"b\\")");
  CHECK(diagnostics.textAt(list.place()) == R"([ "x\\\"", -1.5e2 ,true])");
  CHECK(diagnostics.textAt(list.children.at(0).place()) == R"("x\\\"")");
  CHECK(diagnostics.textAt(list.children.at(1).place()) == "-1.5e2");
  CHECK(diagnostics.textAt(list.children.at(2).place()) == "true");
  CHECK(diagnostics.textAt(root->children.at(1).place()) == "null");
  CHECK(diagnostics.textAt(root->children.at(2).place()) == "{}");
  CHECK(diagnostics.textAt(root->place()) == text.substr(1));
}

TEST_CASE("the caret is below the error: tabs, UTF-8 and long lines") {
  CHECK(mistakes("{\"version\": 1,\n\t\"sed\": 1}") ==
        "s.json:2:2: error: unknown key \"sed\"; did you mean \"seed\"?\n      \"sed\": 1}\n      ^~~~~");
  CHECK(mistakes("{\"version\": 1, \"title\": \"\u00e9\u00e9\", \"sed\": 1}") ==
        "s.json:1:31: error: unknown key \"sed\"; did you mean \"seed\"?\n"
        "  {\"version\": 1, \"title\": \"\u00e9\u00e9\", \"sed\": 1}\n"
        "                                ^~~~~");
  const std::string report =
      mistakes("{\"version\": 1, \"title\": \"" + std::string(3000, 'x') + "\", \"sed\": 1}");
  CHECK(report.size() < 400);
  const std::size_t caret = report.rfind('\n');
  const std::size_t line = report.rfind('\n', caret - 1);
  CHECK(report.substr(caret).find('^') == report.substr(line).find("\"sed\""));
}

TEST_CASE("at most 50 errors are printed") {
  std::string text = "{\"version\": 1";
  for (int i = 0; i < 5000; ++i) text += ",\n\"unknown" + std::to_string(i) + "\": 1";
  const std::string report = mistakes(text + "}");
  CHECK(has(report, "s.json:51:1:"));
  CHECK(!has(report, "s.json:52:1:"));
  CHECK(has(report, "\nand "));
  CHECK(has(report, " more"));
}

TEST_CASE("text of a hostile scene cannot control the terminal") {
  const std::string report = mistakes("{\"version\": 1, \"\\u001b[31mred\\u009b\": 1 /* \x1b[0m */}");
  CHECK(has(report, "unknown key \"\\x1b[31mred\\u009b\""));
  CHECK(report.find('\x1b') == std::string::npos);
}
