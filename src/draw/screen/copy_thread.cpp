#include "draw/screen/copy_thread.hpp"

#include <system_error>
#include <utility>

namespace simreel::draw {

CopyThread::~CopyThread() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool CopyThread::start(Task& task) {
  if (!thread_.joinable()) try {
      thread_ = std::thread([this] { work(); });
    } catch (const std::system_error&) {
      return false;
    }
  task.done = false;
  task.error = nullptr;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(&task);
  }
  changed_.notify_all();
  return true;
}

std::vector<std::uint8_t> CopyThread::wait(Task& task) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return task.done; });
  if (task.error) std::rethrow_exception(task.error);
  return std::move(task.copy);
}

void CopyThread::work() noexcept {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    if (closed_) return;
    Task& task = *waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    try {
      task.copy.assign(task.from, task.from + task.count);
    } catch (...) {
      task.error = std::current_exception();
    }
    lock.lock();
    task.done = true;
    changed_.notify_all();
  }
}

}  // namespace simreel::draw
