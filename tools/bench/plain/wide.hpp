// Larger than Life as one writes it in an afternoon, on one thread: what bench_wide holds the kernels
// against.
#pragma once
#include <cstdint>
#include <vector>

namespace plain {

/// Bosco's rule or another on a torus, a byte a cell.
class Wide {
 public:
  struct Rule {
    std::vector<int> half;  ///< columns to either side in each of the 2 range + 1 rows around a cell
    int surviveMin, surviveMax, bornMin, bornMax;  ///< a cell counts itself
  };
  Wide(int width, int height, const Rule& rule);
  void stepDirect();      ///< every cell adds up all cells around it
  void direct(int rows);  ///< the same of the first rows alone, which nobody sees: for its time
  void stepRunning();  ///< running sums: of squares down the columns, then along the rows; else row by row
  std::vector<std::uint8_t> cells;

 private:
  [[nodiscard]] std::uint8_t next(std::uint8_t cell, int count) const {
    return cell != 0 ? count >= rule_.surviveMin && count <= rule_.surviveMax
                     : count >= rule_.bornMin && count <= rule_.bornMax;
  }
  [[nodiscard]] const std::uint8_t* row(int y) const {
    return &cells[static_cast<std::size_t>((y + height_) % height_) * width_];
  }
  void runSquares();
  void runRows();

  int width_, height_, range_;
  Rule rule_;
  bool square_ = true;
  std::vector<std::uint8_t> next_;
  std::vector<std::uint16_t> columns_;
};

}  // namespace plain
