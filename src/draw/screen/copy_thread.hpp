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

/// Copies bytes on a separate thread, one task after another.
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

  /// Starts a task. Returns false if the system cannot create a thread. The task must keep its address
  /// until wait() returns.
  [[nodiscard]] bool start(Task& task);
  /// Waits for the task and returns the copied bytes. Rethrows an error of the copy.
  [[nodiscard]] std::vector<std::uint8_t> wait(Task& task);

 private:
  void work() noexcept;

  std::mutex mutex_;  ///< guards all members below and the completion flags of tasks
  std::condition_variable changed_;
  std::deque<Task*> waiting_;
  bool closed_ = false;
  std::thread thread_;
};

}  // namespace simreel::draw
