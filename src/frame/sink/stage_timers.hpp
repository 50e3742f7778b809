#pragma once
#include "base/clock.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"

#include <deque>
#include <map>

namespace simreel::frame {

/// Adds the time from its construction to its destruction to the time of a stage.
class Stopwatch {
 public:
  explicit Stopwatch(double& stage) : stage_(stage), begin_(Clock::now()) {}
  /// Also adds the measured time to the time of one frame. `ofFrame` must outlive the stopwatch.
  Stopwatch(double& stage, double& ofFrame) : stage_(stage), ofFrame_(&ofFrame), begin_(Clock::now()) {}
  ~Stopwatch() {
    const double seconds = secondsSince(begin_);
    stage_ += seconds;
    if (ofFrame_ != nullptr) *ofFrame_ += seconds;
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& stage_;
  double* ofFrame_ = nullptr;
  Clock::time_point begin_;
};

/// Measures the stages of a run. On a GPU, timer queries measure the device work, because commands run
/// later than they are issued. On a software driver, the CPU clock measures it.
class StageTimers {
 public:
  StageTimers() : byQuery_(!gl::softwareDriver()) {}

  [[nodiscard]] StageTimes& stages() { return stages_; }

  /// Measures a stage with the CPU clock as long as the returned stopwatch exists.
  [[nodiscard]] Stopwatch watch(double StageTimes::*stage) { return Stopwatch(stages_.*stage); }
  /// Measures a stage of one frame with the CPU clock.
  [[nodiscard]] Stopwatch watch(double StageTimes::*stage, int frame) {
    return {stages_.*stage, ofFrame_[frame].*stage};
  }
  /// Returns the times of a frame plus the times of earlier frames that have not been returned yet. Removes
  /// them from the list.
  [[nodiscard]] StageTimes takeUpTo(int frame) {
    StageTimes sum;
    const auto end = ofFrame_.upper_bound(frame);
    for (auto at = ofFrame_.begin(); at != end; ++at)
      for (const auto stage : {&StageTimes::simulate, &StageTimes::draw, &StageTimes::readBack})
        sum.*stage += at->second.*stage;
    ofFrame_.erase(ofFrame_.begin(), end);
    return sum;
  }

  template <class Work>
  void run(double StageTimes::*stage, int frame, const Work& work) {
    if (!byQuery_) {
      const Stopwatch time = watch(stage, frame);
      return work();
    }
    pending_.push_back({{}, frame, stage});
    pending_.back().query.begin();
    work();
    pending_.back().query.end();
  }
  /// Measures the time that the CPU waits for the device, only on a software driver. On a GPU, the timer
  /// queries already include this time.
  template <class Work>
  void wait(double StageTimes::*stage, int frame, const Work& work) {
    if (byQuery_) return work();
    const Stopwatch time = watch(stage, frame);
    work();
  }
  /// Adds the timer query results up to `frame`. The device must have finished those frames.
  void collect(int frame) {
    for (; !pending_.empty() && pending_.front().frame <= frame; pending_.pop_front()) {
      const Pending& done = pending_.front();
      const double seconds = done.query.nanoseconds() * 1e-9;
      stages_.*done.stage += seconds;
      ofFrame_[done.frame].*done.stage += seconds;
    }
  }

 private:
  struct Pending {
    gl::TimerQuery query;
    int frame;
    double StageTimes::*stage;
  };
  StageTimes stages_;
  std::map<int, StageTimes> ofFrame_;  ///< times of frames not yet returned by takeUpTo()
  bool byQuery_;
  std::deque<Pending> pending_;
};

}  // namespace simreel::frame
