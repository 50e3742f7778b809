#pragma once
#include "sim/world/world.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::frame {

/// Table of the simulations' counts (one row per step) or measurements (one row per frame), as CSV. The
/// columns are step (the start is step 0), time (s), and "object.column" for each count. If objects have
/// different step lengths, they share a row where their times are equal. The cells of an object that has no
/// step at a row's time are empty.
class CountTable {
 public:
  /// `fps` is the scene's frame rate.
  CountTable(double fps, std::vector<sim::World::CountNames> names);

  /// Appends the counts of the next frame. Must be called for all frames in ascending order, including
  /// pre-roll frames.
  void add(const sim::World::Summary& summary);
  /// Continues the table of an earlier run. `text`: result of text() in the earlier run.
  void resume(std::string_view text);
  /// True if the table has no rows: if no object has counts, or before the first frame.
  [[nodiscard]] bool empty() const { return names_.empty() || rows_ == 0; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// header() returns the column names, comma separated. lastRow() returns the last row.
  [[nodiscard]] std::string_view header() const;
  [[nodiscard]] std::string_view lastRow() const;

 private:
  void addRow(double time, const std::vector<const glm::uvec4*>& counts);

  double fps_;
  std::vector<sim::World::CountNames> names_;
  std::string text_;
  long rows_ = 0;
};

}  // namespace simreel::frame
