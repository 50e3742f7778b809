#include "golden/pictures/render_command.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "golden/bisect/child_command.hpp"
#include "golden/pictures/picture_folder.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view sceneWord = "{scene}", outputWord = "{output}";

/// "name" of "name.png" or "name/0001.png".
bool isOf(const std::string& picture, const std::string& name) {
  if (!picture.starts_with(name)) return false;
  return picture.size() == name.size() || picture[name.size()] == '.' || picture[name.size()] == '/';
}

}  // namespace

void RenderCommand::check() const {
  if (text.find(outputWord) == std::string::npos)
    fail(ExitCode::usage,
         "--run needs {{output}}, where the picture goes, for example: --run 'my_renderer {{scene}} -o "
         "{{output}}'");
}

std::string RenderCommand::of(const SceneFile& scene) const {
  std::string made;
  const fs::path base = folder / scene.name;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = std::string_view(text).substr(at);
    if (rest.starts_with(sceneWord)) {
      made += inShellQuotes(scene.file.string());
      at += sceneWord.size();
    } else if (rest.starts_with(outputWord)) {
      at += outputWord.size();
      const char after = at < text.size() ? text[at] : ' ';
      if (!eachScene())
        made += inShellQuotes(folder.string());
      else if (after == '.' || after == '/')
        made += inShellQuotes(base.string());
      else
        made += inShellQuotes(base.string() + ".png");
    } else {
      made += text[at++];
    }
  }
  return made;
}

std::vector<std::string> RenderCommand::madeOf(const SceneFile& scene) const {
  std::vector<std::string> own;
  for (const std::string& picture : listPictures(folder).pictures)
    if (!eachScene() || isOf(picture, scene.name)) own.push_back(picture);
  return own;
}

void RenderCommand::makeRoom(const SceneFile& scene) const {
  makeFolders((folder / scene.name).parent_path());
  if (!eachScene()) return;
  // A folder of its own: {output}/####.png expects it.
  if (text.find("{output}/") != std::string::npos) makeFolders(folder / scene.name);
  for (const std::string& picture : madeOf(scene)) removeFile(folder / picture);
}

void RenderCommand::run(const SceneFile& scene) const {
  const std::string command = of(scene);
  // What it prints goes with its messages: only the end of those is ever shown.
  ChildCommand child("{ " + command + "\n} >&2", "the command");
  static_cast<void>(child.rest(0));
  try {
    child.finish();
  } catch (const UserError& error) {
    throw UserError(ExitCode::inputOutput, fmt::format("{} ({})", error.what(), oneLine(command)));
  }
}

void RenderCommand::checkMade(const SceneFile& scene) const {
  if (madeOf(scene).empty())
    fail(ExitCode::inputOutput, "the command ended well but made no picture {} ({})",
         eachScene() ? (folder / scene.name).string() + ".*" : "below " + folder.string(),
         oneLine(of(scene)));
}

std::vector<std::optional<UserError>> RenderCommand::runAll(const std::vector<SceneFile>& scenes,
                                                            std::size_t jobs) const {
  std::vector<std::optional<UserError>> mistakes(scenes.size());
  const auto trying = [&](std::size_t i, auto step) {
    try {
      if (!mistakes[i]) (this->*step)(scenes[i]);
    } catch (const UserError& error) {
      mistakes[i] = error;
    }
  };
  // Before any runs: "a" would take "a.b.png" of "a.b" for its own.
  for (std::size_t i = 0; i < scenes.size(); ++i) trying(i, &RenderCommand::makeRoom);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr end;  // of all: an interrupt
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < scenes.size(); i = next++) trying(i, &RenderCommand::run);
    } catch (...) {
      const std::lock_guard lock(guard);
      end = std::current_exception();
      next = scenes.size();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(jobs, scenes.size()); ++i) others.emplace_back(work);
    work();
  }
  if (end) std::rethrow_exception(end);
  for (std::size_t i = 0; i < scenes.size(); ++i) trying(i, &RenderCommand::checkMade);
  return mistakes;
}

std::vector<SceneFile> findInputs(std::span<const std::string> paths) {
  std::vector<SceneFile> found;
  for (const std::string& path : paths) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      const PictureFolder below = listPictures(path);
      for (const auto* list : {&below.pictures, &below.others})
        for (const std::string& name : *list)
          if (!name.ends_with('/') && !fs::path(name).filename().string().starts_with('.'))
            found.push_back({fs::path(name).replace_extension().generic_string(), fs::path(path) / name});
    } else if (fs::exists(path, error)) {
      found.push_back({fs::path(path).stem().string(), path});
    } else {
      fail(ExitCode::usage, "there is no file or folder {}", path);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const SceneFile& a, const SceneFile& b) { return a.name < b.name; });
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i].name == found[i - 1].name)
      fail(ExitCode::usage, "{} and {} would make the same picture {}; give one of them",
           found[i - 1].file.string(), found[i].file.string(), found[i].name);
  return found;
}

const SceneFile* ownerOf(const std::string& picture, const std::vector<SceneFile>& scenes) {
  const SceneFile* owner = nullptr;
  for (const SceneFile& scene : scenes)
    if (isOf(picture, scene.name) && (owner == nullptr || scene.name.size() > owner->name.size()))
      owner = &scene;
  return owner;
}

}  // namespace simreel::golden
