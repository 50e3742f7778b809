#include "api/simreel/device.hpp"

#include "api/device_state.hpp"
#include "api/failure.hpp"
#include "base/log.hpp"
#include "base/message_taker.hpp"
#include "base/version.hpp"
#include "frame/interrupt.hpp"
#include "gl/driver_threads.hpp"
#include "scene/texts/schema_text.hpp"
#include "sim/world/list.hpp"

#include <csignal>
#include <optional>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace simreel {

namespace {

std::mutex openMutex;
std::weak_ptr<Device::State> opened;
/// Process that opened the device. It stays set after the device is closed. 0 if no process has opened a
/// device.
pid_t openedBy = 0;

/// True while a call of this thread is running, and always on the device's thread. The hook of such a call
/// must not call the library.
thread_local bool isCalling = false;

constexpr std::size_t maxMessages = 1000;

[[noreturn]] void refuseFork() {
  api::fail(
      ErrorKind::process,
      "this process is a fork of one that uses simreel, and a device does not survive a fork; start "
      "new processes (Python: multiprocessing.get_context(\"spawn\")), or open the device after the fork");
}

}  // namespace

Device::State::State(const DeviceOptions& wanted)
    : options(wanted), process(::getpid()), worker(std::make_unique<api::Worker>()) {
  if (!options.printsMessages)
    setMessageTaker([this](const char* level, const std::string& text) {
      const std::scoped_lock lock(mutex);
      if (messages.size() < maxMessages) messages.push_back({level, text});
    });
  try {
    run([this] {
      gl::ContextOptions how;
      how.device = options.device;
      how.memoryPath = options.memoryPath;
      how.debug = options.debug;
      context = std::make_unique<gl::Context>(how);
      numerics = sim::probeNumerics();
    });
  } catch (...) {
    release([this] { context.reset(); });
    setMessageTaker({});
    throw;
  }
}

Device::State::~State() {
  if (isForked()) {  // In a forked process, neither the worker thread nor the driver's threads exist.
    static_cast<void>(worker.release());
    static_cast<void>(context.release());
    static_cast<void>(new std::shared_ptr<api::Cuda>(std::move(cuda)));  // never released
    return;
  }
  release([this] {
    if (cuda) cuda->close();
    cuda.reset();
    context.reset();
  });
  worker.reset();
  setMessageTaker({});
}

api::Cuda& Device::State::openCuda() {
  if (!cuda) cuda = std::make_shared<api::Cuda>();
  return *cuda;
}

bool Device::State::isForked() const {
  return ::getpid() != process;
}

void Device::State::runTask(const std::function<void()>& task) {
  if (isForked()) refuseFork();
  if (isCalling)
    api::fail(
        ErrorKind::usage,
        "a call of simreel is running in this thread; a signal handler or a callback cannot make another");
  std::function<bool()> interruptRequested;
  {
    const std::scoped_lock lock(mutex);
    interruptRequested = hook;
  }
  std::atomic<bool> begun = false, ended = false;
  const auto ask = [&] {
    if (ended || !interruptRequested()) return;
    ended = true;
    if (begun)
      frame::setInterrupt(SIGINT);  // If the task has not begun, the running call belongs to
                                    // another thread and must not be interrupted.
  };
  std::exception_ptr failure;
  const auto work = [&] {
    isCalling = true;        // A callback on the device's thread must not call the library either.
    frame::setInterrupt(0);  // Removes an interrupt that was meant for an earlier call.
    begun = true;
    if (!ended) task();
  };
  isCalling = true;
  try {
    worker->run(work, interruptRequested ? std::function<void()>(ask) : std::function<void()>());
  } catch (...) {
    failure = std::current_exception();
  }
  isCalling = false;
  if (failure) api::rethrowAsError(failure);
  if (ended) api::fail(ErrorKind::interrupted, "interrupted");
}

void Device::State::release(const std::function<void()>& work) noexcept {
  if (isForked()) return;
  try {
    if (isCalling)
      worker->later(work);
    else
      worker->run(work, {});
  } catch (...) {  // NOLINT(bugprone-empty-catch): nothing can be done about memory that is not released
  }
}

Device::Device(std::shared_ptr<State> state) : state_(std::move(state)) {}
Device::~Device() = default;
Device::Device(const Device&) = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(const Device&) = default;
Device& Device::operator=(Device&&) noexcept = default;

Device Device::open(const DeviceOptions& options) {
  const std::scoped_lock lock(openMutex);
  if (openedBy != 0 && openedBy != ::getpid()) refuseFork();
  if (std::shared_ptr<State> present = opened.lock()) {
    if (present->options != options)
      api::fail(ErrorKind::usage,
                fmt::format(
                    "device \"{}\" ({}) is open, and a process has one device; close its scenes first, or "
                    "open it with the same options",
                    present->options.device, present->context->device().name));
    return Device(std::move(present));
  }
  auto made = std::make_shared<State>(options);
  opened = made;
  openedBy = ::getpid();
  return Device(std::move(made));
}

std::string Device::name() const {
  return state_->context->device().name;
}
std::string Device::driver() const {
  return state_->context->device().version;
}
bool Device::isSoftware() const {
  return state_->context->device().software;
}
std::string Device::whyThroughHost() const {
  return state_->run([this] { return state_->openCuda().problem(); });
}
void Device::interrupt() {
  frame::setInterrupt(SIGINT);
}
void Device::whileWaiting(std::function<bool()> hook) {
  const std::scoped_lock lock(state_->mutex);
  state_->hook = std::move(hook);
}
std::vector<Message> Device::takeMessages() {
  const std::scoped_lock lock(state_->mutex);
  return std::exchange(state_->messages, {});
}
const std::shared_ptr<Device::State>& Device::state() const {
  return state_;
}

void prepareEnvironment() {
  gl::chooseDriverThreads();
}

const char* libraryVersion() {
  return version();
}

std::string sceneSchema() {
  return scene::schemaText(sim::kinds().list);
}

}  // namespace simreel
