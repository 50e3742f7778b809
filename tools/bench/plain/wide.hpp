// A simple single-threaded version of Larger than Life, with which bench_wide compares the kernels.
#pragma once
#include <cstdint>
#include <vector>

namespace plain {

/// Bosco's rule or another Larger-than-Life rule on a torus, with one byte per cell.
class Wide {
 public:
  struct Rule {
    std::vector<int> half;  ///< number of columns to either side in each of the 2 range + 1 rows around a
                            ///< cell
    int surviveMin, surviveMax, bornMin, bornMax;  ///< limits of neighbour counts, which include the cell
                                                   ///< itself
  };
  Wide(int width, int height, const Rule& rule);
  void stepDirect();      ///< adds up all neighbours of each cell
  void direct(int rows);  ///< computes only the first `rows` rows and discards the result, for measurements
                          ///< of large neighbourhoods
  /// uses running sums: for squares along the columns and then along the rows, for other shapes along each
  /// row
  void stepRunning();
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
