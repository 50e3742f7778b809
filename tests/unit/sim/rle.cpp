#include "sim/life/rle.hpp"

#include "reference/life_twin.hpp"
#include "unit/help.hpp"
#include "unit/sim/notation_help.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::checkHas;
using simreel::test::written;
using namespace simreel::sim;

namespace {

std::string mistake(std::string_view text) {
  return test::mistakeIn([&] { return parseRle(text, "p.rle"); });
}

}  // namespace

TEST_CASE("life rules are read in both notations") {
  CHECK(written("B3/S23") == "B3/S23");
  CHECK(written("b36/s23") == "B36/S23");
  CHECK(written("B2/S") == "B2/S");
  CHECK(written("B/S012345678") == "B/S012345678");
  CHECK(written("B0/S8") == "B0/S8");
  CHECK(written("23/3") == "B3/S23");
  CHECK(written("/2") == "B2/S");
  CHECK(written("B8763/S5443") != "B3678/S345");  // The text is invalid, because the digit 4 occurs twice.
  CHECK(written("b3s23") == "B3/S23");
  CHECK(written("B36S23") == "B36/S23");
  CHECK(written("S23/B36") == "B36/S23");
  CHECK(written("s/b2") == "B2/S");
  CHECK(written("SB2") == "B2/S");
  CHECK(written("life") == "B3/S23");
  CHECK(written("B87/S54") == "B78/S45");  // The counts are written in ascending order.
  CellRule rule;
  CHECK(parseCellRule("B36/S23", rule).message.empty());
  CHECK(rule.counts == LifeRule{1 << 3 | 1 << 6, 1 << 2 | 1 << 3});
}

TEST_CASE("invalid rules are refused at their position") {
  checkHas(written(""), "0: the rule is empty");
  checkHas(written("B3"), "2: an S is missing");
  checkHas(written("S23/"), "4: a B is missing");
  checkHas(written("B3/B3"), "3: an S is missing");
  checkHas(written("3"), "1: a slash is missing");
  checkHas(written("B39/S23"), "2: a cell has 8 neighbours");
  checkHas(written("B33/S23"), "2: 3 occurs twice");
  checkHas(written("B3/23"), "3: an S is missing");
  checkHas(written("B3/"), "3: an S is missing");
  checkHas(written("B3/S2\n"), "5: '?' is not");
}

TEST_CASE("rules of other kinds are named in the error") {
  checkHas(written("B45/S34L"), "triangles");
  checkHas(written("W111"), "1: 111 is odd");
  checkHas(written("M0,8,4,3,2,5,9,7,1,6,10,11,12,13,14,15"), "Margolus");
  checkHas(written("LifeHistory"), "0: this rule is unknown");
}

TEST_CASE("bounded grids of an RLE file are read") {
  const auto shaped = [](const char* suffix) {
    const CellPattern p = parseRle(std::string("x = 1, y = 1, rule = B3/S23") + suffix + "\no!", "p");
    REQUIRE(p.shape);
    return p.shape->suffix(p.grid);
  };
  for (const char* suffix : {":T30,20", ":P7,5", ":T30+5,20", ":T30,20-2", ":K30*,20", ":K30,20*",
                             ":K30*+1,20", ":C30,20", ":S30"})
    CHECK(shaped(suffix) == suffix);
  CHECK(shaped(":t30,20") == ":T30,20");
  const auto refused = [](const char* suffix, const char* what) {
    checkHas(mistake(std::string("x = 1, y = 1, rule = B3/S23") + suffix + "\no!"), what);
  };
  refused(":X3,4", "p.rle:1:29: a bounded grid is");
  refused(":T0,4", "1:30: a side of 0");
  refused(":T3,", "1:32: the grid's height is missing");
  refused(":T30+5,20+1", "shifted in one direction only");
  refused(":P30+5,20", "only a torus and a Klein bottle");
  refused(":K31*+1,20", "even number");
  refused(":K30*,20*", "one pair of edges");
  refused(":S30,20", "a sphere needs a square grid");
}

TEST_CASE("RLE with comments, a rule, runs across lines and blanks is read") {
  const CellPattern p = parseRle(
      "#N name\r\n#C 3o!\n\n  x = 5 ,y=4, rule = b36/s23:T257,130\r\nb\to\n#C between\n2\n$ "
      "3\no2o$$!\nrest 3q",
      "p");
  CHECK(p.size == glm::ivec2(5, 4));
  REQUIRE(p.rule);
  CHECK(p.rule->text() == "B36/S23");
  CHECK(p.shape == GridShape());
  CHECK(p.grid == glm::ivec2(257, 130));
  REQUIRE(p.runs.size() == 2);
  CHECK(p.runs[0].x == 1);
  CHECK(p.runs[0].y == 0);
  CHECK(p.runs[0].length == 1);
  CHECK(p.runs[1].x == 0);
  CHECK(p.runs[1].y == 2);
  CHECK(p.runs[1].length == 5);
  CHECK_FALSE(parseRle("x=1,y=1\no!", "p").rule);
  CHECK(parseRle("x = 0, y = 0\n!", "p").runs.empty());
}

