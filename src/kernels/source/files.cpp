#include "kernels/source/files.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "gl/shader_source.hpp"
#include "kernels/source/plain.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr const char* unityFolder = "kernels/unity/";

/// Returns the index of `token` in a line. Prefers a whole word to a substring.
std::size_t findToken(std::string_view line, std::string_view token) {
  if (token.empty()) return std::string_view::npos;
  for (std::size_t at = line.find(token); at != std::string_view::npos; at = line.find(token, at + 1)) {
    const std::size_t end = at + token.size();
    const bool begins = !partOfName(token.front()) || at == 0 || !partOfName(line[at - 1]);
    const bool ends = !partOfName(token.back()) || end >= line.size() || !partOfName(line[end]);
    if (begins && ends) return at;
  }
  return line.find(token);
}

/// Returns the embedded replacement of a Unity file, or nullptr if there is none.
const char* unityFile(const std::string& name) {
  constexpr std::string_view package = "Packages/com.unity.render-pipelines.core/ShaderLibrary/";
  const std::string wanted =
      unityFolder + (name.starts_with(package) ? "core/" + name.substr(package.size()) : name);
  for (const gl::EmbeddedShader& shader : gl::embeddedShaders())
    if (wanted == shader.path) return shader.text;
  return nullptr;
}

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Finds a file below a folder, ignoring case. Returns an empty path if there is no match or more than one.
std::filesystem::path withoutCase(const std::filesystem::path& folder, const std::filesystem::path& name) {
  std::vector<std::filesystem::path> found = {folder};
  for (const auto& part : name) {
    std::vector<std::filesystem::path> next;
    for (const auto& path : found) {
      if (part == ".." || part == ".") {
        next.push_back(path / part);
        continue;
      }
      std::error_code error;
      for (std::filesystem::directory_iterator entry(path, error), end; !error && entry != end;
           entry.increment(error))
        if (lowered(entry->path().filename().string()) == lowered(part.string()))
          next.push_back(entry->path());
    }
    found = std::move(next);
  }
  return found.size() == 1 ? found[0] : std::filesystem::path();
}

/// Returns true for the name of a file that ships with Unity.
bool isUnitys(std::string_view name) {
  return name.starts_with("Packages/com.unity.") || name.starts_with("Unity") ||
         name == "AutoLight.cginc" || name == "Lighting.cginc" || name == "Tessellation.cginc" ||
         name == "TerrainEngine.cginc";
}

/// Returns the names of the Unity files for which the program has replacements.
std::string unityFiles() {
  std::string names;
  for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
    const std::string_view path = shader.path;
    if (!path.starts_with(unityFolder)) continue;
    const std::string_view name = path.substr(std::string_view(unityFolder).size());
    names += (names.empty() ? "" : ", ");
    names += name.starts_with("core/") ? "the core package's " : "";
    names += name.substr(name.starts_with("core/") ? 5 : 0);
  }
  return names;
}

}  // namespace

Files::Files(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders) {
  folders_.push_back(file.parent_path());
  folders_.insert(folders_.end(), folders.begin(), folders.end());
  std::string reason;
  if (!add(file.string(), file, readFile(file, "shader", maxFileBytes), reason))
    simreel::fail(ExitCode::usage, "{}: {}", file.string(), reason);
}

std::optional<std::size_t> Files::add(std::string name, const std::filesystem::path& path,
                                      std::string original, std::string& reason) {
  if (original.find('\0') != std::string::npos) {
    reason = "this is not a text file: it contains a zero byte; save it as UTF-8";
    return std::nullopt;
  }
  bytes_ += original.size();
  if (bytes_ > maxAllBytes) {
    reason = fmt::format("with all that it includes, the shader is larger than {} MB", maxAllBytes >> 20U);
    return std::nullopt;
  }
  if (const std::string deep = tooDeep(original); !deep.empty()) {
    reason = deep;
    return std::nullopt;
  }
  std::string text = plain(original);
  files_.push_back({std::move(name), path, std::move(original), std::move(text), {}, 0});
  return files_.size() - 1;
}

