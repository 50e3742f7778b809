#include "batch/render/scratch.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <signal.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t anySize = std::numeric_limits<std::size_t>::max() / 2;

bool isManifest(const fs::path& file) {
  return file.filename().string().ends_with("manifest.json");
}

/// Returns the files directly in a folder, with manifests last. Skips incomplete files (.part) and locks.
std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && entry.path().extension() != ".part" &&
        entry.path().extension() != ".lock")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(isManifest(a), a) < std::pair(isManifest(b), b);
  });
  return files;
}

void removeAll(const fs::path& folder) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace

fs::path scratchRoot(const std::string& text) {
  std::string path;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '$') {
      path += text[i];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
      ++end;
    const std::string name = text.substr(i + 1, end - i - 1);
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
    const char* value = std::getenv(name.c_str());
    if (name.empty() || value == nullptr || *value == '\0')
      fail(ExitCode::usage, "--scratch {}: ${} is not set here", text, name);
    path += value;
    i = end - 1;
  }
  return path;
}

Scratch::Scratch(fs::path shared, const fs::path& root) : shared_(std::move(shared)) {
  if (root.empty()) return;
  const std::string name = fmt::format("simreel-{}-", hashHex(fs::absolute(shared_).string()));
  removeLeftovers(root, name);
  own_ = root / fmt::format("{}{}", name, ::getpid());
  makeFolders(own_);
  try {
    bring();
  } catch (...) {
    removeAll(own_);
    throw;
  }
}

Scratch::~Scratch() {
  if (!own_.empty()) removeAll(own_);
}

/// Removes folders of killed processes that did the same work, because they would otherwise fill the disk.
void Scratch::removeLeftovers(const fs::path& root, const std::string& name) const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(root, error)) {
    const std::string found = entry.path().filename().string();
    if (!found.starts_with(name)) continue;
    std::string_view digits = std::string_view(found).substr(name.size());
    const auto process = takeInteger(digits);
    if (process && *process > 0 && digits.empty() && ::kill(*process, 0) != 0 && errno == ESRCH)
      removeAll(entry.path());
  }
}

void Scratch::bring() {
  for (const fs::path& file : filesOf(shared_)) {
    writeFileAtomically(own_ / file.filename(), readFile(file, "file", anySize), NameSync::later);
    brought_.insert(file.filename().string());
  }
}

void Scratch::deliver() {
  if (own_.empty()) return;
  makeFolders(shared_);
  bool synced = false;
  for (const fs::path& file : filesOf(own_)) {
    const fs::path to = shared_ / file.filename();
    brought_.erase(file.filename().string());
    if (isManifest(file) && !std::exchange(synced, true)) syncFolder(shared_);
    const std::string bytes = readFile(file, "file", anySize);
    if (pathExists(to) && readFile(to, "file", anySize) == bytes) continue;
    writeFileAtomically(to, bytes, NameSync::later);
  }
  // The run has removed these files, such as a checkpoint that is no longer needed.
  for (const std::string& name : brought_) removeFile(shared_ / name);
  syncFolder(shared_);
}

}  // namespace simreel::batch
