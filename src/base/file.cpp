#include "base/file.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <link.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace simreel {

namespace {

/// Owns a POSIX file descriptor. POSIX functions are used because iostreams do not report why a write
/// failed.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return value_; }
  [[nodiscard]] int release() { return std::exchange(value_, -1); }

 private:
  int value_;
};

/// Reads to the end of a file. `promised`: expected size in bytes. `place`: name of the file in messages.
std::string readAll(int descriptor, const char* what, const std::string& place, std::size_t maxBytes,
                    std::size_t promised = 0) {
  const auto tooLarge = [&] {
    fail(ExitCode::usage, "{} {} is larger than the limit of {} bytes", what, place, maxBytes);
  };
  if (promised > maxBytes) tooLarge();
  std::string text;
  text.reserve(promised);
  char block[1 << 16];
  while (true) {
    const ssize_t got = ::read(descriptor, block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(ExitCode::inputOutput, "cannot read {} {}: {}", what, place, std::strerror(errno));
    if (got == 0) return text;
    text.append(block, static_cast<std::size_t>(got));
    if (text.size() > maxBytes) tooLarge();
  }
}

/// Waits until a file's data, or a folder's entries, are on the disk. Also returns true if the file does
/// not support syncing, as pipes and some file systems.
bool synced(int descriptor) {
  int result = 0;
  while ((result = ::fdatasync(descriptor)) != 0 && errno == EINTR) {
  }
  return result == 0 || errno == EINVAL || errno == EROFS || errno == EOPNOTSUPP;
}

/// True if the path must be written in place and not replaced. This holds for a device, FIFO or socket, and
/// for a link of the system such as /dev/stdout or /dev/fd/3, regardless of its target. Files in /dev/shm
/// are ordinary files.
bool isDevice(const std::filesystem::path& path) {
  struct stat status {
  }, own{};
  if (::stat(path.c_str(), &status) != 0) return false;
  if (!S_ISREG(status.st_mode)) return !S_ISDIR(status.st_mode);
  const std::string& name = path.native();
  const bool ofSystem =
      (name.starts_with("/dev/") && !name.starts_with("/dev/shm/")) || name.starts_with("/proc/");
  return ofSystem && ::lstat(path.c_str(), &own) == 0 && S_ISLNK(own.st_mode);
}

/// Removes the temporary file and throws. errno must contain the reason.
[[noreturn]] void removeAndFail(const std::filesystem::path& part, const char* verb,
                                const std::filesystem::path& path) {
  const int reason = errno;
  if (!part.empty()) ::unlink(part.c_str());
  fail(ExitCode::inputOutput, "cannot {} {}: {}", verb, path.string(), std::strerror(reason));
}

}  // namespace

std::string readFile(const std::filesystem::path& path, const char* what, std::size_t maxBytes) {
  // The file is opened non-blocking, because opening a pipe without a writer would block forever.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) {
    const int reason = errno;
    fail(reason == ENOENT ? ExitCode::usage : ExitCode::inputOutput, "cannot open {} {}: {}", what,
         path.string(), std::strerror(reason));
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    fail(ExitCode::inputOutput, "cannot read {} {}: {}", what, path.string(), std::strerror(errno));
  if (S_ISDIR(status.st_mode))
    fail(ExitCode::usage, "{} {} is a folder, a file is needed", what, path.string());
  if (!S_ISREG(status.st_mode))
    fail(ExitCode::usage, "{} {} is a pipe, a device or a socket; copy what it gives into a file", what,
         path.string());
  const auto promised = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  return readAll(file.get(), what, path.string(), maxBytes, promised);
}

const std::string& standardInput(const char* what, std::size_t maxBytes) {
  static const std::string text = readAll(STDIN_FILENO, what, "on standard input", maxBytes);
  return text;
}

namespace {

/// True if `name` still refers to the open file.
bool hasName(int file, const std::filesystem::path& name) {
  struct stat opened {
  }, named{};
  return ::fstat(file, &opened) == 0 && ::stat(name.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// Opens the first of "path.part", "path.part2", ... that no other program has locked. Empties it and locks
/// it until it is closed. Reuses a file that a killed program has left. Returns -1 with errno set on
/// failure.
int openPart(const std::filesystem::path& path, std::filesystem::path& part) {
  constexpr int maximum = 1000;
  for (int attempt = 0, number = 1; attempt < maximum; ++attempt) {
    part = path.string() + (number == 1 ? ".part" : fmt::format(".part{}", number));
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) return file;
    // If the file system has no locks, the file is used without a lock.
    const bool held = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!held && hasName(file, part)) {
      if (::ftruncate(file, 0) == 0) return file;
      const int reason = errno;
      ::close(file);
      errno = reason;
      return -1;
    }
    ::close(file);
    if (held)
      ++number;  // If the file is not locked, another program has renamed it in the meantime, and
                 // the same name is tried again.
  }
  errno = EBUSY;
  return -1;
}

}  // namespace

namespace {

/// Opens a pipe or a device for writing. A pipe that no program reads is an error (ENXIO), because opening
/// it would block forever.
int openDevice(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK);
  if (file >= 0) ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return file;
}

}  // namespace

PartFile::PartFile(std::filesystem::path path) : path_(std::move(path)) {
  if (isDevice(path_)) {
    open_ = false;
    file_ = openDevice(path_);
    if (file_ < 0 && errno == ENXIO)
      fail(ExitCode::inputOutput, "cannot write {}: it is a pipe or a socket that no program reads",
           path_.string());
  } else {
    file_ = openPart(path_, part_);
  }
  if (file_ < 0) {
    part_.clear();
    giveUp("create");
  }
}

