#pragma once
#include "frame/sink/frame_sink.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace simreel::frame {

/// Worker threads with a bounded queue that handle frames while drawing continues. With one thread, frames
/// are handled in order. If no thread can be created, push() handles the frame.
class FrameQueue {
 public:
  /// Callback that handles one frame. The image is empty if only the additional files must be stored.
  using Handler = std::function<void(const FrameInfo&, const std::optional<Image>&)>;

  /// Queue length for a single in-order thread, enough to compensate for frames that take longer than
  /// others.
  static constexpr std::size_t maxWaitingInOrder = 4;

  /// Creates up to `threads` threads. At most `max` frames wait in the queue, in addition to the frames
  /// being handled.
  FrameQueue(std::size_t threads, std::size_t max, Handler handler);
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;
  FrameQueue(FrameQueue&&) = delete;
  FrameQueue& operator=(FrameQueue&&) = delete;

  /// Adds a frame. Blocks while the queue is full. Rethrows an exception of the handler.
  void push(FrameInfo info, std::optional<Image> image);
  /// Waits until all frames are handled. Rethrows an exception of the handler.
  void settle();
  /// Waits until all frames are handled, and ends the threads. Rethrows an exception of the handler.
  void close();
  /// Drops waiting frames and ends the threads. Waits for handlers in progress.
  void abandon() noexcept;
  [[nodiscard]] double seconds() const;  ///< Returns the CPU time (s) of the handler so far, summed over
                                         ///< all threads.

 private:
  struct Item {
    FrameInfo info;
    std::optional<Image> image;
  };
  void work() noexcept;
  void handle(const Item& item) noexcept;  ///< Calls the handler. If the handler throws, stores the
                                           ///< exception in error_.
  void join() noexcept;
  void rethrow();

  std::size_t max_;
  Handler handler_;
  mutable std::mutex mutex_;  ///< guards all members declared below
  std::condition_variable changed_;
  std::deque<Item> waiting_;
  std::size_t atWork_ = 0;
  std::exception_ptr error_;  ///< first exception; once set, waiting frames are dropped
  double seconds_ = 0;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

/// Returns the CPU time (s) of the calling thread.
[[nodiscard]] double threadSeconds();

}  // namespace simreel::frame
