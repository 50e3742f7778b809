#include "golden/pictures/sequence_diff.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/processor.hpp"
#include "base/text.hpp"
#include "frame/file/output_name.hpp"
#include "golden/compare/comparison.hpp"
#include "golden/files/picture.hpp"
#include "golden/files/png_check.hpp"
#include "golden/pictures/picture_folder.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

#include <tbb/parallel_invoke.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace simreel::golden {

namespace {

namespace fs = std::filesystem;

/// Returns the names of the files in a folder.
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

/// Maps the key that pairs files, a name or a frame number, to a file.
template <class Key>
using Files = std::map<Key, fs::path>;

template <class Key, class Name>
PairList pairUp(const Files<Key>& a, const Files<Key>& b, const Name& name) {
  PairList list;
  const auto only = [](const Key& key, const fs::path& file) {
    if constexpr (std::is_same_v<Key, std::string>)
      return key;
    else
      return file.filename().string();
  };
  for (const auto& [key, file] : a) {
    const auto other = b.find(key);
    if (other == b.end())
      list.onlyA.push_back(only(key, file));
    else
      list.pairs.push_back({name(key, file, other->second), file, other->second});
  }
  for (const auto& [key, file] : b)
    if (!a.contains(key)) list.onlyB.push_back(only(key, file));
  return list;
}

/// Returns the frame number in a file name that matches the pattern, or nothing.
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

Metrics equalMetrics() {
  Metrics metrics;
  metrics.psnr = std::numeric_limits<double>::infinity();
  return metrics;
}

/// Decodes both pictures in parallel. Uses isolation, because a waiting thread could otherwise start to
/// compare another pair, whose files would overwrite the same thread-local memory.
std::pair<Picture, Picture> decodeBoth(const Pair& pair, std::string_view fileA, std::string_view fileB) {
  std::pair<Picture, Picture> both;
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_invoke([&] { both.first = decodePicture(fileA, "picture", pair.a.string()); },
                         [&] { both.second = decodePicture(fileB, "picture", pair.b.string()); });
  });
  return both;
}

}  // namespace

const char* outcomeName(PairResult::Outcome outcome) {
  constexpr std::array names = {"equal", "within tolerance", "different", "unreadable"};
  return names.at(static_cast<std::size_t>(outcome));
}

PairList pairFolders(const fs::path& a, const fs::path& b) {
  const PictureFolder listA = listPictures(a), listB = listPictures(b);
  const auto filesOf = [](const fs::path& folder, const PictureFolder& list) {
    Files<std::string> files;
    for (const std::string& name : list.pictures) files[name] = folder / name;
    return files;
  };
  PairList list = pairUp(filesOf(a, listA), filesOf(b, listB),
                         [](const std::string& name, const fs::path&, const fs::path&) { return name; });
  for (const auto& [folder, others] : {std::pair(&a, &listA.others), std::pair(&b, &listB.others)})
    for (const std::string& name : *others) list.passedOver.push_back((*folder / name).generic_string());
  return list;
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

PairResult comparePair(const Pair& pair, const PairTerms& terms, const fs::path& differenceFile,
                       bool always) {
  // The buffers are thread-local, because allocating new pages for every file takes longer than comparing
  // equal files. Do not use them after decoding, because the thread may start another pair while compare()
  // waits.
  thread_local std::string fileA, fileB;
  readBytes(pair.a, "picture", fileA);
  checkPicture(fileA, "picture", pair.a.string());
  readBytes(pair.b, "picture", fileB);
  checkPicture(fileB, "picture", pair.b.string());
  PairResult result;
  const bool wantsImage = !differenceFile.empty();
  const auto bytesA = std::as_bytes(std::span(fileA)), bytesB = std::as_bytes(std::span(fileB));
  // If both files have the same chunks, decodes only one of them. Decoding is needed because an undecodable
  // file must not count as equal.
  if (sizeOfPng(bytesA) && sameEncodedPixels(bytesA, bytesB) && (!wantsImage || !always)) {
    const Picture picture = decodePicture(fileA, "picture", pair.a.string());
    result.metrics = equalMetrics();
    result.width = picture.image.width;
    result.height = picture.image.height;
    return result;
  }
  const auto [a, b] = decodeBoth(pair, fileA, fileB);
  for (const auto& [file, picture] : {std::pair(&pair.a, &a), std::pair(&pair.b, &b)})
    if (!picture->note.empty()) result.notes.push_back(file->string() + ": " + picture->note);
  const Comparison made = compare(a, b, terms.tolerance, terms.allowance, terms.measures);
  result.width = made.a.width;
  result.height = made.a.height;
  result.metrics = made.metrics;
  if (!made.colours.empty()) result.notes.push_back(made.colours);
  if (!made.layerNote.empty()) result.notes.push_back(made.layerNote);
  result.broken = brokenBounds(*result.metrics, terms.tolerance, made.a.width, made.a.height);
  if (!made.sizes.empty())
    result.broken.insert(result.broken.begin(),
                         fmt::format("sizes differ: {} is {}x{}, {} is {}x{}; compared as {}x{}, padded",
                                     pair.a.string(), a.image.width, a.image.height, pair.b.string(),
                                     b.image.width, b.image.height, made.a.width, made.a.height));
  if (!made.layers.empty()) result.broken.insert(result.broken.begin(), made.layers);
  const bool differs = result.metrics->differentPixels > 0 || !result.broken.empty();
  if (differs)
    result.outcome = result.broken.empty() ? PairResult::Outcome::within : PairResult::Outcome::different;
  if (wantsImage && (differs || always))
    writeFileAtomically(differenceFile, frame::encodePng(differenceImage(made), {}));
  return result;
}

void comparePairs(const std::vector<Pair>& pairs, const PairTerms& terms, const fs::path& differenceFolder,
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
      fs::path image;
      if (!differenceFolder.empty()) {
        // pair.name is a path below both folders, except for the names "frame N" of patterns.
        const bool named = pair.a.generic_string().ends_with(pair.name);
        image = differenceFolder / (named ? fs::path(pair.name) : pair.a.filename());
        if (lowerExtension(image) != ".png") image += ".png";
        makeFolders(image.parent_path());
      }
      return {index, comparePair(pair, terms, image, false)};
    } catch (const UserError& error) {
      PairResult result;
      result.outcome = PairResult::Outcome::unreadable;
      result.message = error.what();
      return {index, std::move(result)};
    }
  };
  // Max number of pairs in memory at a time.
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