PartFile::~PartFile() {
  if (open_) ::unlink(part_.c_str());  // unlink() removes the file before close() releases the lock.
  if (file_ >= 0) ::close(file_);
}

void PartFile::giveUp(const char* verb) {
  open_ = false;
  const Descriptor closed(std::exchange(file_, -1));
  removeAndFail(part_, verb, path_);
}

void PartFile::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(file_, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) giveUp("write");
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
}

void PartFile::put(std::uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) giveUp("write");
    bytes = bytes.subspan(static_cast<std::size_t>(put));
    offset += static_cast<std::uint64_t>(put);
  }
}

void PartFile::finish(NameSync name) {
  if (!synced(file_)) giveUp("write");
  // The lock is kept until the file is renamed. Otherwise another program would treat the file as
  // abandoned.
  const Descriptor lock(open_ ? ::fcntl(file_, F_DUPFD_CLOEXEC, 0) : -1);
  // Some file systems report a full disk only at close().
  if (::close(std::exchange(file_, -1)) != 0) giveUp("write");
  if (!open_) return;  // Devices are not renamed.
  if (::rename(part_.c_str(), path_.c_str()) != 0) giveUp("rename into");
  open_ = false;
  if (name == NameSync::now) syncFolder(path_.parent_path());
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                         NameSync name) {
  PartFile file(path);
  file.append(bytes);
  file.finish(name);
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view text, NameSync name) {
  writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())), name);
}

void renameDurably(const std::filesystem::path& part, const std::filesystem::path& path) {
  const Descriptor file(::open(part.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0 || !synced(file.get())) removeAndFail(part, "write", path);
  if (::rename(part.c_str(), path.c_str()) != 0) removeAndFail(part, "rename into", path);
  syncFolder(path.parent_path());
}

void syncFolder(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder.empty() ? std::filesystem::path(".") : folder;
  const Descriptor opened(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() < 0 && errno == EACCES)
    return;  // EACCES is not an error: the folder may be writable but not readable.
  if (opened.get() >= 0 && synced(opened.get())) return;
  const int reason = errno;
  fail(ExitCode::inputOutput, "cannot sync folder {}: {}", path.string(), std::strerror(reason));
}

void checkWritable(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    fail(ExitCode::inputOutput, "cannot write {}: it is a folder", path.string());
  if (isDevice(path)) return;
  std::filesystem::path part;
  const Descriptor file(openPart(path, part));
  if (file.get() < 0) {
    const int reason = errno;
    fail(ExitCode::inputOutput, "cannot create {}: {}", path.string(), std::strerror(reason));
  }
  ::unlink(part.c_str());
}

void removeFile(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) fail(ExitCode::inputOutput, "cannot remove {}: {}", path.string(), error.message());
}

std::string lowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

void makeFolders(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  // The loop retries, because another run may remove an empty output folder at the same moment.
  for (int attempt = 0; attempt < 10; ++attempt) {
    std::filesystem::create_directories(folder, error);
    // create_directories() also reports an error for a symbolic link to a folder, which is acceptable.
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) return;
    if (error || pathExists(folder)) break;
  }
  fail(ExitCode::inputOutput, "cannot create folder {}: {}", folder.string(),
       error ? error.message() : "a file of that name exists");
}

bool pathExists(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const auto whole = [](const std::filesystem::path& given) {
    std::error_code error;
    const auto found = std::filesystem::weakly_canonical(std::filesystem::absolute(given, error), error);
    return error ? std::filesystem::path() : found;
  };
  const auto inner = whole(path), outer = whole(folder.empty() ? "." : folder);
  if (inner.empty() || outer.empty()) return false;
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

namespace {

/// Sets `data`, a path, to the name of the loaded file that contains this function. The name is empty for
/// the program.
int findOwnFile(dl_phdr_info* info, std::size_t /*size*/, void* data) {
  const auto here = reinterpret_cast<ElfW(Addr)>(&findOwnFile);
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = info->dlpi_phdr[i];
    const ElfW(Addr) begin = info->dlpi_addr + part.p_vaddr;
    if (part.p_type != PT_LOAD || here < begin || here >= begin + part.p_memsz) continue;
    *static_cast<std::filesystem::path*>(data) = info->dlpi_name;
    return 1;
  }
  return 0;
}

}  // namespace

std::filesystem::path programFile() {
  std::error_code error;
  std::filesystem::path library;
  ::dl_iterate_phdr(findOwnFile, &library);
  const auto file = library.empty() ? std::filesystem::read_symlink("/proc/self/exe", error)
                                    : std::filesystem::canonical(library, error);
  return error ? std::filesystem::path() : file;
}

std::filesystem::path programFolder() {
  return programFile().parent_path();
}

std::filesystem::path assetFolder() {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  if (const char* chosen = std::getenv("SIMREEL_ASSETS")) return chosen;
  // The last path is absolute, so operator/ ignores the program's folder.
  for (const char* place :
       {"../share/simreel/assets", "../../share/simreel/assets", "../assets", SIMREEL_SOURCE_ASSETS}) {
    std::error_code error;
    auto folder = std::filesystem::weakly_canonical(programFolder() / place, error);
    if (!error && std::filesystem::is_directory(folder, error)) return folder;
  }
  return {};
}

}  // namespace simreel
