#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace simreel::api {

/// Thread that holds the OpenGL context. It runs one task at a time. If the system allows no further
/// thread, tasks run on the thread that created this object, and others are refused.
class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Runs a task on the thread and waits for it. Meanwhile runs `hook` on the calling thread about ten
  /// times a second. Rethrows the task's exception.
  void run(const std::function<void()>& task, const std::function<void()>& hook);
  /// Runs a task, which must not throw, on the thread after the current task. Does not wait for it.
  void later(std::function<void()> task);

 private:
  void loop();
  void runLater(std::unique_lock<std::mutex>& lock);
  void runHere(const std::function<void()>& task);

  std::timed_mutex turn_;  ///< locked by the caller whose task is running
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* task_ = nullptr;
  std::vector<std::function<void()>> later_;
  std::exception_ptr failure_;
  bool ends_ = false;
  std::thread::id creator_ = std::this_thread::get_id();
  std::thread thread_;  ///< not joinable if the system allows no further thread
};

}  // namespace simreel::api
