#include "frame/file/output_name.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace simreel::frame {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 10> videoExtensions = {".mp4", ".webm", ".gif", ".mkv", ".mov",
                                                              ".avi", ".apng", ".m4v", ".ogv", ".mpg"};
constexpr int maxDigits = 20;  ///< max number of digits of a frame number in a file name
constexpr const char* supported =
    "supported are a folder, NAME_####.png or .exr, NAME.png or .exr for one frame, a video (.mp4, .webm, "
    ".gif, .mkv, "
    ".mov, .avi, .apng, .m4v, .ogv, .mpg), or - for standard output";

/// Position of the frame number in a file name.
struct Placeholder {
  std::size_t begin;
  std::size_t length;
  int digits;
};

/// Parses a `%d` or `%04d` at position `at`. Returns nothing if the text at this position is anything else.
std::optional<Placeholder> printfAt(const std::string& name, std::size_t at) {
  std::size_t i = at + 1;
  int digits = 0;
  if (i < name.size() && name[i] == '0') {
    ++i;
    const std::size_t widthAt = i;
    while (i < name.size() && isDigit(name[i]) && i - widthAt < 3) digits = digits * 10 + (name[i++] - '0');
    if (i == widthAt) return std::nullopt;
  }
  if (i >= name.size() || name[i] != 'd' || digits > maxDigits) return std::nullopt;
  return Placeholder{at, i + 1 - at, digits};
}

/// Returns all placeholders of a file name. Throws UserError(usage) if a '%' does not start a valid
/// placeholder.
std::vector<Placeholder> findPlaceholders(const std::string& output, const std::string& name) {
  std::vector<Placeholder> found;
  for (std::size_t i = 0; i < name.size();) {
    if (name[i] == '#') {
      const std::size_t end = std::min(name.find_first_not_of('#', i), name.size());
      if (end - i > std::size_t{maxDigits})
        fail(ExitCode::usage, "--output {}: at most {} # are allowed", output, maxDigits);
      found.push_back({i, end - i, static_cast<int>(end - i)});
      i = end;
    } else if (name[i] == '%') {
      const auto placeholder = printfAt(name, i);
      if (!placeholder)
        fail(ExitCode::usage, "--output {}: only %d and %0Nd (such as %04d) may follow a %, or use ####",
             output);
      found.push_back(*placeholder);
      i += placeholder->length;
    } else {
      ++i;
    }
  }
  return found;
}

bool isVideo(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  return std::find(videoExtensions.begin(), videoExtensions.end(), extension) != videoExtensions.end();
}

bool isPicture(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".png" || extension == ".exr";
}

OutputName folderOutput(const fs::path& folder) {
  OutputName result;
  result.folder = folder;
  result.suffix = ".png";
  result.digits = 6;
  result.wholeFolder = true;
  return result;
}

/// Parses an output with a placeholder. Returns nothing if there is no placeholder.
std::optional<OutputName> patternOutput(const std::string& output) {
  const fs::path path(output);
  const std::string name = path.filename().string();
  const auto placeholders = findPlaceholders(output, name);
  if (placeholders.empty()) return std::nullopt;
  if (placeholders.size() > 1)
    fail(ExitCode::usage, "--output {}: the frame number may occur only once", output);
  if (!isPicture(name))
    fail(ExitCode::usage,
         "--output {}: numbered frames are PNG or OpenEXR files, so the name must end in .png or .exr",
         output);
  const Placeholder& at = placeholders.front();
  OutputName result;
  result.folder = path.parent_path();
  result.prefix = name.substr(0, at.begin);
  result.suffix = name.substr(at.begin + at.length);
  result.digits = at.digits;
  return result;
}

OutputName fileOutput(OutputName::Kind kind, const fs::path& path) {
  OutputName result;
  result.kind = kind;
  result.folder = path.parent_path();
  result.prefix = path.filename().string();
  return result;
}

}  // namespace

std::string OutputName::fileName(int frame) const {
  if (kind != Kind::sequence) return prefix;
  return fmt::format("{}{:0{}}{}", prefix, frame, digits, suffix);
}

bool OutputName::isLight() const {
  return (kind == Kind::sequence || kind == Kind::single) && lowerExtension(fileName(0)) == ".exr";
}

std::filesystem::path OutputName::file(int frame) const {
  return folder / fileName(frame);
}

std::filesystem::path OutputName::manifestFile() const {
  return besideFrames("manifest.json");
}

std::filesystem::path OutputName::runFile() const {
  return besideFrames("run.json");
}

std::filesystem::path OutputName::sceneFile() const {
  return besideFrames("as-run.json");
}

std::filesystem::path OutputName::countFile() const {
  return besideFrames("counts.csv");
}

std::filesystem::path OutputName::checkpointFile() const {
  return kind == Kind::video || !manifest ? std::filesystem::path() : besideFrames("checkpoint");
}

std::filesystem::path OutputName::checkpointFile(int frame) const {
  const std::filesystem::path file = checkpointFile();
  return file.empty() ? file : std::filesystem::path(fmt::format("{}.{:06}", file.string(), frame));
}

std::filesystem::path OutputName::piecesFolder() const {
  return besideFrames("pieces");
}

std::filesystem::path OutputName::besideFrames(const char* ending) const {
  if (kind == Kind::stream) return {};
  if (kind == Kind::video) return folder / fmt::format("{}.{}", prefix, ending);
  std::string stem = kind == Kind::single ? fs::path(prefix).stem().string() : prefix;
  while (!stem.empty() && std::string_view("_-.").find(stem.back()) != std::string_view::npos)
    stem.pop_back();
  return folder / (wholeFolder || stem.empty() ? ending : fmt::format("{}.{}", stem, ending));
}

OutputName parseOutput(const std::string& output, std::size_t frameCount) {
  if (output.empty()) fail(ExitCode::usage, "--output is empty: {}", supported);
  if (output.find('\0') != std::string::npos) fail(ExitCode::usage, "--output contains a zero byte");
  if (output == "-") return fileOutput(OutputName::Kind::stream, {});
  std::error_code error;
  const fs::path path(output);
  if (output.back() == '/') return folderOutput(path);
  if (fs::is_directory(path, error)) {
    if (isVideo(path) || isPicture(path))
      fail(ExitCode::usage,
           "--output {}: this is a folder, not a {}; to write numbered pictures into it, add a /", output,
           isVideo(path) ? "video" : "picture");
    return folderOutput(path);
  }
  const std::string parent = path.parent_path().string();
  if (parent.find('#') != std::string::npos && !fs::is_directory(parent, error))
    fail(ExitCode::usage, "--output {}: put the frame number in the file's name, not in the folder's",
         output);
  if (auto pattern = patternOutput(output)) return *pattern;

  const std::string extension = lowerExtension(path);
  if (extension.empty()) return folderOutput(path);
  if (isPicture(path)) {
    if (frameCount != 1)
      fail(ExitCode::usage, "--output {}: one name for {} frames; write {}_####{}", output, frameCount,
           (path.parent_path() / path.stem()).string(), extension);
    return fileOutput(OutputName::Kind::single, path);
  }
  if (isVideo(path)) return fileOutput(OutputName::Kind::video, path);
  fail(ExitCode::usage, "--output {}: {} is not supported; {} (end a folder's name with /)", output,
       extension, supported);
}

}  // namespace simreel::frame
