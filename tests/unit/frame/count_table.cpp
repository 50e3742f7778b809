// Tests the table that is written next to the frames: counts of each step, and quantities measured once per
// frame.
#include "frame/file/count_table.hpp"

#include <bit>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE(
    "count table: measured values stand next to counts, in the shortest form that reads back exactly") {
  sim::World::CountNames fire{"fire", {"burning", "burnt"}};
  sim::World::CountNames pond{"pond", {"a", "b", "c", "d", "e"}};
  pond.elements = 2;
  pond.measured = true;
  frame::CountTable table(10, {fire, pond});
  const auto row = [](float first, float last) {
    return std::vector<glm::uvec4>{{std::bit_cast<unsigned>(first), 0, 0, std::bit_cast<unsigned>(0.1F)},
                                   {std::bit_cast<unsigned>(last), 0, 0, 0}};
  };
  table.add({0, {}, {}, {{{1, 2, 0, 0}}, row(0.5F, -3)}});
  table.add({1, {}, {}, {{{3, 4, 0, 0}, {5, 6, 0, 0}}, row(1e-7F, 1e20F)}});
  CHECK(table.text() ==
        "step,time,fire.burning,fire.burnt,pond.a,pond.b,pond.c,pond.d,pond.e\n"
        "0,0.000000,1,2,0.5,0,0,0.1,-3\n"
        "1,0.050000,3,4,,,,,\n"
        "2,0.100000,5,6,1e-07,0,0,0.1,1e+20\n");
}
