#include "batch/render/scratch.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
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

/// Files directly in a folder, manifests last; not what is half written, or locked by who is gone.
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
  own_ = root / fmt::format("simreel-{}-{}", hashHex(fs::absolute(shared_).string()), ::getpid());
  makeFolders(own_);
  for (const fs::path& file : filesOf(shared_))
    writeFileAtomically(own_ / file.filename(), readFile(file, "file", anySize), NameSync::later);
}

Scratch::~Scratch() {
  if (own_.empty()) return;
  std::error_code ignored;
  fs::remove_all(own_, ignored);
}

void Scratch::deliver() {
  if (own_.empty()) return;
  makeFolders(shared_);
  std::set<std::string> names;
  bool synced = false;
  for (const fs::path& file : filesOf(own_)) {
    const fs::path to = shared_ / file.filename();
    names.insert(file.filename().string());
    if (isManifest(file) && !std::exchange(synced, true)) syncFolder(shared_);
    const std::string bytes = readFile(file, "file", anySize);
    if (pathExists(to) && readFile(to, "file", anySize) == bytes) continue;
    writeFileAtomically(to, bytes, NameSync::later);
  }
  // A checkpoint that is needed no more, and the like.
  for (const fs::path& file : filesOf(shared_))
    if (!names.contains(file.filename().string())) removeFile(file);
  syncFolder(shared_);
}

}  // namespace simreel::batch
