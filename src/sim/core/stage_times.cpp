#include "sim/core/stage_times.hpp"

#include "base/error.hpp"

namespace simreel::sim {

StageClock::StageClock(Of what) : what_(what) {
  if (what_ != Of::gpu) return;
  for (Frame& frame : frames_)
    for (auto& stamp : frame.stamps) {
      GLuint name = 0;
      glCreateQueries(GL_TIMESTAMP, 1, &name);
      stamp = gl::Handle<gl::DeleteQuery>(name);
    }
}

void StageClock::begin() {
  present_ = {};
  last_ = std::chrono::steady_clock::now();
  if (what_ != Of::gpu) return;
  collect();
  current_ = (current_ + 1) % frames_.size();
  Frame& frame = frames_[current_];
  measuring_ = !frame.pending;  // This frame is not measured if the GPU has not finished the earlier frame
                                // that uses the same slot.
  frame.laps = measuring_ ? 0 : frame.laps;
  if (measuring_) glQueryCounter(frame.stamps[0].get(), GL_TIMESTAMP);
}

void StageClock::lap(double StageTimes::*stage) {
  if (what_ == Of::cpu) {
    const auto now = std::chrono::steady_clock::now();
    present_.*stage += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }
  if (what_ != Of::gpu || !measuring_) return;
  Frame& frame = frames_[current_];
  SIMREEL_CHECK(frame.laps < maxLaps);
  frame.stages[static_cast<std::size_t>(frame.laps)] = stage;
  ++frame.laps;
  glQueryCounter(frame.stamps[static_cast<std::size_t>(frame.laps)].get(), GL_TIMESTAMP);
}

void StageClock::end() {
  if (what_ == Of::cpu) {
    newest_ = present_;
    known_ = true;
  }
  if (what_ == Of::gpu && measuring_) frames_[current_].pending = true;
}

void StageClock::collect() {
  for (std::size_t i = 1; i <= frames_.size(); ++i) {  // Visits the frames from the oldest to the newest.
    Frame& frame = frames_[(current_ + i) % frames_.size()];
    if (!frame.pending) continue;
    GLint done = GL_FALSE;
    const auto stamp = [&](int lap) { return frame.stamps[static_cast<std::size_t>(lap)].get(); };
    glGetQueryObjectiv(stamp(frame.laps), GL_QUERY_RESULT_AVAILABLE, &done);
    if (done != GL_TRUE) return;
    StageTimes times;
    for (int lap = 0; lap < frame.laps; ++lap) {
      GLuint64 from = 0;
      GLuint64 to = 0;
      glGetQueryObjectui64v(stamp(lap), GL_QUERY_RESULT, &from);
      glGetQueryObjectui64v(stamp(lap + 1), GL_QUERY_RESULT, &to);
      times.*frame.stages[static_cast<std::size_t>(lap)] += static_cast<double>(to - from) * 1e-6;
    }
    newest_ = times;
    known_ = true;
    frame.pending = false;
  }
}

std::vector<std::pair<const char*, double>> StageClock::times() const {
  if (!known_) return {};
  return {{"deform", newest_.deform}, {"normals", newest_.normals}, {"transfer", newest_.transfer}};
}

}  // namespace simreel::sim
