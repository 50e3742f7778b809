// Tests reading fields back: every cell type, padded rows, and gaps between cells.
#include "sim/grid/field_values.hpp"

#include "gpu/draw/field_stage.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using Cells = sim::Field::Cells;

TEST_CASE("field values are read back bit for bit") {
  testContext();
  for (const Cells cells : {Cells::bits, Cells::bytes, Cells::floats, Cells::colors})
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(67, 35), glm::ivec2(32, 3), glm::ivec2(5, 64)}) {
      const auto value = [&](int x, int y) {
        return cells == Cells::bits    ? double((x * y + x) % 3 == 1)
               : cells == Cells::bytes ? double((x * 31 + y * 7) % 256)
                                       : 0.37 * x - 1.5 * y;
      };
      for (const FieldStage::Memory memory : {FieldStage::Memory{3, 5, 2}, FieldStage::Memory{0, 0, 1}}) {
        const FieldStage stage(cells, size, value, memory);
        const auto values = sim::fieldValues(stage.field);
        REQUIRE(values.size() == static_cast<std::size_t>(size.x * size.y));
        int wrong = 0;
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x)
            wrong += values[static_cast<std::size_t>(y * size.x + x)] != static_cast<float>(value(x, y));
        CHECK(wrong == 0);
      }
    }
  testContext().check();
}
