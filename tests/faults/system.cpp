// Makes calls about files, threads, processes and memory fail.
#include "calls.hpp"

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <new>
#include <pthread.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

using faults::Class;
using faults::fails;

namespace {

/// Returns the original function that this library replaces.
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// True for files of the kernel that describe the machine. Reading them is not counted, because only texts
/// in a manifest depend on it.
bool isKernels(const char* path) {
  return std::strncmp(path, "/proc/", 6) == 0 || std::strncmp(path, "/sys/", 5) == 0;
}

}  // namespace

#define CALLER __builtin_return_address(0)
/// Defines a function that fails with `result` and `error`.
#define FAILING(kind, type, name, parameters, arguments, result, error) \
  extern "C" type name parameters {                                     \
    static auto* const real = next<type parameters>(#name);             \
    if (fails(Class::kind, #name, CALLER, true)) {                      \
      errno = error;                                                    \
      return result;                                                    \
    }                                                                   \
    return real arguments;                                              \
  }

// Always passes the mode on. If the caller did not give a mode, the value is unused.
#define MODE                                \
  std::va_list list;                        \
  va_start(list, flags);                    \
  const mode_t mode = va_arg(list, mode_t); \
  va_end(list);
extern "C" int open(const char* path, int flags, ...) {
  static auto* const real = next<int(const char*, int, ...)>("open");
  MODE if (!isKernels(path) && fails(Class::open, "open", CALLER, true)) return errno = EACCES, -1;
  return real(path, flags, mode);
}
extern "C" int open64(const char* path, int flags, ...) {
  static auto* const real = next<int(const char*, int, ...)>("open64");
  MODE if (!isKernels(path) && fails(Class::open, "open64", CALLER, true)) return errno = EACCES, -1;
  return real(path, flags, mode);
}
extern "C" int openat(int folder, const char* path, int flags, ...) {
  static auto* const real = next<int(int, const char*, int, ...)>("openat");
  MODE if (!isKernels(path) && fails(Class::open, "openat", CALLER, true)) return errno = EACCES, -1;
  return real(folder, path, flags, mode);
}
extern "C" std::FILE* fopen(const char* path, const char* mode) {
  static auto* const real = next<std::FILE*(const char*, const char*)>("fopen");
  if (!isKernels(path) && fails(Class::open, "fopen", CALLER, true)) return errno = EACCES, nullptr;
  return real(path, mode);
}
extern "C" std::FILE* fopen64(const char* path, const char* mode) {
  static auto* const real = next<std::FILE*(const char*, const char*)>("fopen64");
  if (!isKernels(path) && fails(Class::open, "fopen64", CALLER, true)) return errno = EACCES, nullptr;
  return real(path, mode);
}
FAILING(open, int, memfd_create, (const char* name, unsigned flags), (name, flags), -1, EMFILE)

FAILING(read, ssize_t, read, (int file, void* data, std::size_t size), (file, data, size), -1, EIO)
FAILING(read, std::size_t, fread, (void* data, std::size_t size, std::size_t count, std::FILE* file),
        (data, size, count, file), 0, EIO)
FAILING(write, ssize_t, write, (int file, const void* data, std::size_t size), (file, data, size), -1,
        ENOSPC)
FAILING(write, ssize_t, pwrite, (int file, const void* data, std::size_t size, off_t at),
        (file, data, size, at), -1, ENOSPC)
FAILING(write, ssize_t, writev, (int file, const iovec* parts, int count), (file, parts, count), -1, ENOSPC)
FAILING(write, std::size_t, fwrite,
        (const void* data, std::size_t size, std::size_t count, std::FILE* file), (data, size, count, file),
        0, ENOSPC)
FAILING(write, int, fflush, (std::FILE * file), (file), EOF, ENOSPC)
FAILING(write, int, ftruncate, (int file, off_t size), (file, size), -1, ENOSPC)
FAILING(sync, int, fsync, (int file), (file), -1, EIO)
FAILING(sync, int, fdatasync, (int file), (file), -1, EIO)
FAILING(sync, int, syncfs, (int file), (file), -1, EIO)
FAILING(sync, int, sync_file_range, (int file, off64_t at, off64_t size, unsigned flags),
        (file, at, size, flags), -1, EIO)
FAILING(rename, int, rename, (const char* from, const char* to), (from, to), -1, EIO)
FAILING(rename, int, renameat, (int a, const char* from, int b, const char* to), (a, from, b, to), -1, EIO)
FAILING(unlink, int, unlink, (const char* path), (path), -1, EIO)
FAILING(unlink, int, remove, (const char* path), (path), -1, EIO)
FAILING(unlink, int, unlinkat, (int folder, const char* path, int flags), (folder, path, flags), -1, EIO)
FAILING(unlink, int, rmdir, (const char* path), (path), -1, EIO)
FAILING(mkdir, int, mkdir, (const char* path, mode_t mode), (path, mode), -1, ENOSPC)
FAILING(lock, int, flock, (int file, int how), (file, how), -1, ENOLCK)
// Only commands that lock a file are counted.
extern "C" int fcntl(int file, int command, ...) {
  static auto* const real = next<int(int, int, ...)>("fcntl");
  std::va_list list;
  va_start(list, command);
  void* const argument = va_arg(list, void*);
  va_end(list);
  const bool locks =
      command == F_SETLK || command == F_SETLKW || command == F_OFD_SETLK || command == F_OFD_SETLKW;
  if (locks && fails(Class::lock, "fcntl", CALLER, true)) return errno = ENOLCK, -1;
  return real(file, command, argument);
}
FAILING(pipe, int, pipe2, (int* ends, int flags), (ends, flags), -1, EMFILE)
FAILING(pipe, int, pipe, (int* ends), (ends), -1, EMFILE)

// A failing close() also closes the file.
extern "C" int close(int file) {
  static auto* const real = next<int(int)>("close");
  const bool bad = fails(Class::close, "close", CALLER, true);
  const int result = real(file);
  return bad ? (errno = EIO, -1) : result;
}
extern "C" int fclose(std::FILE* file) {
  static auto* const real = next<int(std::FILE*)>("fclose");
  const bool bad = fails(Class::close, "fclose", CALLER, true);
  const int result = real(file);
  return bad ? (errno = EIO, EOF) : result;
}

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*body)(void*),
                              void* argument) {
  static auto* const real =
      next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  if (fails(Class::thread, "pthread_create", CALLER, true)) return EAGAIN;
  return real(thread, attributes, body, argument);
}

