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

/// True if `picture` is "name", or "name" followed by "." or "/", such as "name.png" or "name/0001.png".
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

/// Returns the value of {output} if the character `after` follows the placeholder.
std::string RenderCommand::outputOf(const SceneFile& scene, char after) const {
  if (!eachScene()) return folder.string();
  const std::string base = (folder / scene.name).string();
  return after == '.' || after == '/' ? base : base + ".png";
}

std::vector<Placeholder> RenderCommand::placeholders(const SceneFile& scene) const {
  return {{"{scene}", "SIMREEL_SCENE", scene.file.string()},
          {"{output}", "SIMREEL_BASE", outputOf(scene, '.'), "./"},
          {"{output}", "SIMREEL_OUTPUT", outputOf(scene, ' ')}};
}

std::string RenderCommand::of(const SceneFile& scene) const {
  const auto all = placeholders(scene);
  if (std::all_of(all.begin(), all.end(),
                  [](const Placeholder& one) { return inShellQuotes(one.value) == one.value; }))
    return fillIn(text, all);
  return fmt::format("{} with {} {}", text, sceneWord, scene.file.string());
}

std::vector<std::string> RenderCommand::madeOf(const SceneFile& scene,
                                               const std::vector<SceneFile>& scenes) const {
  std::vector<std::string> own;
  for (const std::string& picture : listPictures(folder).pictures) {
    const SceneFile* owner = eachScene() ? ownerOf(picture, scenes) : &scene;
    if (owner != nullptr && owner->name == scene.name) own.push_back(picture);
  }
  return own;
}

void RenderCommand::makeRoom(const SceneFile& scene, const std::vector<SceneFile>& scenes) const {
  makeFolders((folder / scene.name).parent_path());
  if (!eachScene()) return;
  // {output}/####.png requires that the folder exists.
  if (text.find("{output}/") != std::string::npos) makeFolders(folder / scene.name);
  for (const std::string& picture : madeOf(scene, scenes)) removeFile(folder / picture);
}

void RenderCommand::run(const SceneFile& scene, const std::vector<SceneFile>& /*scenes*/) const {
  const std::string command = fillIn(text, placeholders(scene));
  try {
    // Redirects the output to the messages. Only the end of the messages is ever shown.
    ChildCommand child(
        "export SIMREEL_SCENE=\"$1\" SIMREEL_OUTPUT=\"$2\" SIMREEL_BASE=\"$3\"; shift 3; { " + command +
            "\n} >&2",
        "the command", {scene.file.string(), outputOf(scene, ' '), outputOf(scene, '.')}, timeout);
    static_cast<void>(child.rest(0));
    child.finish();
  } catch (const UserError& error) {
    throw UserError(ExitCode::inputOutput, fmt::format("{} ({})", error.what(), oneLine(of(scene))));
  }
}

void RenderCommand::checkMade(const SceneFile& scene, const std::vector<SceneFile>& scenes) const {
  if (madeOf(scene, scenes).empty())
    fail(ExitCode::inputOutput, "the command ended well but made no picture {} ({})",
         eachScene() ? (folder / scene.name).string() + ".*" : "below " + folder.string(),
         oneLine(of(scene)));
}

void RenderCommand::tryAll(const std::vector<SceneFile>& scenes, const std::vector<std::size_t>& chosen,
                           std::size_t jobs, std::vector<CommandEnd>& ends) const {
  const auto trying = [&](std::size_t i, auto step) {
    try {
      if (!ends[i].mistake) (this->*step)(scenes[i], scenes);
    } catch (const UserError& error) {
      ends[i].mistake = error;
    }
  };
  for (const std::size_t i : chosen) trying(i, &RenderCommand::makeRoom);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr end;  // exception that ends all threads: an interrupt by a signal
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < chosen.size(); i = next++) trying(chosen[i], &RenderCommand::run);
    } catch (...) {
      const std::lock_guard lock(guard);
      end = std::current_exception();
      next = chosen.size();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(jobs, chosen.size()); ++i) others.emplace_back(work);
    work();
  }
  if (end) std::rethrow_exception(end);
  for (const std::size_t i : chosen) trying(i, &RenderCommand::checkMade);
}

std::vector<CommandEnd> RenderCommand::runAll(const std::vector<SceneFile>& scenes,
                                              std::vector<std::size_t> chosen, std::size_t jobs) const {
  std::vector<CommandEnd> ends(scenes.size());
  tryAll(scenes, chosen, jobs, ends);
  for (int attempt = 0; attempt < retries; ++attempt) {
    std::erase_if(chosen, [&](std::size_t i) { return !ends[i].mistake; });
    for (const std::size_t i : chosen) {
      ends[i].failures.emplace_back(ends[i].mistake->what());
      ends[i].mistake.reset();
    }
    tryAll(scenes, chosen, jobs, ends);
  }
  return ends;
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
