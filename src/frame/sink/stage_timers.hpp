#pragma once
#include "base/clock.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"

#include <deque>

namespace simreel::frame {

/// Adds the time of its own life to a stage.
class Stopwatch {
 public:
  explicit Stopwatch(double& stage) : stage_(stage), begin_(Clock::now()) {}
  ~Stopwatch() { stage_ += secondsSince(begin_); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& stage_;
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

  template <class Work>
  void run(double StageTimes::*stage, int frame, const Work& work) {
    if (!byQuery_) {
      const Stopwatch time = watch(stage);
      return work();
    }
    pending_.push_back({{}, frame, stage});
    pending_.back().query.begin();
    work();
    pending_.back().query.end();
  }
  /// Waiting for the device counts for a software driver only: elsewhere the queries have it.
  template <class Work>
  void wait(double StageTimes::*stage, const Work& work) {
    if (byQuery_) return work();
    const Stopwatch time = watch(stage);
    work();
  }
  /// Adds the results of everything up to a frame that the device has finished.
  void collect(int frame) {
    for (; !pending_.empty() && pending_.front().frame <= frame; pending_.pop_front())
      stages_.*pending_.front().stage += pending_.front().query.nanoseconds() * 1e-9;
  }

 private:
  struct Pending {
    gl::TimerQuery query;
    int frame;
    double StageTimes::*stage;
  };
  StageTimes stages_;
  bool byQuery_;
  std::deque<Pending> pending_;
};

}  // namespace simreel::frame
