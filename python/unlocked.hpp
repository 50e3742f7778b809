#pragma once
#include <atomic>
#include <pybind11/pybind11.h>
#include <unistd.h>

namespace simreel::python {

/// Number of threads inside the library. It is reset to zero in a forked process.
inline std::atomic<int> inside = 0;
/// True since the interpreter began to end. From then on, daemon threads must not enter or leave the
/// library.
inline std::atomic<bool> ending = false;
inline thread_local bool endsPython = false;

/// Stops a daemon thread at the end of the interpreter, as Python 3.14 does. Ending the thread would unwind
/// through destructors that must not throw.
[[noreturn]] inline void stopThread() {
  for (;;) ::pause();
}

/// Releases the interpreter's lock in the constructor, and takes it again in the destructor.
class Unlocked {
 public:
  Unlocked() : thread_(PyEval_SaveThread()) {
    ++inside;
    if (!ending || endsPython) return;
    --inside;
    stopThread();
  }
  ~Unlocked() {
    if (ending && !endsPython) {
      --inside;
      stopThread();
    }
    PyEval_RestoreThread(thread_);
    --inside;  // this is last, because the ending interpreter waits until no thread is inside
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* thread_;
};

/// Runs work without the interpreter's lock.
template <class Work>
auto unlocked(const Work& work) {
  const Unlocked release;
  return work();
}

}  // namespace simreel::python