TEST_CASE(
    "RLE as other programs write it: files are read with no header, no final mark, dots and capitals") {
  for (const char* text :
       {"bo$2bo$3o!", "bo$2bo$3o", "#C a glider\n.A$..A$3A!", "x = 3, y = 3\nbo$2bo$3o\n"}) {
    CAPTURE(text);
    const CellPattern p = parseRle(text, "p");
    CHECK(p.size == glm::ivec2(3, 3));
    REQUIRE(p.runs.size() == 3);
    CHECK(p.runs[0].x == 1);
    CHECK(p.runs[1].y == 1);
    CHECK(p.runs[2].length == 3);
    CHECK_FALSE(p.rule);
  }
}

TEST_CASE("malformed RLE is refused with line and column") {
  checkHas(mistake(""), "p.rle:1:1: no pattern");
  checkHas(mistake("#C only\n"), "p.rle:1:1: no pattern");
  checkHas(mistake("{\"version\": 1}"), "p.rle:1:1: '{' where b, o, $ or ! is expected");
  checkHas(mistake("1048576b3o"), "p.rle:1:9: a living cell at [1048578, 0], beyond 1048576");
  checkHas(mistake("x = 3, z = 3\n3o!"), "p.rle:1:8: 'y' is expected");
  checkHas(mistake("x = , y = 3\n3o!"), "p.rle:1:5: the width is missing");
  checkHas(mistake("x = -3, y = 3\n3o!"), "p.rle:1:5: the width is missing");
  checkHas(mistake("x = 3, y = 99999999999999999999\n3o!"), "p.rle:1:12: the height is above 1048576");
  checkHas(mistake("x = 3, y = 3, colour = 2\n3o!"), "p.rle:1:15: only \"rule = ...\"");
  checkHas(mistake("x = 3, y = 3, rule = B3/S29\n3o!"), "p.rle:1:27: a cell has 8 neighbours");
  checkHas(mistake("x = 3, y = 3, rule = B3/S23:K3,4\n3o!"),
           "p.rle:1:29: a Klein bottle has one pair of edges reversed");
  checkHas(mistake("x = 3, y = 3 3o!"), "p.rle:1:14: '3' after the header");
  checkHas(mistake("x = 3, y = 3\n3"), "ends after a count");
  checkHas(mistake("x = 3, y = 3\n3 2o!"), "p.rle:2:3: a second count");
  checkHas(mistake("x = 3, y = 3\n0o!"), "p.rle:2:1: a count of 0");
  checkHas(mistake("x = 3, y = 3\n3!"), "p.rle:2:2: a count before '!'");
  checkHas(mistake("x = 3, y = 3\n3o$\n b3o!"), "p.rle:3:3: living cells 1 to 3 of row 1 lie outside");
  checkHas(mistake("x = 3, y = 3\n3o3$o!"), "p.rle:2:5: living cells 0 to 0 of row 3 lie outside");
  checkHas(mistake("x = 3, y = 3\n2000000o!"), "p.rle:2:1: the count is above 1048576");
  checkHas(mistake("x = 3, y = 3\n.A$2pZ!"), "p.rle:2:5: 'p' begins a state above 24");
  checkHas(mistake("x = 3, y = 3\nyP!"), "p.rle:2:1: 'y' begins a state above 24");
  checkHas(mistake("x = 3, y = 3\nbo?!"), "p.rle:2:3: '?' where b, o, $ or ! is expected");
  checkHas(mistake(std::string_view("x = 3, y = 3\nb\0o!", 17)), "p.rle:2:2: a byte 0x00");
}

TEST_CASE("a written RLE is read back cell for cell, with lines of at most 70 characters") {
  for (const glm::ivec2 size : {glm::ivec2(257, 130), {31, 5}, {1, 1}, {128, 3}, {300, 7}}) {
    for (const float fraction : {0.0F, 0.02F, 0.5F, 1.0F}) {
      LifeParameters parameters;
      parameters.size = size;
      parameters.fill = fraction;
      const LifePlan plan(parameters, "cells", 3, 0.1);
      const auto words = plan.firstCells();
      const std::string text = writeRle({size, words}, LifeRule{}, GridShape().suffix(size), "one\ntwo");
      std::string_view rest = text;
      for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
        CHECK(end <= 70);
        rest.remove_prefix(end + 1);
      }
      CHECK(rest.empty());
      const CellPattern read = parseRle(text, "written");
      CHECK(read.size == size);
      CHECK(read.rule == CellRule());
      CHECK(read.shape == GridShape());
      CHECK(read.grid == size);
      std::vector<std::uint8_t> cells(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
      for (const CellPattern::Run& run : read.runs)
        for (int i = 0; i < run.length; ++i)
          cells[static_cast<std::size_t>(run.y) * static_cast<std::size_t>(size.x) +
                static_cast<std::size_t>(run.x + i)] = 1;
      CHECK(cells == bytesOf(words, size));
    }
  }
}

TEST_CASE("an RLE file equals what other programs write") {
  const auto words = wordsOf({0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0}, {3, 4});
  CHECK(writeRle({{3, 4}, words}, LifeRule{}, "", "") == "x = 3, y = 4, rule = B3/S23\nbo$2bo$3o!\n");
  CHECK(writeRle({{3, 4}, words}, LifeRule{}, ":P3,4", "c") ==
        "#C c\nx = 3, y = 4, rule = B3/S23:P3,4\nbo$2bo$3o!\n");
}
