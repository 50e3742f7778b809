#include "api/worker.hpp"

#include "api/failure.hpp"

#include <chrono>
#include <system_error>
#include <utility>

namespace simreel::api {

Worker::Worker() {
  try {
    thread_ = std::thread([this] { loop(); });
  } catch (const std::system_error&) {  // NOLINT(bugprone-empty-catch): run() works without the thread.
  }
}

Worker::~Worker() {
  if (!thread_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Worker::runHere(const std::function<void()>& task) {
  if (std::this_thread::get_id() != creator_)
    fail(
        ErrorKind::process,
        "the system allows no further thread for the device, so only the thread that opened it can use it");
  std::exception_ptr failure;
  try {
    task();
  } catch (...) {
    failure = std::current_exception();
  }
  std::unique_lock lock(mutex_);
  runLater(lock);
  if (failure) std::rethrow_exception(failure);
}

void Worker::run(const std::function<void()>& task, const std::function<void()>& hook) {
  if (!thread_.joinable()) return runHere(task);
  constexpr std::chrono::milliseconds pause(100);
  std::unique_lock mine(turn_, std::defer_lock);
  while (!mine.try_lock_for(pause))
    if (hook) hook();
  std::unique_lock lock(mutex_);
  task_ = &task;
  changed_.notify_all();
  const auto done = [this] { return task_ == nullptr; };
  while (!changed_.wait_for(lock, pause, done)) {
    if (!hook) continue;
    lock.unlock();
    hook();
    lock.lock();
  }
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Worker::later(std::function<void()> task) {
  const std::scoped_lock lock(mutex_);
  later_.push_back(std::move(task));
  changed_.notify_all();
}

void Worker::runLater(std::unique_lock<std::mutex>& lock) {
  while (!later_.empty()) {
    std::vector<std::function<void()>> tasks = std::exchange(later_, {});
    lock.unlock();
    for (const std::function<void()>& task : tasks) task();
    tasks.clear();
    lock.lock();
  }
}

void Worker::loop() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return task_ != nullptr || ends_ || !later_.empty(); });
    runLater(lock);
    if (ends_) return;
    if (task_ == nullptr) continue;
    lock.unlock();
    std::exception_ptr failure;
    try {
      (*task_)();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    failure_ = failure;
    task_ = nullptr;
    changed_.notify_all();
  }
}

}  // namespace simreel::api
