#include "frame/sink/ffmpeg.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/stream_sink.hpp"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace simreel::frame {

namespace {

bool hasH264(const std::string& extension) {
  return extension == ".mp4" || extension == ".m4v" || extension == ".mov" || extension == ".mkv";
}

/// Returns the encoder options for an extension (lower case, with dot). Unknown extensions use ffmpeg's
/// default encoder.
std::vector<std::string> encoderArguments(const std::string& extension) {
  // The pixel format 4:2:0 needs even sizes. The colour matrix is also stored in the file, because players
  // otherwise guess it from the size.
  const std::string even =
      "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
  const std::vector<std::string> colour = {"-colorspace", "bt709", "-color_primaries", "bt709",
                                           "-color_trc",  "bt709", "-color_range",     "tv"};
  std::vector<std::string> result;
  if (hasH264(extension)) {
    result = {"-vf", even, "-c:v", "libx264", "-preset", "medium", "-crf", "18"};
    result.insert(result.end(), colour.begin(), colour.end());
    if (extension != ".mkv") result.insert(result.end(), {"-movflags", "+faststart"});
  } else if (extension == ".webm") {
    result = {"-vf", even, "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1"};
    result.insert(result.end(), colour.begin(), colour.end());
  } else if (extension == ".gif") {
    result = {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"};
  } else if (extension == ".apng") {
    result = {"-pix_fmt", "rgb24", "-plays", "0"};
  } else {
    result = {"-q:v", "3"};
  }
  return result;
}

/// Returns the signal's name such as " (SIGKILL)", or an empty text if it has none.
std::string signalName(int number) {
  const char* name = ::sigabbrev_np(number);
  return name == nullptr ? std::string() : fmt::format(" (SIG{})", name);
}

/// Returns the last line that is not empty.
std::string lastLine(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  const std::size_t begin = text.find_last_of("\r\n");
  return begin == std::string::npos ? text : text.substr(begin + 1);
}

void closeIfOpen(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

}  // namespace

std::vector<std::string> ffmpegArguments(const std::filesystem::path& file, int width, int height,
                                         const FrameRate& rate) {
  std::vector<std::string> result = {
      "ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y",
      "-f",     "rawvideo",     "-pix_fmt", "rgba",      "-s",    fmt::format("{}x{}", width, height),
      "-r",     rate.text('/'), "-i",       "pipe:0"};
  const std::vector<std::string> encoder = encoderArguments(lowerExtension(file));
  result.insert(result.end(), encoder.begin(), encoder.end());
  // The output of x264 and other encoders depends on the number of threads, which defaults to the number of
  // processors. A fixed number makes the output reproducible; more threads than processors cost little.
  result.insert(result.end(), {"-threads", "8"});
  // bitexact keeps version and time out of the file. The prefix "file:" prevents ffmpeg from interpreting a
  // name that contains - or : in another way.
  result.insert(result.end(), {"-fflags", "+bitexact", "-flags:v", "+bitexact", "file:" + file.string()});
  return result;
}

std::pair<int, int> videoSize(const std::filesystem::path& file, int width, int height) {
  const std::string extension = lowerExtension(file);
  if (!hasH264(extension) && extension != ".webm") return {width, height};
  return {width + width % 2, height + height % 2};
}

Ffmpeg::Ffmpeg(const std::vector<std::string>& arguments, std::filesystem::path file)
    : file_(std::move(file)) {
  ignoreBrokenPipes();
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0)
    fail(ExitCode::inputOutput, "cannot make a pipe: {}", std::strerror(errno));
  input_ = ends[1];
  messages_ = makeMemoryFile("simreel-ffmpeg");
  const int error =
      messages_ < 0
          ? errno
          : startProcess(arguments, {.input = ends[0], .output = -1, .messages = messages_}, process_);
  ::close(ends[0]);
  if (error == 0) return;
  closeIfOpen(input_);
  closeIfOpen(messages_);
  if (error == ENOENT)
    fail(ExitCode::inputOutput,
         "ffmpeg is not installed, and video files need it: apt install ffmpeg, or render PNG frames into "
         "a folder");
  fail(ExitCode::inputOutput, "cannot start ffmpeg: {}", std::strerror(error));
}

Ffmpeg::~Ffmpeg() {
  kill();
  closeIfOpen(input_);
  if (process_ > 0) wait();
  closeIfOpen(messages_);
}

void Ffmpeg::kill() noexcept {
  const std::lock_guard lock(mutex_);
  if (process_ > 0) ::kill(process_, SIGKILL);
}

void Ffmpeg::write(std::span<const std::byte> bytes) {
  const int error = writeAll(input_, bytes);
  if (error == 0) return;
  if (error != EPIPE) fail(ExitCode::inputOutput, "cannot write to ffmpeg: {}", std::strerror(error));
  // ffmpeg closed its input, so it has ended or will end soon. Waits at most 2 s before killing it.
  constexpr int attempts = 200;
  constexpr useconds_t pause = 10'000;  // interval in microseconds
  siginfo_t ended{};
  for (int k = 0; k < attempts && ended.si_pid == 0; ++k) {
    if (k > 0) ::usleep(pause);
    if (::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOWAIT | WNOHANG) != 0) break;
  }
  if (ended.si_pid == 0) {
    killed_ = true;
    kill();
  }
  failed(wait());
}

void Ffmpeg::finish() {
  closeIfOpen(input_);
  const int status = wait();
  if (status != 0) failed(status);
}

int Ffmpeg::wait() {
  // Waits first. Reads the exit status afterwards, under the mutex, so that kill() in another thread never
  // signals a reused process id.
  siginfo_t ended{};
  while (::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  const std::lock_guard lock(mutex_);
  childEnded(process_);
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Ffmpeg::failed(int status) {
  closeIfOpen(input_);
  std::string how = "closed its input";
  if (WIFEXITED(status)) how = fmt::format("ended with status {}", WEXITSTATUS(status));
  if (WIFSIGNALED(status) && childrenWereEnded())
    how = "had stopped reading, and was ended,";
  else if (WIFSIGNALED(status) && !killed_)
    how = fmt::format("was ended by signal {}{}", WTERMSIG(status), signalName(WTERMSIG(status)));
  const std::string messages = endOfMemoryFile(messages_);
  // ffmpeg reports these errors in several sentences of its own, which name the temporary file.
  for (const int full : {ENOSPC, EDQUOT, EFBIG})
    if (const char* reason = std::strerror(full); messages.find(reason) != std::string::npos)
      fail(ExitCode::inputOutput, "cannot write {}: {}; make room there, or choose another --output",
           file_.string(), reason);
  const std::string line = lastLine(messages);
  fail(ExitCode::inputOutput, "ffmpeg {} before the video was complete{}{}", how, line.empty() ? "" : ": ",
       line);
}

}  // namespace simreel::frame
