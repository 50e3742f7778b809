#include "sim/rle.hpp"

#include "base/error.hpp"
#include "reference/life_twin.hpp"
#include "unit/help.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::checkHas;
using namespace simreel::sim;

namespace {

std::string mistake(std::string_view text) {
  try {
    static_cast<void>(parseRle(text, "p.rle"));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "no mistake";
}

std::string ruleMistake(std::string_view text) {
  LifeRule rule;
  const LifeRuleProblem problem = parseLifeRule(text, rule);
  return problem.message.empty() ? rule.text() : std::to_string(problem.at) + ": " + problem.message;
}

}  // namespace

TEST_CASE("life rules are read in both spellings") {
  CHECK(ruleMistake("B3/S23") == "B3/S23");
  CHECK(ruleMistake("b36/s23") == "B36/S23");
  CHECK(ruleMistake("B2/S") == "B2/S");
  CHECK(ruleMistake("B/S012345678") == "B/S012345678");
  CHECK(ruleMistake("B0/S8") == "B0/S8");
  CHECK(ruleMistake("23/3") == "B3/S23");
  CHECK(ruleMistake("/2") == "B2/S");
  CHECK(ruleMistake("B8763/S5443") != "B3678/S345");  // a 4 twice
  CHECK(ruleMistake("B87/S54") == "B78/S45");         // written in order
  LifeRule rule;
  CHECK(parseLifeRule("B36/S23", rule).message.empty());
  CHECK(rule.born == (1 << 3 | 1 << 6));
  CHECK(rule.survives == (1 << 2 | 1 << 3));
}

TEST_CASE("rules that make no sense are refused at their place") {
  checkHas(ruleMistake(""), "0: the rule is empty");
  checkHas(ruleMistake("B3"), "2: a slash is missing");
  checkHas(ruleMistake("B3S23"), "2: 'S' is not a number");
  checkHas(ruleMistake("B39/S23"), "2: a cell has 8 neighbours");
  checkHas(ruleMistake("B33/S23"), "2: 3 is there twice");
  checkHas(ruleMistake("B3/23"), "3: an S is missing");
  checkHas(ruleMistake("B3/"), "3: an S is missing");
  checkHas(ruleMistake("B2/S/3"), "4: a second slash");
  checkHas(ruleMistake("B2-a/S12"), "2: '-' is not a number");
  checkHas(ruleMistake("B3/S23V"), "6: 'V' is not a number");
  checkHas(ruleMistake("23/3/2"), "4: a second slash");
  checkHas(ruleMistake("Life"), "0: 'L' is not a number");
  checkHas(ruleMistake("B3/S2\n"), "5: '?' is not");
}

TEST_CASE("RLE with comments, a rule, runs over lines and blanks") {
  const RlePattern p = parseRle(
      "#N name\r\n#C 3o!\n\n  x = 5 ,y=4, rule = b36/s23:T257,130\r\nb\to\n#C between\n2\n$ "
      "3\no2o$$!\nrest 3q",
      "p");
  CHECK(p.size == glm::ivec2(5, 4));
  REQUIRE(p.rule);
  CHECK(p.rule->text() == "B36/S23");
  CHECK(p.border == 'T');
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

TEST_CASE("malformed RLE is refused with line and column") {
  checkHas(mistake(""), "p.rle:1:1: 'x' is expected");
  checkHas(mistake("#C only\n"), "p.rle:2:1: 'x' is expected");
  checkHas(mistake("bo$2bo$3o!"), "p.rle:1:1: 'x' is expected");
  checkHas(mistake("x = 3, z = 3\n3o!"), "p.rle:1:8: 'y' is expected");
  checkHas(mistake("x = , y = 3\n3o!"), "p.rle:1:5: the width is missing");
  checkHas(mistake("x = -3, y = 3\n3o!"), "p.rle:1:5: the width is missing");
  checkHas(mistake("x = 3, y = 99999999999999999999\n3o!"), "p.rle:1:12: the height is above 1048576");
  checkHas(mistake("x = 3, y = 3, colour = 2\n3o!"), "p.rle:1:15: only \"rule = ...\"");
  checkHas(mistake("x = 3, y = 3, rule = B3/S29\n3o!"), "p.rle:1:27: a cell has 8 neighbours");
  checkHas(mistake("x = 3, y = 3, rule = B3/S23:K3,4\n3o!"), "p.rle:1:29: of bounded grids only");
  checkHas(mistake("x = 3, y = 3 3o!"), "p.rle:1:14: '3' after the header");
  checkHas(mistake("x = 3, y = 3\n3o"), "p.rle:2:3: the pattern ends without '!'");
  checkHas(mistake("x = 3, y = 3\n3"), "ends after a count");
  checkHas(mistake("x = 3, y = 3\n3 2o!"), "p.rle:2:3: a second count");
  checkHas(mistake("x = 3, y = 3\n0o!"), "p.rle:2:1: a count of 0");
  checkHas(mistake("x = 3, y = 3\n3!"), "p.rle:2:2: a count before '!'");
  checkHas(mistake("x = 3, y = 3\n3o$\n b3o!"), "p.rle:3:3: living cells 1 to 3 of row 1 lie outside");
  checkHas(mistake("x = 3, y = 3\n3o3$o!"), "p.rle:2:5: living cells 0 to 0 of row 3 lie outside");
  checkHas(mistake("x = 3, y = 3\n2000000o!"), "p.rle:2:1: the count is above 1048576");
  checkHas(mistake("x = 3, y = 3\n.A$2B!"), "p.rle:2:1: '.' is of a pattern with more than two states");
  checkHas(mistake("x = 3, y = 3\npA$2B!"), "p.rle:2:1: 'p' is of a pattern with more than two states");
  checkHas(mistake("x = 3, y = 3\nbo?!"), "p.rle:2:3: '?' where b, o, $ or ! is expected");
  checkHas(mistake(std::string_view("x = 3, y = 3\nb\0o!", 17)), "p.rle:2:2: a byte 0x00");
}

TEST_CASE("what is written is read back, cell for cell, in lines of at most 70 characters") {
  for (const glm::ivec2 size : {glm::ivec2(257, 130), {31, 5}, {1, 1}, {128, 3}, {300, 7}}) {
    for (const float share : {0.0F, 0.02F, 0.5F, 1.0F}) {
      LifeParameters parameters;
      parameters.size = size;
      parameters.fill = share;
      const LifePlan plan(parameters, "cells", 3, 0.1);
      const auto words = plan.firstCells();
      const std::string text = writeRle({size, words}, LifeRule{}, 'T', "one\ntwo");
      std::string_view rest = text;
      for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
        CHECK(end <= 70);
        rest.remove_prefix(end + 1);
      }
      CHECK(rest.empty());
      const RlePattern read = parseRle(text, "written");
      CHECK(read.size == size);
      CHECK(read.rule == LifeRule{});
      CHECK(read.border == 'T');
      CHECK(read.grid == size);
      std::vector<std::uint8_t> cells(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
      for (const RlePattern::Run& run : read.runs)
        for (int i = 0; i < run.length; ++i)
          cells[static_cast<std::size_t>(run.y) * static_cast<std::size_t>(size.x) +
                static_cast<std::size_t>(run.x + i)] = 1;
      CHECK(cells == bytesOf(words, size));
    }
  }
}

TEST_CASE("an RLE file is written as others write it") {
  const auto words = wordsOf({0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0}, {3, 4});
  CHECK(writeRle({{3, 4}, words}, LifeRule{}, 0, "") == "x = 3, y = 4, rule = B3/S23\nbo$2bo$3o!\n");
  CHECK(writeRle({{3, 4}, words}, LifeRule{}, 'P', "c") ==
        "#C c\nx = 3, y = 4, rule = B3/S23:P3,4\nbo$2bo$3o!\n");
}
