#include "gl/context.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/driver_environment.hpp"
#include "gl/driver_threads.hpp"
#include "gl/errors.hpp"
#include "gl/flushed_subnormals.hpp"
#include "gl/kernel_compiler.hpp"
#include "gl/limits.hpp"
#include "gl/linked_program.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace simreel::gl {

namespace {

Limits currentLimits;
MemoryPath currentPath = MemoryPath::storage;
bool currentIsSoftware = false;

/// Display, configuration and attributes of the current context, for creating additional contexts.
struct Origin {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = EGL_NO_CONFIG_KHR;
  std::vector<EGLint> attributes;
} origin;

/// Owns the EGL display of one device and a current context on it.
class Display {
 public:
  Display(EGLDeviceEXT device, bool debug);
  ~Display() { release(); }
  Display(Display&& other) noexcept
      : display_(std::exchange(other.display_, EGL_NO_DISPLAY)),
        context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}
  Display& operator=(Display&& other) noexcept {
    if (this != &other) {
      release();
      display_ = std::exchange(other.display_, EGL_NO_DISPLAY);
      context_ = std::exchange(other.context_, EGL_NO_CONTEXT);
    }
    return *this;
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

 private:
  void release() {
    if (display_ == EGL_NO_DISPLAY) return;
    if (origin.display == display_) origin = {};
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
    display_ = EGL_NO_DISPLAY;
  }
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

bool hasExtension(const char* list, std::string_view name) {
  if (list == nullptr) return false;
  const std::string_view all = list;
  for (auto at = all.find(name); at != std::string_view::npos; at = all.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' ')) return true;
  }
  return false;
}

EGLDisplay openDisplay(EGLDeviceEXT device) {
  if (device == EGL_NO_DEVICE_EXT)
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

Display::Display(EGLDeviceEXT device, bool debug) {
  const FlushedSubnormals forThreads;
  display_ = openDisplay(device);
  if (display_ == EGL_NO_DISPLAY) fail(ExitCode::device, "EGL cannot open a display on it");
  EGLint major = 0;
  EGLint minor = 0;
  if (eglInitialize(display_, &major, &minor) == EGL_FALSE) {
    display_ = EGL_NO_DISPLAY;
    fail(ExitCode::device, "its driver does not start (EGL error {:#x})", eglGetError());
  }
  const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
  if (!hasExtension(extensions, "EGL_KHR_surfaceless_context") || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
    release();
    fail(ExitCode::device, "its driver has no surfaceless OpenGL contexts");
  }
  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!hasExtension(extensions, "EGL_KHR_no_config_context")) {
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                             EGL_NONE};
    EGLint count = 0;
    eglChooseConfig(display_, wanted, &config, 1, &count);
  }
  // Tries robust access first, because it makes a read beyond the end of a buffer return zero on every
  // driver. With notification, checkCalls() detects a reset of the device.
  enum class Robust { none, access, notified };
  for (const Robust robust : {Robust::notified, Robust::access, Robust::none}) {
    std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION,       4,
                                      EGL_CONTEXT_MINOR_VERSION,       5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    if (debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    if (robust != Robust::none)
      attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE});
    if (robust == Robust::notified)
      attributes.insert(attributes.end(),
                        {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    attributes.push_back(EGL_NONE);
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) continue;
    origin = {display_, config, attributes};
    break;
  }
  if (context_ == EGL_NO_CONTEXT ||
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
    release();
    fail(ExitCode::device, "its driver offers no OpenGL 4.5 core context");
  }
}

/// Returns the EGL devices of the system. Returns a single EGL_NO_DEVICE_EXT if the driver cannot enumerate
/// devices.
std::vector<EGLDeviceEXT> enumerate() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!hasExtension(client, "EGL_EXT_platform_device") && !hasExtension(client, "EGL_EXT_platform_base"))
    return {};
  if (!hasExtension(client, "EGL_EXT_device_enumeration") && !hasExtension(client, "EGL_EXT_device_base"))
    return {EGL_NO_DEVICE_EXT};
  EGLint count = 0;
  if (eglQueryDevicesEXT(0, nullptr, &count) == EGL_FALSE) return {};
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  eglQueryDevicesEXT(count, devices.data(), &count);
  return devices;
}

