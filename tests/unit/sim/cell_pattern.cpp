// Tests patterns in formats of other programs, and the grid size that is chosen for them.
#include "sim/life/cell_pattern.hpp"

#include "base/error.hpp"
#include "sim/life/plan.hpp"
#include "sim/life/rle.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"
#include "unit/sim/notation_help.hpp"

#include <set>
#include <utility>

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::checkHas;
using namespace simreel::sim;

namespace {

using Cells = std::set<std::pair<int, int>>;

Cells cellsOf(const CellPattern& pattern) {
  Cells cells;
  for (const CellPattern::Run& run : pattern.runs)
    for (int i = 0; i < run.length; ++i) cells.emplace(run.x + i, run.y);
  return cells;
}

const Cells glider = {{1, 0}, {2, 1}, {0, 2}, {1, 2}, {2, 2}};

std::string mistake(std::string_view text) {
  return test::mistakeIn([&] { return parsePattern(text, "p"); });
}

Cells living(const LifePlan& plan) {
  const glm::ivec2 size = plan.parameters().size;
  const auto words = plan.firstCells();
  const CellRows rows{size, words};
  Cells cells;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      if (rows.alive(x, y)) cells.emplace(x, y);
  return cells;
}

LifeParameters fitted(const char* pattern) {
  LifeParameters p;
  p.fill = 0;
  p.fitted = true;
  LifePattern placed;
  placed.file = sourceFolder() + "/assets/patterns/" + pattern + ".rle";
  p.patterns.push_back(placed);
  return p;
}

}  // namespace

TEST_CASE("a glider in every format is the same glider") {
  for (const char* text :
       {"x = 3, y = 3, rule = B3/S23\nbo$2bo$3o!", "bo$2bo$3o", ".A$..A$AAA!", ".O\n..O\nOOO\n",
        "!Name: Glider\r\n!\r\n.O.\r\n..O\r\nOOO\r\n", "!\n.*\n..*\n***",
        "#Life 1.06\n0 -1\n1 0\n-1 1\n0 1\n1 1\n", "#Life 1.06\r\n7 7\r\n8 8\r\n6 9\r\n7 9\r\n8 9\r\n",
        "#Life 1.05\n#D a glider\n#N\n#P -1 -1\n.*.\n..*\n***\n",
        "#Life 1.05\n#P 4 5\n*\n.*\n#P 3 7\n***\n", "#Life 1.05\n#P\n.*\n#P\n..*\n***\n",
        "\xEF\xBB\xBF#Life 1.06\n1 0\n2 1\n0 2\n1 2\n2 2\n"}) {
    CAPTURE(text);
    const CellPattern pattern = parsePattern(text, "p");
    CHECK(cellsOf(pattern) == glider);
    CHECK(pattern.size == glm::ivec2(3, 3));
  }
  CHECK(cellsOf(parsePattern("!c\n\n.O\n\nO\n", "p")) == Cells{{1, 0}, {0, 2}});
  CHECK(parsePattern("#Life 1.05\n#R 23/36\n#P 0 0\n*", "p").rule->text() == "B36/S23");
  // Pattern files that come with Golly and XLife contain rules without survival.
  CHECK(parsePattern("#Life 1.05\n#R B234\n#P 0 0\n*", "p").rule->text() == "B234/S");
  CHECK(parsePattern("x = 1, y = 1, rule = b2\no!", "p").rule->text() == "B2/S");
  CHECK(parsePattern("#C one\n#r 12/34\no!", "p").rule->text() == "B34/S12");
}

TEST_CASE("errors in patterns have line and column") {
  checkHas(mistake("#Life 1.07\n0 1\n"), "p:1:1: of the formats that begin with \"#Life\"");
  checkHas(mistake("#Life 1.06\n0 1\n2\n"), "p:3:2: a whole number is missing");
  checkHas(mistake("#Life 1.06\n0 1 2\n"), "p:2:4: a line holds the place of one cell");
  checkHas(mistake("#Life 1.06\n0 99999999999\n"), "p:2:3: a place beyond");
  checkHas(mistake("#Life 1.06\n0 0\n0 2000000\n"), "the living cells are 1 x 2000001 apart");
  checkHas(mistake("#Life 1.05\n#R 29/3\n#P 0 0\n*"), "p:2:5: a cell has 8 neighbours");
  checkHas(mistake("!c\n.O.\n.3.\n"), "p:3:2: '3' in a row of cells");
  checkHas(mistake("[M2] (golly 3.4)\n#R B3/S23\n"), "p:3:1: no squares; the file may be cut off");
  checkHas(mistake("[M2]\n.*$\n4 1 0 0 7\n"), "p:3:9: square 7 does not come before this one");
  checkHas(mistake("[M2]\n.*$\n5 1 0 0 0\n"), "p:3:3: square 1 is not half as large");
  checkHas(mistake("[M2]\n.*o$\n"), "p:2:3: 'o' in a square of 8 x 8 cells");
  checkHas(mistake("[M2]\n.........*$\n"), "p:2:9: a cell beyond a square");
  checkHas(mistake("[M2]\n4 1 0\n"), "p:2:3: square 1 does not come before");
  checkHas(mistake("[M2]\n1 0 0 0 256\n"), "p:2:9: states go from 0 to 255");
  checkHas(mistake("[M2]\n1 0 0 0 5 6\n"), "p:2:10: ' ' after the five numbers");
  checkHas(mistake("[M2]\n#R B3/S29\n"), "p:2:9: a cell has 8 neighbours");
  // Each level is twice as large as the previous one. One or two of its quadrants contain the previous
  // level.
  const auto deep = [](int levels, bool twice) {
    std::string text = "[M2]\n*$\n";
    for (int level = 4; level < levels; ++level) {
      const std::string below = std::to_string(level - 3);
      text += std::to_string(level) + " " + below + " 0 0 " + (twice || level + 1 == levels ? below : "0") +
              "\n";
    }
    return text;
  };
  checkHas(mistake(deep(40, false)), "apart, the maximum");
  checkHas(mistake(deep(40, true)), "more than 134217728 living cells");
}

