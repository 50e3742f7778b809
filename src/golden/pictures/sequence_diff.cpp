#include "golden/pictures/sequence_diff.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/processor.hpp"
#include "base/text.hpp"
#include "frame/file/output_name.hpp"
#include "golden/compare/compare.hpp"
#include "golden/compare/difference_image.hpp"
#include "golden/files/png_check.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <system_error>
#include <tuple>
#include <utility>

#include <tbb/parallel_pipeline.h>

namespace simreel::golden {

namespace {

namespace fs = std::filesystem;

/// Names of the files in a folder.
std::vector<std::string> fileNames(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code unknown;
    if (!entry->is_directory(unknown)) names.push_back(entry->path().filename().string());
  }
  if (error)
    fail(ExitCode::inputOutput, "cannot list folder {}: {}", folder.empty() ? "." : folder.string(),
         error.message());
  return names;
}

/// Files by what pairs them.
template <class Key>
using Files = std::map<Key, fs::path>;

template <class Key, class Name>
PairList pairUp(const Files<Key>& a, const Files<Key>& b, const Name& name) {
  PairList list;
  for (const auto& [key, file] : a) {
    const auto other = b.find(key);
    if (other == b.end())
      list.onlyA.push_back(file.filename().string());
    else
      list.pairs.push_back({name(key, file, other->second), file, other->second});
  }
  for (const auto& [key, file] : b)
    if (!a.contains(key)) list.onlyB.push_back(file.filename().string());
  return list;
}

/// The number in a file name that the pattern makes, or nothing.
std::optional<int> frameOf(const frame::OutputName& pattern, const std::string& name) {
  if (!name.starts_with(pattern.prefix)) return std::nullopt;
  std::string_view number = std::string_view(name).substr(pattern.prefix.size());
  const auto frame = takeInteger(number);
  return frame && *frame >= 0 && pattern.fileName(*frame) == name ? frame : std::nullopt;
}

Files<int> patternFiles(const std::string& text) {
  frame::OutputName pattern;
  try {
    pattern = frame::parseOutput(text, std::numeric_limits<int>::max());
  } catch (const UserError& error) {
    std::string message = error.what();
    if (message.starts_with("--output ")) message.erase(0, 9);
    throw UserError(error.code(), message);
  }
  Files<int> files;
  for (const std::string& name : fileNames(pattern.folder))
    if (const auto frame = frameOf(pattern, name)) files[*frame] = pattern.folder / name;
  return files;
}

Files<std::string> folderFiles(const fs::path& folder) {
  Files<std::string> files;
  for (const std::string& name : fileNames(folder))
    if (lowerExtension(name) == ".png") files[name] = folder / name;
  return files;
}

frame::Image decode(const std::string& file, const fs::path& path) {
  return frame::decodeImage(std::as_bytes(std::span(file)), path.string());
}

/// Width and height from a checked PNG's header, without decoding it.
std::pair<int, int> sizeOf(const std::string& file) {
  const auto at = [&](std::size_t i) {
    int value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(file[i + k]);
    return value;
  };
  return {at(16), at(20)};
}

Metrics equalMetrics() {
  Metrics metrics;
  metrics.psnr = std::numeric_limits<double>::infinity();
  return metrics;
}

}  // namespace

const char* outcomeName(PairResult::Outcome outcome) {
  constexpr std::array names = {"equal", "within tolerance", "different", "unreadable"};
  return names.at(static_cast<std::size_t>(outcome));
}

PairList pairFolders(const fs::path& a, const fs::path& b) {
  return pairUp(folderFiles(a), folderFiles(b),
                [](const std::string& name, const fs::path&, const fs::path&) { return name; });
}

bool isPattern(const std::string& name) {
  return fs::path(name).filename().string().find_first_of("#%") != std::string::npos;
}

PairList pairPatterns(const std::string& a, const std::string& b) {
  return pairUp(patternFiles(a), patternFiles(b),
                [](int frame, const fs::path& fileA, const fs::path& fileB) {
                  return fileA.filename() == fileB.filename() ? fileA.filename().string()
                                                              : fmt::format("frame {}", frame);
                });
}

PairResult comparePair(const Pair& pair, const scene::Tolerance& tolerance, const fs::path& differenceFile,
                       bool always) {
  // Kept by each thread: fresh pages for every file cost more than all else where files are equal. Not to
  // be used after decoding, because while measure() waits, this thread may begin another pair.
  thread_local std::string fileA, fileB;
  readPngFile(pair.a, "picture", fileA);
  readPngFile(pair.b, "picture", fileB);
  PairResult result;
  const auto sizeA = sizeOf(fileA), sizeB = sizeOf(fileB);
  std::tie(result.width, result.height) = sizeA;
  const bool wantsImage = !differenceFile.empty();
  if (sameEncodedPixels(std::as_bytes(std::span(fileA)), std::as_bytes(std::span(fileB)))) {
    result.metrics = equalMetrics();
    if (!wantsImage || !always) return result;
  }
  const frame::Image a = decode(fileA, pair.a), b = decode(fileB, pair.b);
  if (sizeA != sizeB) {
    result.outcome = PairResult::Outcome::different;
    result.broken.push_back(fmt::format("sizes differ: {} is {}x{}, {} is {}x{}", pair.a.string(), a.width,
                                        a.height, pair.b.string(), b.width, b.height));
    return result;
  }
  result.metrics = measure(a, b, tolerance);
  result.broken = brokenBounds(*result.metrics, tolerance, a.width, a.height);
  const bool differs = result.metrics->differentPixels > 0;
  if (differs)
    result.outcome = result.broken.empty() ? PairResult::Outcome::within : PairResult::Outcome::different;
  if (wantsImage && (differs || always))
    writeFileAtomically(differenceFile, frame::encodePng(differenceImage(a, b), {}));
  return result;
}

void comparePairs(const std::vector<Pair>& pairs, const scene::Tolerance& tolerance,
                  const fs::path& differenceFolder,
                  const std::function<void(const Pair&, const PairResult&)>& done) {
  using Finished = std::pair<std::size_t, PairResult>;
  std::size_t at = 0;
  const auto next = [&](tbb::flow_control& control) -> std::size_t {
    if (at == pairs.size()) control.stop();
    return at == pairs.size() ? 0 : at++;
  };
  const auto compare = [&](std::size_t index) -> Finished {
    const Pair& pair = pairs[index];
    try {
      const fs::path image = differenceFolder.empty() ? fs::path() : differenceFolder / pair.a.filename();
      return {index, comparePair(pair, tolerance, image, false)};
    } catch (const UserError& error) {
      PairResult result;
      result.outcome = PairResult::Outcome::unreadable;
      result.message = error.what();
      return {index, std::move(result)};
    }
  };
  // So many pairs are in memory at a time.
  const std::size_t atOnce = 2 * processorCount();
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      atOnce,
      tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, next) &
          tbb::make_filter<std::size_t, Finished>(filter_mode::parallel, compare) &
          tbb::make_filter<Finished, void>(filter_mode::serial_in_order, [&](const Finished& finished) {
            done(pairs[finished.first], finished.second);
          }));
}

}  // namespace simreel::golden
