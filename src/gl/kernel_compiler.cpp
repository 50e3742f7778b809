#include "gl/kernel_compiler.hpp"

#include "base/clock.hpp"
#include "base/log.hpp"
#include "gl/context.hpp"
#include "gl/driver_threads.hpp"
#include "gl/handle.hpp"
#include "gl/linked_program.hpp"
#include "gl/program_interface.hpp"
#include "gl/shader_cache.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace simreel::gl {

namespace {

/// A kernel to compile, with a copy of its text, because the LinkedProgram belongs to the main thread.
struct Job {
  enum class State { waiting, running, done };
  const LinkedProgram* program = nullptr;
  std::string label, text;
  std::vector<BoundViews> uses;
  State state = State::waiting;
};

/// Creates placeholder textures with the shapes of a recorded use and binds them to their units. The memory
/// of the textures is not touched.
class Stand {
 public:
  Stand(const BoundViews& views, const ProgramInterface& interface) {
    for (const auto& [unit, shape] : views.textures) glBindTextureUnit(unit, make(shape));
    for (const auto& [unit, image] : views.images) bindImage(unit, image);
    for (const ProgramInterface::View& view : interface.views)
      for (const auto& [name, given] : views.named) {
        if (!namesView(name, view.name)) continue;
        if (view.image)
          bindImage(view.unit, given);
        else
          glBindTextureUnit(view.unit, make(given.shape));
      }
  }

 private:
  void bindImage(GLuint unit, const BoundViews::Image& image) {
    glBindImageTexture(unit, make(image.shape), image.level, GL_FALSE, 0, image.access, image.format);
  }

  GLuint make(const TextureShape& shape) {
    GLuint name = 0;
    glCreateTextures(shape.levels == 0 ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D, 1, &name);
    textures_.emplace_back(name);
    if (shape.levels > 0) {
      glTextureStorage2D(name, shape.levels, shape.format, shape.width, shape.height);
      glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, shape.filters[0]);
      glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, shape.filters[1]);
      glTextureParameteri(name, GL_TEXTURE_WRAP_S, shape.wraps[0]);
      glTextureParameteri(name, GL_TEXTURE_WRAP_T, shape.wraps[1]);
      return name;
    }
    GLuint buffer = 0;
    glCreateBuffers(1, &buffer);
    buffers_.emplace_back(buffer);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(shape.bufferBytes), nullptr, 0);
    glTextureBufferRange(name, shape.format, buffer, static_cast<GLintptr>(shape.offset),
                         static_cast<GLsizeiptr>(shape.viewBytes));
    return name;
  }

  std::vector<Handle<DeleteBuffer>> buffers_;
  std::vector<Handle<DeleteTexture>> textures_;
};

/// Compiles and links a kernel. Then dispatches it with zero groups for each recorded use, so that the
/// driver compiles machine code. Failures are ignored, because the thread that needs the kernel reports
/// them.
void compile(const Job& job) {
  const Handle<DeleteShader> shader(glCreateShader(GL_COMPUTE_SHADER));
  const char* text = job.text.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  const Handle<DeleteProgram> program(glCreateProgram());
  glAttachShader(program.get(), shader.get());
  glLinkProgram(program.get());
  GLint good = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &good);
  if (good != GL_TRUE) return;
  glUseProgram(program.get());
  const ProgramInterface interface = ProgramInterface::of(program.get());
  for (const BoundViews& use : job.uses) {
    const Stand stand(use, interface);
    glDispatchComputeIndirect(0);
  }
  glUseProgram(0);
}

/// Threads that take jobs from the end of the queue, while the main thread needs the kernels at its start.
class Pool {
 public:
  Pool() = default;
  ~Pool() {
    {
      const std::scoped_lock lock(mutex_);
      ended_ = true;
      added_.notify_all();
    }
    for (std::thread& thread : threads_) thread.join();
  }
  Pool(Pool&&) = delete;
  Pool(const Pool&) = delete;
  Pool& operator=(Pool&&) = delete;
  Pool& operator=(const Pool&) = delete;

  void add(Job job) {
    const std::scoped_lock lock(mutex_);
    const bool known = std::any_of(jobs_.begin(), jobs_.end(),
                                   [&](const Job& other) { return other.program == job.program; });
    if (!known) jobs_.push_back(std::move(job));
    added_.notify_all();
  }

