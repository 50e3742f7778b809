#include "frame/sink/progress.hpp"

#include "base/error.hpp"
#include "frame/sink/stream_sink.hpp"

#include <algorithm>
#include <cmath>
#include <sys/ioctl.h>
#include <unistd.h>

namespace simreel::frame {

namespace {

constexpr std::chrono::milliseconds showEvery{100};

int columns(int descriptor) {
  winsize size{};
  return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string count(int frames) {
  return fmt::format("{} frame{}", frames, frames == 1 ? "" : "s");
}

}  // namespace

Progress::Progress(Mode mode, int descriptor) : mode_(mode), descriptor_(descriptor) {
  if (mode_ == Mode::automatic) mode_ = ::isatty(descriptor) != 0 ? Mode::terminal : Mode::none;
}

void Progress::start(int total) {
  total_ = total;
  done_ = 0;
  begin_ = Clock::now();
  event(fmt::format("{{\"event\":\"start\",\"frames\":{}}}", total));
  if (mode_ == Mode::terminal) print();
}

void Progress::prepare(long done, long total) {
  if (done < total && Clock::now() - lastShown_ < showEvery) return;
  if (mode_ == Mode::ndjson) {
    lastShown_ = Clock::now();
    event(fmt::format("{{\"event\":\"prepare\",\"done\":{},\"total\":{},\"seconds\":{:.3f}}}", done, total,
                      secondsSince(begin_)));
  }
  if (mode_ != Mode::terminal) return;
  lastShown_ = Clock::now();
  shown_ = true;
  std::string text = fmt::format("before the first frame: {}/{} steps", done, total);
  text.resize(std::min(text.size(), static_cast<std::size_t>(std::max(1, columns(descriptor_) - 1))));
  write("\r" + text + "\x1b[K");
}

void Progress::frame(int number, const StageTimes& stages) {
  ++done_;
  event(
      fmt::format("{{\"event\":\"frame\",\"frame\":{},\"done\":{},\"total\":{},\"seconds\":{:.3f},"
                  "\"simulate\":{:.6f},\"draw\":{:.6f},\"readBack\":{:.6f},\"encode\":{:.6f}}}",
                  number, done_, total_, secondsSince(begin_), stages.simulate, stages.draw,
                  stages.readBack, stages.encode));
  if (mode_ == Mode::terminal && (done_ == total_ || Clock::now() - lastShown_ >= showEvery)) print();
}

void Progress::check(const std::string& what, int frame, std::optional<double> value, bool passed) {
  if (mode_ != Mode::ndjson) return;
  const bool finite = value && std::isfinite(*value);
  event(fmt::format("{{\"event\":\"check\",\"what\":\"{}\",\"frame\":{},\"value\":{},\"passed\":{}}}", what,
                    frame, finite ? fmt::format("{}", *value) : "null", passed));
}

void Progress::counts(int frame, std::string_view names, std::string_view row) {
  if (mode_ != Mode::ndjson) return;
  std::string line = fmt::format("{{\"event\":\"counts\",\"frame\":{}", frame);
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(','));
    const std::string_view value = row.substr(0, row.find(','));
    const bool finite = value.find_first_of("nN") == std::string_view::npos;
    if (!value.empty()) line += fmt::format(",\"{}\":{}", name, finite ? value : "null");
    names.remove_prefix(std::min(names.size(), name.size() + 1));
    row.remove_prefix(std::min(row.size(), value.size() + 1));
  }
  event(line + "}");
}

void Progress::event(const std::string& object) const {
  if (mode_ != Mode::ndjson) return;
  write((job_.empty() ? object : fmt::format("{{\"job\":\"{}\",{}", job_, object.substr(1))) + "\n");
}

void Progress::finish(const char* status, const StageTimes& stages) {
  event(fmt::format(
      "{{\"event\":\"end\",\"status\":\"{}\",\"done\":{},\"total\":{},\"seconds\":{:.3f},\"start\":{:.6f},"
      "\"simulate\":{:.6f},\"draw\":{:.6f},\"readBack\":{:.6f},\"encode\":{:.6f},\"wait\":{:.6f}}}",
      status, done_, total_, secondsSince(begin_), stages.start, stages.simulate, stages.draw,
      stages.readBack, stages.encode, stages.wait));
  clear();
}

void Progress::clear() {
  if (shown_) write("\r\x1b[K");
  shown_ = false;
}

void Progress::print() {
  lastShown_ = Clock::now();
  shown_ = true;
  // Uses one column less than the terminal has, because a full line would wrap on some terminals. The
  // escape sequence erases the remainder of an earlier, longer line.
  write(fmt::format("\r{}\x1b[K",
                    progressLine(done_, total_, secondsSince(begin_), columns(descriptor_) - 1)));
}

void Progress::write(const std::string& text) const {
  // Ignores errors, because a closed standard error must not end the run.
  (void)writeAll(descriptor_, std::as_bytes(std::span(text)));
}

Progress::Mode parseProgressMode(const std::string& text) {
  if (text == "auto") return Progress::Mode::automatic;
  if (text == "tty") return Progress::Mode::terminal;
  if (text == "ndjson") return Progress::Mode::ndjson;
  if (text == "none") return Progress::Mode::none;
  fail(ExitCode::usage, "--progress {} is unknown; use auto, tty, ndjson or none", text);
}

std::string progressLine(int done, int total, double seconds, int width) {
  const double rate = seconds > 0 ? done / seconds : 0;
  std::string text = fmt::format(" {}/{}", done, total);
  if (done > 0 && rate > 0) {
    text += fmt::format("  {:.1f} frames/s", rate);
    if (done < total) text += fmt::format("  {} left", formatDuration((total - done) / rate));
  }
  constexpr int minBar = 5, maxBar = 40;
  const int room = std::min(maxBar, width - static_cast<int>(text.size()) - 2);
  if (room < minBar)
    return text.substr(std::min<std::size_t>(1, text.size()), static_cast<std::size_t>(std::max(0, width)));
  const double part = total > 0 ? std::clamp(static_cast<double>(done) / total, 0.0, 1.0) : 1.0;
  const auto filled = static_cast<std::size_t>(part * room);
  const auto empty = static_cast<std::size_t>(room) - filled;
  return fmt::format("[{}{}]{}", std::string(filled, '#'), std::string(empty, '.'), text);
}

std::string closingLine(int frames, double seconds, const StageTimes& stages, const std::string& where) {
  std::string line = fmt::format("{} in {}", count(frames), formatDuration(seconds));
  if (frames > 0 && seconds > 0) line += fmt::format(" ({:.1f} frames/s)", frames / seconds);
  line += fmt::format(": start {}, simulate {}, draw {}, read back {}, encode {}, wait {}",
                      formatDuration(stages.start), formatDuration(stages.simulate),
                      formatDuration(stages.draw), formatDuration(stages.readBack),
                      formatDuration(stages.encode), formatDuration(stages.wait));
  return where.empty() ? line : line + " -> " + where;
}

std::string formatDuration(double seconds) {
  if (seconds < 59.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(std::lround(std::min(seconds, 1e9)));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace simreel::frame
