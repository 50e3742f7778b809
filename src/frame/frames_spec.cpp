#include "frame/frames_spec.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <string_view>

namespace simreel::frame {

namespace {

class Reader {
 public:
  Reader(const std::string& text, const char* option, std::optional<int> last)
      : text_(text), option_(option), last_(last) {}

  std::vector<int> read() {
    std::vector<int> frames;
    do {
      skipBlanks();
      const std::size_t begin = at_;
      const int first = number("a frame number");
      int last = first, step = 1;
      if (accept('-')) {
        last = number("the last frame of the range");
        if (last < first) wrong(begin, fmt::format("the range {}-{} runs backwards", first, last));
        if (accept('x') && (step = number("a step after the x")) == 0)
          wrong(at_ - 1, "the step must be at least 1");
      }
      const std::size_t count = static_cast<std::size_t>((last - first) / step) + 1;
      if (frames.size() + count > maxFrames) wrong(begin, fmt::format("more than {} frames", maxFrames));
      for (int frame = first; frame <= last; frame += step) frames.push_back(frame);
      skipBlanks();
    } while (accept(','));
    if (at_ < text_.size()) wrong(at_, fmt::format("unexpected '{}'", text_[at_]));
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
  }

 private:
  void skipBlanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool accept(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  int number(const char* what) {
    const std::size_t begin = at_;
    constexpr std::string_view lastWord = "last";
    if (last_ && std::string_view(text_).substr(at_).starts_with(lastWord)) {
      at_ += lastWord.size();
      return *last_;
    }
    long value = 0;
    for (; at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
      value = value * 10 + (text_[at_] - '0');
      if (value > largestFrame) wrong(begin, fmt::format("a number above {}", largestFrame));
    }
    if (at_ == begin) wrong(begin, fmt::format("{} is expected", what));
    return static_cast<int>(value);
  }

  [[noreturn]] void wrong(std::size_t at, const std::string& what) const {
    fail(ExitCode::usage, "{} {}: {} at character {}; write for example 0-99, 0-99x2, or {}", option_,
         text_, what, at + 1, last_ ? "0,last" : "0-9,20");
  }

  const std::string& text_;
  const char* option_;
  std::optional<int> last_;  ///< frame number that the word "last" stands for; nullopt if the word is not
                             ///< allowed
  std::size_t at_ = 0;
};

}  // namespace

std::vector<int> parseFrames(const std::string& text, const char* option, std::optional<int> last) {
  return Reader(text, option, last).read();
}

std::string framesText(const std::set<int>& frames) {
  std::string text;
  for (auto at = frames.begin(); at != frames.end();) {
    const int first = *at;
    int last = first;
    while (++at != frames.end() && *at == last + 1) last = *at;
    text += fmt::format("{}{}", text.empty() ? "" : ",", first);
    if (last > first) text += fmt::format("-{}", last);
  }
  return text;
}

}  // namespace simreel::frame
