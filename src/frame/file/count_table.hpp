#pragma once
#include "sim/world/world.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::frame {

/// What the simulations of a run count in each of their steps, or measure in each frame, as CSV: step
/// (since the start, which is step 0), time (s), and a column for each count, "object.column". Objects with
/// steps of other lengths share rows where their times agree and leave cells empty elsewhere.
class CountTable {
 public:
  /// `fps` of the scene.
  CountTable(double fps, std::vector<sim::World::CountNames> names);

  /// The next frame's counts, in order of frames, the pre-roll's too.
  void add(const sim::World::Summary& summary);
  /// Goes on after another run's rows, text() of it.
  void resume(std::string_view text);
  /// Without counting objects, or before the first frame.
  [[nodiscard]] bool empty() const { return names_.empty() || rows_ == 0; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Names of the columns, and the last row; comma separated.
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