using Spawn = int(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
                  char* const*, char* const*);
extern "C" int posix_spawnp(pid_t* child, const char* file, const posix_spawn_file_actions_t* actions,
                            const posix_spawnattr_t* attributes, char* const* arguments,
                            char* const* environment) {
  static auto* const real = next<Spawn>("posix_spawnp");
  if (fails(Class::process, "posix_spawnp", CALLER, true)) return EAGAIN;
  return real(child, file, actions, attributes, arguments, environment);
}

/// Defines an allocating function. Only allocations by the program are counted, not those by libraries.
#define ALLOCATING(name, symbol, parameters, arguments, refuse) \
  void* name parameters {                                       \
    static auto* const real = next<void * parameters>(symbol);  \
    if (fails(Class::alloc, #name, CALLER, false)) refuse;      \
    return real arguments;                                      \
  }
ALLOCATING(operator new, "_Znwm", (std::size_t size), (size), throw std::bad_alloc())
ALLOCATING(operator new[], "_Znam", (std::size_t size), (size), throw std::bad_alloc())
ALLOCATING(operator new, "_ZnwmSt11align_val_t", (std::size_t size, std::align_val_t to), (size, to),
           throw std::bad_alloc())
ALLOCATING(operator new[], "_ZnamSt11align_val_t", (std::size_t size, std::align_val_t to), (size, to),
           throw std::bad_alloc())
#undef ALLOCATING
#define QUIET(name, symbol)                                                            \
  void* name(std::size_t size, const std::nothrow_t& tag) noexcept {                   \
    static auto* const real = next<void*(std::size_t, const std::nothrow_t&)>(symbol); \
    if (fails(Class::alloc, #name, CALLER, false)) return nullptr;                     \
    return real(size, tag);                                                            \
  }
QUIET(operator new, "_ZnwmRKSt9nothrow_t")
QUIET(operator new[], "_ZnamRKSt9nothrow_t")
