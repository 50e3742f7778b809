// Larger than Life on squares as one writes it in an afternoon, on one thread: what bench_wide holds the
// kernels against.
#pragma once
#include <cstdint>
#include <vector>

namespace plain {

/// Bosco's rule or another on a torus, a byte a cell.
class Wide {
 public:
  struct Rule {
    int range, surviveMin, surviveMax, bornMin, bornMax;  ///< a cell counts itself
  };
  Wide(int width, int height, const Rule& rule);
  void stepDirect();   ///< every cell adds up all cells around it
  void stepRunning();  ///< running sums down the columns, then along the rows
  std::vector<std::uint8_t> cells;

 private:
  int width_, height_;
  Rule rule_;
  std::vector<std::uint8_t> next_, columns_;
};

}  // namespace plain
