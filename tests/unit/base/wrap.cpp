#include "base/wrap.hpp"

#include <cstdlib>
#include <string>
#include <utility>

#include <doctest/doctest.h>

using simreel::listEntry;
using simreel::textColumns;
using simreel::wrapped;

TEST_CASE("text wraps between words, and continuation lines are indented") {
  CHECK(wrapped("one two three", 7) == "one two\nthree");
  CHECK(wrapped("one two three", 9, 2) == "one two\n  three");
  CHECK(wrapped("one two three", 9, 2, 4) == "one\n  two\n  three");
  CHECK(wrapped("", 9, 2).empty());
  CHECK(wrapped("a\nb", 9, 2) == "a\n  b");
}

TEST_CASE("a word wider than a line is not split") {
  CHECK(wrapped("a incomprehensibilities b", 8) == "a\nincomprehensibilities\nb");
}

TEST_CASE("a multi-byte character is one column wide") {
  CHECK(textColumns("m\xC2\xB2") == 2);
  CHECK(wrapped("m\xC2\xB2 m\xC2\xB2", 5) == "m\xC2\xB2 m\xC2\xB2");
}

TEST_CASE("a list entry with a wide name starts its text on the next line") {
  CHECK(listEntry("name", "some text", 8, 40) == "  name  some text\n");
  CHECK(listEntry("longer name", "some text", 8, 40) == "  longer name\n        some text\n");
  CHECK(listEntry("name", "", 8, 40) == "  name\n");
}

TEST_CASE("COLUMNS sets the width of help, within limits") {
  const char* before = std::getenv("COLUMNS");
  const std::string kept = before == nullptr ? "" : before;
  for (const auto& [text, width] : {std::pair("72", 72U), {"10", 40U}, {"9999", 200U}}) {
    ::setenv("COLUMNS", text, 1);
    CHECK(simreel::textWidth() == width);
  }
  if (before == nullptr)
    ::unsetenv("COLUMNS");
  else
    ::setenv("COLUMNS", kept.c_str(), 1);
}
