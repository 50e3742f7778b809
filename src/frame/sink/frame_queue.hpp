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

/// Threads that handle frames behind a bounded queue, so that drawing goes on meanwhile: in order where it
/// is one thread. Where the system grants no thread at all, push() handles its frame itself.
class FrameQueue {
 public:
  /// No image: only the files beside it.
  using Handler = std::function<void(const FrameInfo&, const std::optional<Image>&)>;

  /// For a thread that takes frames in order: what evens out frames that take longer than others.
  static constexpr std::size_t maxWaitingInOrder = 4;

  /// At most `most` frames wait, besides one at work in each thread.
  FrameQueue(std::size_t threads, std::size_t max, Handler handler);
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;
  FrameQueue(FrameQueue&&) = delete;
  FrameQueue& operator=(FrameQueue&&) = delete;

  /// Blocks while the queue is full. Throws what the handler threw.
  void push(FrameInfo info, std::optional<Image> image);
  /// Waits until all is handled. Throws what the handler threw.
  void settle();
  /// Waits until all is handled and ends the threads. Throws what the handler threw.
  void close();
  /// Drops what is waiting and ends the threads; a handler in progress must return by itself.
  void abandon() noexcept;
  [[nodiscard]] double seconds() const;  ///< processor time of the handler so far, over all threads

 private:
  struct Item {
    FrameInfo info;
    std::optional<Image> image;
  };
  void work() noexcept;
  void handle(const Item& item) noexcept;  ///< keeps what is thrown
  void join() noexcept;
  void rethrow();

  std::size_t max_;
  Handler handler_;
  mutable std::mutex mutex_;  ///< guards all below
  std::condition_variable changed_;
  std::deque<Item> waiting_;
  std::size_t atWork_ = 0;
  std::exception_ptr error_;  ///< the first; what waits is dropped then
  double seconds_ = 0;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

/// Processor time of the calling thread in seconds.
[[nodiscard]] double threadSeconds();

}  // namespace simreel::frame
