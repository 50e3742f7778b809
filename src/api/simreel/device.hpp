#pragma once
#include <functional>
#include <memory>
#include <simreel/error.hpp>
#include <simreel/values.hpp>
#include <string>
#include <vector>

namespace simreel {

/// Choice of the device.
struct DeviceOptions {
  std::string device = {};  ///< index of the device, or part of its name; if empty, a GPU if there is one,
                            ///< and otherwise Mesa's software driver
  std::string memoryPath = {};  ///< "storage" or "texel"; if empty, the faster one for the device
  bool printsMessages = false;  ///< true to print messages on standard error as they come, as the command
                                ///< line does; takeMessages() then returns none
  bool debug = false;           ///< true to ask the driver for debug messages; serious ones are errors
  bool operator==(const DeviceOptions&) const = default;
};

/// The device of the process, and the thread that works on it.
/// All functions of the library may be called from any thread. One call runs at a time, and other calls
/// wait. The device stays open while a Device or a Scene on the device exists. A forked process cannot use
/// the device of its parent, and every call in it throws Error(process). Open the device after the fork.
class SIMREEL_API Device {
 public:
  /// Opens the device, or returns the open one. Throws Error(usage) if a device is open with other options,
  /// and Error(device) if there is no device. The first call sets $LP_NUM_THREADS unless it is already set,
  /// so make this call before other threads read the environment.
  static Device open(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&);
  Device(Device&&) noexcept;
  Device& operator=(const Device&);
  Device& operator=(Device&&) noexcept;

  [[nodiscard]] std::string name() const;    ///< name of the device (GL_RENDERER)
  [[nodiscard]] std::string driver() const;  ///< version of the driver (GL_VERSION)
  [[nodiscard]] bool isSoftware() const;     ///< true if the CPU draws
  /// Returns why state arrays reach other libraries only through CPU memory (Scene::readOnDevice); empty if
  /// they stay on the card.
  [[nodiscard]] std::string whyThroughHost() const;
  /// Ends the running call at its next frame with Error(interrupted). The scene can be used further.
  void interrupt();
  /// Sets a function that is called about ten times a second while a call waits, on the thread of that
  /// call. If the function returns true, the call ends as if interrupt() had been called. An empty function
  /// removes the hook.
  void whileWaiting(std::function<bool()> hook);
  /// Returns the messages since the last call of this function, oldest first.
  [[nodiscard]] std::vector<Message> takeMessages();

  struct State;
  [[nodiscard]] const std::shared_ptr<State>& state() const;

 private:
  explicit Device(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

/// Sets the environment variables of the driver, as the first Device::open() does. Call this function at
/// the program's start if the program starts threads before it opens a device.
SIMREEL_API void prepareEnvironment();

/// Returns the version of the library: "major.minor.patch".
[[nodiscard]] SIMREEL_API const char* libraryVersion();

/// Returns the JSON schema of scenes.
[[nodiscard]] SIMREEL_API std::string sceneSchema();

}  // namespace simreel
