#include "frame/frame_queue.hpp"

#include "frame/sinks.hpp"

#include <ctime>
#include <utility>

namespace simreel::frame {

double threadSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

FrameQueue::FrameQueue(std::size_t most, Handler handler)
    : most_(most), handler_(std::move(handler)), thread_([this] { work(); }) {}

FrameQueue::~FrameQueue() {
  abandon();
}

void FrameQueue::push(FrameInfo info, Image image) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return error_ || waiting_.size() < most_; });
  if (error_) std::rethrow_exception(error_);
  waiting_.push_back({std::move(info), std::move(image)});
  changed_.notify_all();
}

void FrameQueue::close() {
  join();
  if (error_) std::rethrow_exception(error_);
}

void FrameQueue::abandon() noexcept {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
  }
  join();
}

double FrameQueue::seconds() const {
  const std::lock_guard lock(mutex_);
  return seconds_;
}

void FrameQueue::join() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void FrameQueue::work() {
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Item item = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    lock.unlock();
    std::exception_ptr error;
    try {
      handler_(item.info, item.image);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    seconds_ = threadSeconds();
    if (!error) continue;
    error_ = error;
    waiting_.clear();
    changed_.notify_all();
    return;
  }
}

}  // namespace simreel::frame
