#include "scene/json/member_line.hpp"

#include <vector>

#include <doctest/doctest.h>

using simreel::scene::memberLine;

TEST_CASE("the source line of each member is found") {
  const std::string text = "{ // a scene\n \"objects\":\n {\"a\": 1,\n\n  \"b\": {\"c\": [1,\n 2]}}\n}";
  const auto line = [&](const std::vector<std::string>& path) { return memberLine(text, path); };
  CHECK(line({}) == 1);
  CHECK(line({"objects"}) == 2);
  CHECK(line({"objects", "a"}) == 3);
  CHECK(line({"objects", "b"}) == 5);
  CHECK(line({"objects", "b", "c", "1"}) == 6);
  CHECK(!line({"objects", "b", "c", "2"}));
  CHECK(!line({"objects", "d"}));
  CHECK(!line({"objects", "a", "x"}));
  CHECK(!memberLine("no json", std::vector<std::string>{}));
}
