#pragma once
#include "gl/handle.hpp"

#include <array>
#include <chrono>
#include <utility>
#include <vector>

namespace simreel::sim {

/// Stage times of a deformed mesh in milliseconds.
struct StageTimes {
  double deform = 0;
  double normals = 0;
  double transfer = 0;
};

/// Measures stage times per frame: on the CPU by its clock, or on the GPU by timestamp queries that are
/// read when available, without waiting. Costs nothing when off.
class StageClock {
 public:
  enum class Of { nothing, cpu, gpu };
  explicit StageClock(Of what);

  void begin();
  /// Attributes the time since begin() or the previous lap() to `stage`.
  void lap(double StageTimes::*stage);
  void end();
  /// Returns the times of the newest measured frame; empty before the first measurement.
  [[nodiscard]] std::vector<std::pair<const char*, double>> times() const;

 private:
  static constexpr int maxLaps = 4;
  struct Frame {
    std::array<gl::Handle<gl::DeleteQuery>, maxLaps + 1> stamps;
    std::array<double StageTimes::*, maxLaps> stages{};
    int laps = 0;
    bool pending = false;
  };
  void collect();

  Of what_;
  bool known_ = false;
  StageTimes newest_, present_;
  std::chrono::steady_clock::time_point last_;
  std::array<Frame, 4> frames_;
  std::size_t current_ = 0;
  bool measuring_ = false;
};

}  // namespace simreel::sim