std::optional<std::size_t> Files::include(const std::string& asked, bool beside, std::size_t from,
                                          std::string& reason) {
  std::string name = asked;
  std::replace(name.begin(), name.end(), '\\', '/');
  name.erase(0, std::min(name.find_first_not_of('/'), name.size()));  // Microsoft's compiler treats "/X"
                                                                      // like "X".
  std::vector<std::filesystem::path> tried;
  if (beside && !files_[from].path.empty()) tried.push_back(files_[from].path.parent_path() / name);
  for (const auto& folder : folders_) tried.push_back(folder / name);
  const auto isFile = [](const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
  };
  if (std::none_of(tried.begin(), tried.end(), isFile))
    for (auto& path : tried) {
      const std::filesystem::path folder = path.string().substr(0, path.string().size() - name.size());
      path = withoutCase(folder.empty() ? "." : folder, name);
    }
  bool outside = false;
  for (const auto& path : tried) {
    if (!isFile(path)) continue;
    if (std::none_of(folders_.begin(), folders_.end(),
                     [&](const auto& folder) { return liesBelow(path, folder); })) {
      outside = true;
      continue;
    }
    const auto shown = path.lexically_normal();
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (files_[i].path == shown) return i;
    try {
      return add(shown.string(), shown, readFile(shown, "include", maxFileBytes), reason);
    } catch (const UserError& error_) {
      reason = error_.what();
      return std::nullopt;
    }
  }
  if (const char* ours = unityFile(name)) {
    const std::string shown = "(simreel's own) " + std::filesystem::path(name).filename().string();
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (files_[i].name == shown) return i;
    return add(shown, {}, ours, reason);
  }
  if (!outside && isUnitys(name)) {
    reason = fmt::format(
        "{} is a file of Unity that simreel does not include; copy the code that the kernel needs from it. "
        "simreel includes {}",
        scene::inQuotes(asked), unityFiles());
    return std::nullopt;
  }
  reason = outside ? fmt::format(
                         "{} lies outside the folders that may be read: the shader's own and those "
                         "given with -I",
                         scene::inQuotes(asked))
                   : fmt::format("{} is not in the shader's folder; give the folder that has it with -I",
                                 scene::inQuotes(asked));
  return std::nullopt;
}

const std::string& Files::remediedText(std::size_t file) {
  File& one = files_[file];
  if (remedies.count() == 0) return one.text;
  if (one.remedies != remedies.count()) one.remedied = remedied(one.text, file, remedies);
  one.remedies = remedies.count();
  return one.remedied;
}

std::vector<std::filesystem::path> Files::read() const {
  std::vector<std::filesystem::path> paths;
  for (const File& file : files_)
    if (!file.path.empty()) paths.push_back(file.path);
  return paths;
}

scene::Place Files::place(const Mistake& mistake) const {
  const std::string& text = files_[mistake.file].original;
  std::size_t begin = 0;
  for (int line = 1; line < mistake.line; ++line) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    begin = end + 1;
  }
  std::string_view line = std::string_view(text).substr(begin);
  line = line.substr(0, line.find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::size_t at = findToken(line, mistake.token), length = mistake.token.size();
  if (at == std::string_view::npos) {
    at = std::min(line.find_first_not_of(" \t"), line.size());
    length = line.size() - at;
    while (length > 1 && std::isspace(static_cast<unsigned char>(line[at + length - 1])) != 0) --length;
  }
  return {static_cast<int>(mistake.file), begin + at, begin + at + std::max<std::size_t>(length, 1)};
}

void Files::fail(const std::vector<Mistake>& mistakes) const {
  scene::Diagnostics diagnostics(files_[0].name, files_[0].original);
  for (std::size_t i = 1; i < files_.size(); ++i) diagnostics.addFile(files_[i].name, files_[i].original);
  for (const Mistake& mistake : mistakes) diagnostics.add(place(mistake), mistake.message);
  throw UserError(ExitCode::usage, diagnostics.report(), UserError::Form::report);
}

}  // namespace simreel::kernels