std::string glText(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

/// Fills in the strings of the current context: GL_RENDERER, GL_VENDOR and GL_VERSION.
void describe(DeviceInfo& info) {
  info.name = glText(GL_RENDERER);
  info.vendor = glText(GL_VENDOR);
  info.version = glText(GL_VERSION);
  for (const char* word : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
    if (info.name.find(word) != std::string::npos) info.software = true;
}

DeviceInfo firstLook(EGLDeviceEXT device, int index) {
  DeviceInfo info;
  info.index = index;
  if (device == EGL_NO_DEVICE_EXT) {
    info.name = "default";
    return info;
  }
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  info.software = hasExtension(extensions, "EGL_MESA_device_software");
  const char* file = hasExtension(extensions, "EGL_EXT_device_drm")
                         ? eglQueryDeviceStringEXT(device, EGL_DRM_DEVICE_FILE_EXT)
                         : nullptr;
  info.name = info.software ? "software" : (file != nullptr ? file : "device");
  return info;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Limits readLimits() {
  Limits found;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &found.storageBlockBytes);
  glGetInteger64v(GL_MAX_TEXTURE_BUFFER_SIZE, &found.texelBufferTexels);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &found.textureSize);
  glGetIntegerv(GL_MAX_SAMPLES, &found.samples);
  glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &found.groupsX);
  glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 1, &found.groupsY);
  glGetIntegerv(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &found.sharedBytes);
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &found.uniformAlignment);
  if (epoxy_has_gl_extension("GL_KHR_shader_subgroup")) {
    GLint invocations = 0;
    GLint stages = 0;
    GLint features = 0;
    glGetIntegerv(GL_SUBGROUP_SIZE_KHR, &invocations);
    glGetIntegerv(GL_SUBGROUP_SUPPORTED_STAGES_KHR, &stages);
    glGetIntegerv(GL_SUBGROUP_SUPPORTED_FEATURES_KHR, &features);
    constexpr GLint exchange =
        GL_SUBGROUP_FEATURE_SHUFFLE_RELATIVE_BIT_KHR | GL_SUBGROUP_FEATURE_VOTE_BIT_KHR;
    found.shuffle32 =
        invocations == 32 && (stages & GL_COMPUTE_SHADER_BIT) != 0 && (features & exchange) == exchange;
    found.ballot =
        (stages & GL_COMPUTE_SHADER_BIT) != 0 && (features & GL_SUBGROUP_FEATURE_BALLOT_BIT_KHR) != 0;
  }
  found.atomics64 = epoxy_has_gl_extension("GL_ARB_gpu_shader_int64") &&
                    epoxy_has_gl_extension("GL_NV_shader_atomic_int64");
  if (epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic") ||
      epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &found.anisotropy);
  return found;
}

}  // namespace

const Limits& limits() {
  return currentLimits;
}

MemoryPath memoryPath() {
  return currentPath;
}

bool softwareDriver() {
  return currentIsSoftware;
}

namespace {

std::vector<std::string> deviceList(const std::string& text) {
  std::vector<std::string> devices(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',' && i + 1 < text.size() && text[i + 1] != ' ')
      devices.emplace_back();
    else
      devices.back() += text[i];
  }
  return devices;
}

}  // namespace

ContextOptions ContextOptions::ofWorker(std::size_t place) const {
  ContextOptions one = *this;
  const auto devices = deviceList(device);
  one.device = devices[place % devices.size()];
  return one;
}

std::size_t ContextOptions::deviceCount() const {
  return deviceList(device).size();
}

std::vector<DeviceInfo> listDevices() {
  std::vector<DeviceInfo> result;
  for (const EGLDeviceEXT device : enumerate()) {
    DeviceInfo info = firstLook(device, static_cast<int>(result.size()));
    try {
      const Display display(device, false);
      describe(info);
    } catch (const UserError& error) {
      info.problem = error.what();
    }
    result.push_back(info);
  }
  return result;
}

struct Context::State {
  /// Set if the software driver runs kernels on the calling thread.
  std::optional<FlushedSubnormals> onThisThread;
  std::optional<Display> display;
  DeviceInfo device;
  std::string reason;
  std::string message;  ///< first high-severity debug message not yet reported
  bool unreported =
      false;  ///< true if a high-severity message could not be stored, because memory was short

  static void GLAPIENTRY receive(GLenum /*source*/, GLenum /*type*/, GLuint /*id*/, GLenum severity,
                                 GLsizei length, const GLchar* text, const void* user) {
    if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM) return;
    auto* state = static_cast<State*>(const_cast<void*>(user));
    try {
      const std::string line =
          length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
      if (severity == GL_DEBUG_SEVERITY_HIGH && state->message.empty()) state->message = line;
      detail("GL: {}", line);
    } catch (...) {  // An exception must not leave this callback, because the driver holds locks while it
                     // calls it.
      state->unreported = state->unreported || severity == GL_DEBUG_SEVERITY_HIGH;
    }
  }

  /// Opens a device and stores it. On failure, adds the problem to `problems` and returns false.
  bool tryDevice(EGLDeviceEXT handle, int index, bool debug, std::string& problems) {
    device = firstLook(handle, index);
    try {
      display.emplace(handle, debug);
      describe(device);
      return true;
    } catch (const UserError& error) {
      problems += fmt::format("; device {} ({}): {}", index, device.name, error.what());
      return false;
    }
  }

  void choose(const ContextOptions& options);
};

