#pragma once
#include "base/clock.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"

#include <deque>
#include <map>

namespace simreel::frame {

/// Adds the time of its own life to a stage.
class Stopwatch {
 public:
  explicit Stopwatch(double& stage) : stage_(stage), begin_(Clock::now()) {}
  /// Also adds to the times of a frame, which outlives it.
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

/// Times the stages of a run: what the device does by timer queries on a GPU, since its commands run later,
/// and by the clock on a software driver.
class StageTimers {
 public:
  StageTimers() : byQuery_(!gl::softwareDriver()) {}

  [[nodiscard]] StageTimes& stages() { return stages_; }

  /// By the clock, for as long as the stopwatch lives.
  [[nodiscard]] Stopwatch watch(double StageTimes::*stage) { return Stopwatch(stages_.*stage); }
  /// The same for one frame.
  [[nodiscard]] Stopwatch watch(double StageTimes::*stage, int frame) {
    return {stages_.*stage, ofFrame_[frame].*stage};
  }
  /// Times of a frame, and of those before it that were not asked for.
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
  /// Waiting for the device counts for a software driver only: elsewhere the queries have it.
  template <class Work>
  void wait(double StageTimes::*stage, int frame, const Work& work) {
    if (byQuery_) return work();
    const Stopwatch time = watch(stage, frame);
    work();
  }
  /// Adds the results of everything up to a frame that the device has finished.
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
  std::map<int, StageTimes> ofFrame_;  ///< of frames that takeUpTo() has not handed out
  bool byQuery_;
  std::deque<Pending> pending_;
};

}  // namespace simreel::frame
