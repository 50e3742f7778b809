#pragma once
#include "frame/frame_sink.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace simreel::frame {

/// One thread that handles frames in order, behind a bounded queue, so that drawing goes on while
/// a pipe is slow.
class FrameQueue {
 public:
  using Handler = std::function<void(const FrameInfo&, const Image&)>;

  FrameQueue(std::size_t most, Handler handler);
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// Blocks while the queue is full. Throws what the handler threw.
  void push(FrameInfo info, Image image);
  /// Waits until all is handled and ends the thread. Throws what the handler threw.
  void close();
  /// Drops what is waiting and ends the thread; the handler in progress must return by itself.
  void abandon() noexcept;
  [[nodiscard]] double seconds() const;  ///< processor time of the handler so far

 private:
  struct Item {
    FrameInfo info;
    Image image;
  };
  void work();
  void join();

  std::size_t most_;
  Handler handler_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> waiting_;
  std::exception_ptr error_;
  double seconds_ = 0;
  bool closed_ = false;
  std::thread thread_;
};

}  // namespace simreel::frame