void Context::State::choose(const ContextOptions& options) {
  chooseDriverThreads();
  const auto devices = enumerate();
  if (devices.empty()) fail(ExitCode::device, "EGL finds no device to render with; {}", driverAdvice());
  std::vector<int> order(devices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return !firstLook(devices[static_cast<std::size_t>(a)], a).software &&
           firstLook(devices[static_cast<std::size_t>(b)], b).software;
  });
  const bool byIndex = !options.device.empty() && options.device.size() < 4 &&
                       std::all_of(options.device.begin(), options.device.end(),
                                   [](unsigned char c) { return std::isdigit(c) != 0; });
  std::string problems;
  std::string seen;
  for (const int index : order) {
    if (byIndex && std::to_string(index) != options.device) continue;
    if (!tryDevice(devices[static_cast<std::size_t>(index)], index, options.debug, problems)) continue;
    seen += (seen.empty() ? "" : ", ") + fmt::format("{}: {}", index, device.name);
    if (!byIndex &&
        lower(device.name + " " + device.vendor).find(lower(options.device)) == std::string::npos) {
      display.reset();
      continue;
    }
    reason = !options.device.empty() ? fmt::format("--device {} asks for it", options.device)
             : device.software       ? "no hardware device can run the program"
                                     : "the first hardware device";
    return;
  }
  display.reset();
  if (!options.device.empty())
    fail(ExitCode::device, "no device matches --device {} (there is {}){}", options.device,
         seen.empty() ? fmt::format("{} device(s)", devices.size()) : seen, problems);
  fail(ExitCode::device, "no device can run the program{}; {}", problems, driverAdvice());
}

MemoryPath ContextOptions::memoryPathOn(bool software, std::string_view device) const {
  if (memoryPath.empty()) return software ? MemoryPath::texel : MemoryPath::storage;
  if (memoryPath == "storage") return MemoryPath::storage;
  if (memoryPath != "texel")
    fail(ExitCode::usage, "the memory path must be \"storage\" or \"texel\", not \"{}\"", memoryPath);
  if (!software)
    fail(ExitCode::device,
         "the memory path \"texel\" is for software drivers; on {} its results would be wrong, because the "
         "compiler moves texel fetches past stores; use \"storage\", the default there",
         device);
  return MemoryPath::texel;
}

Context::Context(const ContextOptions& options) : state_(std::make_unique<State>()) {
  state_->choose(options);
  currentLimits = readLimits();
  checkCalls();
  currentIsSoftware = state_->device.software;
  if (currentIsSoftware && driverThreads() == 0) state_->onThisThread.emplace();
  currentPath = options.memoryPathOn(state_->device.software, state_->device.name);
  if (options.debug) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(State::receive, state_.get());
  }
  detail("device {}: {} ({}), {}; memory path {}", state_->device.index, state_->device.name,
         state_->device.version, state_->reason, currentPath == MemoryPath::texel ? "texel" : "storage");
}

Context::~Context() {
  KernelCompiler::end();
  LinkedProgram::forgetAll();
}

std::unique_ptr<SideContext> SideContext::make() {
  if (origin.display == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return nullptr;
  EGLContext context =
      eglCreateContext(origin.display, origin.config, EGL_NO_CONTEXT, origin.attributes.data());
  if (context == EGL_NO_CONTEXT) return nullptr;
  std::unique_ptr<SideContext> made(new SideContext(origin.display, context));
  if (eglMakeCurrent(origin.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) return nullptr;
  return made;
}

SideContext::~SideContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglReleaseThread();
}

const DeviceInfo& Context::device() const {
  return state_->device;
}

const std::string& Context::reason() const {
  return state_->reason;
}

void Context::check() const {
  if (std::exchange(state_->unreported, false) && state_->message.empty())
    fail(ExitCode::device, "the driver reported an error, and there is not enough memory for its message");
  if (state_->message.empty()) return;
  const std::string message = std::exchange(state_->message, {});
  fail(ExitCode::device, "the driver reports: {}", message);
}

}  // namespace simreel::gl
