#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace simreel::gl {

/// How shaders read hot inputs. Software drivers load texels 10 to 30 times faster than storage
/// blocks; GPUs prefer storage blocks and shared memory (DESIGN.md).
enum class MemoryPath { storage, texel };

/// One EGL device as the system lists it.
struct DeviceInfo {
  int index = 0;
  std::string name;  ///< GL_RENDERER when a context could be made, else what EGL says
  std::string vendor;
  std::string version;  ///< GL_VERSION
  bool software = false;
  std::string problem;  ///< empty when the device can run the program
};

/// Every EGL device, each tried by making a context on it. Empty when EGL finds none.
[[nodiscard]] std::vector<DeviceInfo> listDevices();

struct ContextOptions {
  std::string device;  ///< index or part of a name, case ignored; empty: hardware before software
  bool debug = false;  ///< debug context: high-severity messages become UserError(device) at the next check
  std::string memoryPath;  ///< "storage", "texel" or empty: by driver

  /// Of several processes beside each other, `place` of which is counted from 0: each takes the next device
  /// of a list, "0,1". A comma before a blank is part of a name.
  [[nodiscard]] ContextOptions ofWorker(std::size_t place) const;
  /// How many devices `device` lists, at least 1.
  [[nodiscard]] std::size_t deviceCount() const;
};

/// An OpenGL 4.5 core context without a surface, current on the thread that made it. Throws
/// UserError(device) saying what was looked for, what was found and what to install.
class Context {
 public:
  explicit Context(const ContextOptions& options = {});
  ~Context();
  Context(Context&&) = delete;
  Context(const Context&) = delete;
  Context& operator=(Context&&) = delete;
  Context& operator=(const Context&) = delete;

  [[nodiscard]] const DeviceInfo& device() const;
  [[nodiscard]] const std::string& reason() const;  ///< why this device was chosen, one clause
  /// Throws UserError(device) with the first high-severity debug message since the last call, if any.
  void check() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A further context beside the current Context, on its device and current on the thread that makes it. It
/// shares no objects with the other one. End it before that.
class SideContext {
 public:
  /// Null where the driver offers none, or there is no Context.
  static std::unique_ptr<SideContext> make();
  ~SideContext();
  SideContext(SideContext&&) = delete;
  SideContext(const SideContext&) = delete;
  SideContext& operator=(SideContext&&) = delete;
  SideContext& operator=(const SideContext&) = delete;

 private:
  SideContext(void* display, void* context) : display_(display), context_(context) {}
  void* display_;  ///< EGLDisplay
  void* context_;  ///< EGLContext
};

/// Of the current context.
[[nodiscard]] MemoryPath memoryPath();
/// Whether the current context draws on the CPU, where some filters cost more than they show.
[[nodiscard]] bool softwareDriver();

}  // namespace simreel::gl
