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
  std::string
      device;  ///< index, or part of a name; empty: a GPU if there is one, else Mesa's software driver
  std::string memoryPath;  ///< "storage", "texel" or empty: the faster one
};

/// The device of the process, and the thread that works on it.
///
/// Threads: all functions of the library may be called from any thread. One call runs at a time; others
/// wait. Lifetime: the device stays open while a Device or a Scene of it exists. Processes: a fork cannot
/// use the device of its parent; every call in it throws Error(process). Open the device after the fork.
class SIMREEL_API Device {
 public:
  /// Opens the device, or returns the open one. Throws Error(usage) if one is open with other options,
  /// Error(device) if none exists. The first call sets $LP_NUM_THREADS unless it is set, so call it
  /// before other threads read the environment.
  static Device open(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&);
  Device(Device&&) noexcept;
  Device& operator=(const Device&);
  Device& operator=(Device&&) noexcept;

  [[nodiscard]] std::string name() const;    ///< GL_RENDERER
  [[nodiscard]] std::string driver() const;  ///< GL_VERSION
  [[nodiscard]] bool isSoftware() const;     ///< true if the CPU draws
  /// Returns why state arrays reach other libraries only through CPU memory (Scene::readOnDevice); empty if
  /// they stay on the card.
  [[nodiscard]] std::string whyThroughHost() const;
  /// Ends the running call at its next frame with Error(interrupted). The scene can be used further.
  void interrupt();
  /// Sets a function that a waiting call runs about ten times a second on its own thread; if it returns
  /// true, the call ends as by interrupt(). Empty: none.
  void whileWaiting(std::function<bool()> hook);
  /// Returns the messages since the last call, the oldest first.
  [[nodiscard]] std::vector<Message> takeMessages();

  struct State;
  [[nodiscard]] const std::shared_ptr<State>& state() const;

 private:
  explicit Device(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

/// Sets the environment variables of the driver, as the first Device does. Call it at the program's start
/// if the program starts threads before it opens a device.
SIMREEL_API void prepareEnvironment();

/// Returns the version of the library: "major.minor.patch".
[[nodiscard]] SIMREEL_API const char* libraryVersion();

/// Returns the JSON schema of scenes.
[[nodiscard]] SIMREEL_API std::string sceneSchema();

}  // namespace simreel