TEST_CASE("pattern files are recognized by the extension of their name") {
  for (const char* name :
       {"gun.rle", "a/b.RLE", "c.cells", "d.Life", "e.lif", "f.mc", "g.rle.gz", "h.mc.GZ"})
    CHECK(isPatternName(name));
  for (const char* name : {"gun.json", "rle", "gun.rle.json", "gun", "gun.gz"})
    CHECK_FALSE(isPatternName(name));
}

TEST_CASE(
    "an unspecified grid size fits its patterns with the aspect ratio 16 to 9, and the patterns are "
    "centred") {
  const LifePlan gun(fitted("gosper_gun"), "cells", 1, 0.1);
  CHECK(gun.parameters().size == glm::ivec2(80, 45));  // The gun has 36 x 9 cells. With a margin of 18 on
                                                       // every side, the grid must have at least 72 x 45
                                                       // cells.
  const Cells cells = living(gun);
  CHECK(cells.size() == 36);
  for (const auto& [x, y] : cells) {
    CHECK(x >= 22);
    CHECK(x < 58);
    CHECK(y >= 18);
    CHECK(y < 27);
  }
  const LifePlan glider(fitted("glider"), "cells", 1, 0.1);
  CHECK(glider.parameters().size == glm::ivec2(48, 27));  // The margin is at least 12 on every side.
  auto turned = fitted("gosper_gun");
  turned.patterns[0].rotate = 90;
  // The rotated pattern is 9 x 36, so the grid needs a height of 72.
  CHECK(LifePlan(turned, "cells", 1, 0.1).parameters().size == glm::ivec2(128, 72));
  auto placed = fitted("glider");
  placed.patterns[0].at = glm::ivec2(100, 5);
  // The placed pattern needs 115 x 20 cells.
  CHECK(LifePlan(placed, "cells", 1, 0.1).parameters().size == glm::ivec2(128, 72));
  CHECK(living(LifePlan(placed, "cells", 1, 0.1)).contains({101, 5}));
}

TEST_CASE("a pattern is placed exactly, also across words and a torus's border") {
  LifeParameters soup;
  soup.size = {131, 9};
  soup.fill = 0.8F;  // The pattern is dense, so that runs of living cells are long.
  const auto words = LifePlan(soup, "cells", 5, 0.1).firstCells();
  const simreel::test::TemporaryFile file("soup.rle", writeRle({soup.size, words}, LifeRule{}, "", ""));
  for (const glm::ivec2 at : {glm::ivec2(0, 0), {13, 4}, {169, 11}, {250, -3}}) {
    LifeParameters p = fitted("glider");
    p.fitted = false;
    p.size = {300, 20};
    p.patterns[0].file = file.path();
    p.patterns[0].at = at;
    Cells expected;
    for (int y = 0; y < soup.size.y; ++y)
      for (int x = 0; x < soup.size.x; ++x)
        if (CellRows{soup.size, words}.alive(x, y))
          expected.insert({(at.x + x) % p.size.x, (at.y + y + p.size.y) % p.size.y});
    CHECK(living(LifePlan(p, "cells", 1, 0.1)) == expected);
  }
}

TEST_CASE("a pattern made for a bounded grid sets that grid") {
  const simreel::test::TemporaryFile file("bounded.rle", "x = 3, y = 1, rule = B3/S23:P31,20\n3o!");
  LifeParameters p = fitted("glider");
  p.patterns[0].file = file.path();
  const LifePlan plan(p, "cells", 1, 0.1);
  CHECK(plan.parameters().size == glm::ivec2(31, 20));
  CHECK_FALSE(plan.torus());
  CHECK(living(plan) == Cells{{14, 10}, {15, 10}, {16, 10}});
  p.borderGiven = true;  // The scene's border is a torus, but the file has another border.
  CHECK_THROWS_AS(LifePlan(p, "cells", 1, 0.1), UserError);
}

