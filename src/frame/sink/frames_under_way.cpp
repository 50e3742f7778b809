#include "frame/sink/frames_under_way.hpp"

#include "base/error.hpp"
#include "frame/draw_world.hpp"
#include "frame/image.hpp"

#include <utility>

namespace simreel::frame {

FramePipeline::FramePipeline(const scene::Scene& scene, FrameSink& sink, const FieldFiles* fields,
                             RunListener& progress, StageTimers& timers, std::function<void()> awaitSummary)
    : sink_(sink),
      fields_(fields),
      progress_(progress),
      timers_(timers),
      awaitSummary_(std::move(awaitSummary)),
      size_(scene.render.size),
      alpha_(scene.render.transparent),
      renderer_(scene, scene.render.size, scene.render.samples),
      readback_(scene.render.size) {}

void FramePipeline::follow(sim::World& world) {
  followMotion(renderer_, world);
}

void FramePipeline::keepLayers(const draw::LightRequest& wanted) {
  renderer_.keepLayers(wanted);
  keepsLayers_ = true;
}

bool FramePipeline::misses(int frame) const {
  return sink_.wants(frame) || (fields_ != nullptr && fields_->misses(frame, sink_));
}

void FramePipeline::draw(sim::World& world, std::optional<std::string> stateHash) {
  const int frame = world.frame();
  const bool wanted = sink_.wants(frame);
  if (wanted) {
    timers_.run(&StageTimes::draw, frame, [&] { drawWorld(renderer_, world); });
    readback_.start(renderer_.target(), frame);
  }
  waiting_.push_back({frame, wanted, {}, nullptr, std::move(stateHash)});
  if (wanted && keepsLayers_)
    waiting_.back().layers = std::make_shared<const draw::PictureLayers>(renderer_.takeLayers());
  if (fields_ != nullptr) {
    const Stopwatch time = timers_.watch(&StageTimes::readBack, frame);
    waiting_.back().files = fields_->read(frame, world.drawables().fields, sink_);
  }
  // Keeps one readback slot free for the next picture.
  while (waiting_.size() >= draw::Readback::maxUnderWay) deliverOldest();
}

void FramePipeline::know(int frame, const std::string& stateHash) {
  for (Waiting& waiting : waiting_)
    if (waiting.frame == frame) waiting.stateHash = stateHash;
}

void FramePipeline::pass(int frame) {
  ++delivered_;
  progress_.frame(frame, {});
}

void FramePipeline::drain() {
  while (!waiting_.empty()) deliverOldest();
}

void FramePipeline::deliverOldest() {
  timers_.wait(&StageTimes::simulate, waiting_.front().frame, [&] {
    while (!waiting_.front().stateHash) awaitSummary_();
  });
  Waiting oldest = std::move(waiting_.front());
  waiting_.pop_front();
  const int frame = oldest.frame;
  if (oldest.drawn)
    store(std::move(oldest));
  else
    compareWithStored(std::move(oldest));
  ++delivered_;
  StageTimes stages = timers_.takeUpTo(frame);
  const double encoded = sink_.encodeSeconds();
  stages.encode = encoded - reportedEncode_;
  reportedEncode_ = encoded;
  progress_.frame(frame, stages);
}

void FramePipeline::store(Waiting waiting) {
  // A software driver draws in the background, so waiting for the picture counts as drawing time.
  timers_.wait(&StageTimes::draw, waiting.frame, [&] { readback_.waitForOldest(); });
  timers_.collect(waiting.frame);
  Image image{size_.x, size_.y, {}, alpha_};
  {
    const Stopwatch time = timers_.watch(&StageTimes::readBack, waiting.frame);
    auto taken = readback_.nextPicture(true);
    SIMREEL_CHECK(taken.has_value());
    SIMREEL_CHECK_EQ(taken->first, waiting.frame);
    image.bytes = std::move(taken->second);
  }
  if (onPicture_) onPicture_(waiting.frame, image);
  const Stopwatch time = timers_.watch(&StageTimes::wait);
  sink_.add(
      {waiting.frame, *std::move(waiting.stateHash), std::move(waiting.files), std::move(waiting.layers)},
      std::move(image));
}

void FramePipeline::compareWithStored(Waiting waiting) {
  const auto known = sink_.knownStateHash(waiting.frame);
  if (known && !known->empty() && *known != *waiting.stateHash)
    fail(ExitCode::different,
         "frame {} is kept from an earlier run, but its state was {} and is {} now; draw all frames again "
         "with --overwrite",
         waiting.frame, *known, *waiting.stateHash);
  if (!waiting.files.empty())
    sink_.add({waiting.frame, *std::move(waiting.stateHash), std::move(waiting.files)}, std::nullopt);
}

}  // namespace simreel::frame
