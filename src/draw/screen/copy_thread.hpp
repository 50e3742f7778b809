#pragma once
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace simreel::draw {

/// Copies bytes on a thread of its own, one task after the other.
class CopyThread {
 public:
  struct Task {
    const std::uint8_t* from = nullptr;
    std::size_t count = 0;
    std::vector<std::uint8_t> copy;
    std::exception_ptr error;
    bool done = false;
  };
  CopyThread() = default;
  ~CopyThread();
  CopyThread(CopyThread&&) = delete;
  CopyThread& operator=(CopyThread&&) = delete;
  CopyThread(const CopyThread&) = delete;
  CopyThread& operator=(const CopyThread&) = delete;

  /// False where the system grants no thread. The task stays where it is until it is waited for.
  [[nodiscard]] bool start(Task& task);
  /// The task's bytes, when they are there. Throws what went wrong.
  [[nodiscard]] std::vector<std::uint8_t> wait(Task& task);

 private:
  void work() noexcept;

  std::mutex mutex_;  ///< guards all below, and what tasks say of their end
  std::condition_variable changed_;
  std::deque<Task*> waiting_;
  bool closed_ = false;
  std::thread thread_;
};

}  // namespace simreel::draw
