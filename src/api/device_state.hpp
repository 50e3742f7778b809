#pragma once
#include "api/cuda.hpp"
#include "api/simreel/device.hpp"
#include "api/worker.hpp"
#include "gl/context.hpp"
#include "sim/core/numerics.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <sys/types.h>
#include <type_traits>
#include <vector>

namespace simreel {

/// State of the open device: the OpenGL context, and the thread on which the context is current.
struct Device::State {
  explicit State(const DeviceOptions& wanted);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// Runs `work` on the device's thread and returns its result. Throws Error.
  template <class Work>
  auto run(const Work& work) {
    if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
      runTask(work);
    } else {
      std::optional<std::invoke_result_t<Work>> result;
      runTask([&] { result.emplace(work()); });
      return std::move(*result);
    }
  }
  /// Runs `work`, which must not fail and cannot be interrupted, such as releasing memory. Does not wait
  /// for `work` if a call of the same thread is running, for example in a hook. Does nothing in a forked
  /// process.
  void release(const std::function<void()>& work) noexcept;
  [[nodiscard]] bool isForked() const;

  DeviceOptions options;
  pid_t process;
  /// Returns the CUDA driver on the context's card. Runs on the device's thread.
  [[nodiscard]] api::Cuda& openCuda();

  std::unique_ptr<gl::Context> context;
  std::shared_ptr<api::Cuda> cuda;  ///< null until openCuda()
  sim::Numerics numerics;
  std::mutex mutex;  ///< guards `hook` and `messages`
  std::function<bool()> hook;
  std::vector<Message> messages;
  std::unique_ptr<api::Worker> worker;

 private:
  void runTask(const std::function<void()>& task);
};

}  // namespace simreel