TEST_CASE("a pattern's position in its bounded grid is kept") {
  const auto placed = [](const std::string& name, const std::string& text, auto change) {
    const simreel::test::TemporaryFile file(name, text);
    LifeParameters p = fitted("glider");
    p.patterns[0].file = file.path();
    change(p.patterns[0]);
    const LifePlan plan(p, "cells", 1, 0.1);
    CHECK(plan.parameters().size == glm::ivec2(30, 30));
    return living(plan);
  };
  const auto asIs = [](LifePattern&) {};
  // This position is in the notation of Golly's files.
  const std::string rle = "#CXRLE Pos=-15,-14 Gen=7\nx = 3, y = 1, rule = B3/S23:P30,30\n2ob!";
  CHECK(placed("at.rle", "#C\n" + rle, asIs) == Cells{{0, 1}, {1, 1}});
  CHECK(placed("at.rle", rle, [](LifePattern& p) { p.at = glm::ivec2(4, 5); }) == Cells{{4, 5}, {5, 5}});
  // The whole grid is flipped and rotated, not only the pattern.
  CHECK(placed("at.rle", rle, [](LifePattern& p) { p.flip = LifePattern::Flip::horizontal; }) ==
        Cells{{29, 1}, {28, 1}});
  CHECK(placed("at.rle", rle, [](LifePattern& p) { p.flip = LifePattern::Flip::vertical; }) ==
        Cells{{0, 28}, {1, 28}});
  CHECK(placed("at.rle", rle, [](LifePattern& p) { p.rotate = 90; }) == Cells{{28, 0}, {28, 1}});
  CHECK(placed("at.rle", rle, [](LifePattern& p) { p.rotate = 180; }) == Cells{{29, 28}, {28, 28}});
  CHECK(placed("at.rle", rle, [](LifePattern& p) { p.rotate = 270; }) == Cells{{1, 29}, {1, 28}});
  // The file has two squares of 8 x 8 cells in the north-west and the south-east of a square of 16 x 16
  // cells, whose centre is the grid's centre.
  CHECK(placed("at.mc", "[M2] (golly 3.3)\n#R B3/S23:T30,30\n.*$\n4 1 0 0 1\n", asIs) ==
        Cells{{8, 8}, {16, 16}});
  checkHas(mistake("#CXRLE Pos=3\nx = 3, y = 1\n3o!"), "p:1:8: a place is expected here");
}

TEST_CASE("gzipped patterns are read; truncated ones and those of 64 MiB are refused") {
  // These bytes are the output of gzip -9 for a pattern file of two lines, "x = 3, y = 1" and "3o!".
  const std::string packed(
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\xab\x50\xb0\x55\x30\xd6\x51"
      "\xa8\x04\x52\x86\x5c\xc6\xf9\x8a\x5c\x00\xa0\x80\xbc\x91\x11\x00\x00\x00",
      35);
  const simreel::test::TemporaryFile whole("three.rle.gz", packed);
  CHECK(cellsOf(readPattern(whole.path())) == Cells{{0, 0}, {1, 0}, {2, 0}});
  const auto refused = [](const std::string& bytes) {
    const simreel::test::TemporaryFile file("three.rle.gz", bytes);
    try {
      static_cast<void>(readPattern(file.path()));
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was refused");
  };
  checkHas(refused(packed.substr(0, packed.size() - 3)), "is cut off within its gzip data");
  std::string damaged = packed;
  damaged[damaged.size() - 6] = 'x';
  checkHas(refused(damaged), "is damaged");
}

TEST_CASE("macrocell files with two and with several states are read") {
  const CellPattern two =
      parsePattern("[M2] (golly 3.3)\n#R B36/S23:T40,30\n$$..*$...*$.***$$$$\n4 0 1 1 0\n", "p");
  CHECK(two.rule == CellRule(LifeRule{1 << 3 | 1 << 6, 12}));
  CHECK(two.size == glm::ivec2(11, 11));
  int living = 0;
  for (const CellPattern::Run& run : two.runs) living += run.length;
  CHECK(living == 10);
  const CellPattern many = parsePattern("[M2]\n#R /2/3\n1 0 1 2 0\n1 0 0 0 2\n2 1 0 0 2\n", "p");
  CHECK(many.highest == 2);
  REQUIRE(many.runs.size() == 3);
  CHECK(many.runs[0].state == 1);
  CHECK(many.runs[1].state == 2);
  CHECK(many.size == glm::ivec2(4, 4));
  // Reading nested empty squares takes almost no time.
  std::string hollow = "[M2]\n$\n";
  for (int level = 4; level < 60; ++level) {
    const std::string child = " " + std::to_string(level - 3);
    hollow += std::to_string(level) + child + child + child + child + "\n";
  }
  CHECK(parsePattern(hollow, "p").runs.empty());
}