  void claim(const LinkedProgram& program) {
    std::unique_lock lock(mutex_);
    const auto found =
        std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& job) { return job.program == &program; });
    if (found == jobs_.end()) return;
    if (found->state == Job::State::waiting) found->state = Job::State::done;
    finished_.wait(lock, [&] { return found->state == Job::State::done; });
  }

  void start() {
    if (!threads_.empty()) return;
    const std::size_t count = std::clamp<std::size_t>(processorShare() - 1, 1, 7);
    try {
      while (threads_.size() < count) threads_.emplace_back([this] { run(); });
    } catch (const std::system_error&) {  // NOLINT(bugprone-empty-catch): works with fewer threads, or none
    }
  }

 private:
  void run() noexcept {
    try {
      const std::unique_ptr<SideContext> context = SideContext::make();
      if (context == nullptr) return;
      GLuint none = 0;
      glCreateBuffers(1, &none);
      const Handle<DeleteBuffer> noGroups(none);
      constexpr GLuint groups[4] = {};
      glNamedBufferStorage(none, sizeof groups, groups, 0);
      glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, none);
      while (Job* job = next()) {
        const auto start = Clock::now();
        try {
          compile(*job);
        } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): the main thread compiles it
        }
        finish(*job);
        detail("shaders: {} compiled ahead in {:.0f} ms", job->label, 1000 * secondsSince(start));
      }
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): the main thread compiles all kernels
    }
  }

  /// Waits for a job. Returns the last waiting job, or null if the pool ends.
  Job* next() {
    std::unique_lock lock(mutex_);
    while (!ended_) {
      const auto last = std::find_if(jobs_.rbegin(), jobs_.rend(),
                                     [](const Job& job) { return job.state == Job::State::waiting; });
      if (last != jobs_.rend()) {
        last->state = Job::State::running;
        return &*last;
      }
      added_.wait(lock);
    }
    return nullptr;
  }

  void finish(Job& job) {
    const std::scoped_lock lock(mutex_);
    job.state = Job::State::done;
    finished_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable finished_, added_;
  std::deque<Job> jobs_;  ///< a deque, because threads hold pointers to its elements
  bool ended_ = false;
  std::vector<std::thread> threads_;
};

/// Returns the pool. The pointer object is never destroyed, like the programs (linked_program.cpp).
std::unique_ptr<Pool>& pool() {
  static auto& one = *new std::unique_ptr<Pool>();
  return one;
}

/// true when linking a program of this context has taken too long for a hit in the driver's cache
bool cacheLacks = false;

void lacks() {
  cacheLacks = true;
  if (pool() != nullptr) pool()->start();
}

}  // namespace

bool KernelCompiler::helps() {
  return softwareDriver() && processorShare() > 1 && driverThreads() > 1 && shaderCacheKept();
}

bool KernelCompiler::isCold() {
  return cacheLacks;
}

void KernelCompiler::announce(std::vector<Rehearsal::Kernel> kernels) {
  if (pool() == nullptr) pool() = std::make_unique<Pool>();
  for (Rehearsal::Kernel& kernel : kernels) {
    const auto& stages = kernel.program->stages();
    if (stages.size() != 1 || kernel.program->linked()) continue;
    pool()->add({kernel.program.get(), kernel.program->label(), stages.front().source.text,
                 std::move(kernel.uses)});
  }
  if (cacheLacks) pool()->start();
}

void KernelCompiler::claim(const LinkedProgram& program) {
  if (pool() != nullptr) pool()->claim(program);
}

void KernelCompiler::linked(double seconds) {
  constexpr double fromCache = 0.004;
  static bool first = true;  // skips the first program, whose time includes the start of the GLSL compiler
  if (!std::exchange(first, false) && seconds > fromCache) lacks();
}

void KernelCompiler::dispatched(double seconds) {
  constexpr double fromCache = 0.02;
  static bool first = true;  // tests only the first dispatch, whose kernel computes almost nothing
  if (std::exchange(first, false) && seconds > fromCache) lacks();
}

void KernelCompiler::end() {
  pool().reset();
  cacheLacks = false;
}

}  // namespace simreel::gl
