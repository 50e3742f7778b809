#include "frame/sink/frame_queue.hpp"

#include "base/log.hpp"
#include "frame/sink/frame_sink.hpp"

#include <ctime>
#include <new>
#include <system_error>
#include <utility>

namespace simreel::frame {

double threadSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

FrameQueue::FrameQueue(std::size_t threads, std::size_t max, Handler handler)
    : max_(max), handler_(std::move(handler)) {
  threads_.reserve(threads);
  try {
    while (threads_.size() < threads) threads_.emplace_back([this] { work(); });
  } catch (const std::system_error& error) {
    detail("{} of {} threads for encoding: {}", threads_.size(), threads, error.what());
  } catch (const std::bad_alloc&) {  // Joins the threads first, because destroying an unjoined thread would
                                     // terminate the program.
    abandon();
    throw;
  }
}

FrameQueue::~FrameQueue() {
  abandon();
}

void FrameQueue::push(FrameInfo info, std::optional<Image> image) {
  if (threads_.empty()) {
    rethrow();
    handle({std::move(info), std::move(image)});
    return rethrow();
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return error_ || waiting_.size() < max_; });
  if (error_) std::rethrow_exception(error_);
  waiting_.push_back({std::move(info), std::move(image)});
  changed_.notify_all();
}

void FrameQueue::settle() {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.empty() && atWork_ == 0; });
  }
  rethrow();
}

void FrameQueue::close() {
  join();
  rethrow();
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

void FrameQueue::join() noexcept {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }
  for (std::thread& thread : threads_)
    if (thread.joinable()) thread.join();
}

void FrameQueue::rethrow() {
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(error_);
}

void FrameQueue::handle(const Item& item) noexcept {
  const double begin = threadSeconds();
  std::exception_ptr error;
  try {
    handler_(item.info, item.image);
  } catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  seconds_ += threadSeconds() - begin;
  if (!error || error_) return;
  error_ = error;
  waiting_.clear();
}

void FrameQueue::work() noexcept {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    {
      const Item item = std::move(waiting_.front());
      waiting_.pop_front();
      ++atWork_;
      changed_.notify_all();
      lock.unlock();
      handle(item);
    }
    lock.lock();
    --atWork_;
    changed_.notify_all();
  }
}

}  // namespace simreel::frame
