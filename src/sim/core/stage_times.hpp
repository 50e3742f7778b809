#pragma once
#include "gl/handle.hpp"

#include <array>
#include <chrono>
#include <utility>
#include <vector>

namespace simreel::sim {

/// Milliseconds that the stages of a deformed mesh took.
struct StageTimes {
  double deform = 0;
  double normals = 0;
  double transfer = 0;
};

/// Measures them frame by frame, on the CPU by its clock or on the GPU by timestamps that are read when
/// they are there, never waited for. Switched off it costs nothing.
class StageClock {
 public:
  enum class Of { nothing, cpu, gpu };
  explicit StageClock(Of what);

  void begin();
  /// What passed since begin() or the last lap() counts for `stage`.
  void lap(double StageTimes::*stage);
  void end();
  /// Of the newest frame whose times are known; empty when there is none.
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
