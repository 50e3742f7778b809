#include "frame/sink/field_files.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"
#include "scene/json/words.hpp"
#include "sim/grid/field_values.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace simreel::frame {

FieldFiles::FieldFiles(const OutputName& pictures, FieldChoice choice, Existing existing,
                       std::vector<int> frames)
    : pictures_(pictures), choice_(std::move(choice)), existing_(existing), frames_(std::move(frames)) {
  if (pictures.kind != OutputName::Kind::sequence && pictures.kind != OutputName::Kind::single)
    fail(ExitCode::usage,
         "--fields writes beside pictures; give as --output a folder, NAME_####.png or NAME.png");
}

bool FieldFiles::isChosen(const sim::Field& field) const {
  if (field.decoration) return false;
  const auto& names = choice_.names;
  return names.empty() || std::find(names.begin(), names.end(), *field.name) != names.end();
}

std::string FieldFiles::fileName(int frame, const std::string& field) const {
  const std::string stem = std::filesystem::path(pictures_.fileName(frame)).stem().string();
  return fmt::format("{}.{}.{}", stem, field, extension(choice_.format));
}

void FieldFiles::begin(const std::vector<sim::Field>& fields) {
  std::vector<std::string> all;
  for (const sim::Field& field : fields) {
    if (!field.decoration) all.push_back(*field.name);
    if (isChosen(field)) names_.push_back(*field.name);
  }
  if (all.empty()) fail(ExitCode::usage, "--fields: no object of the scene is a field");
  for (const std::string& name : choice_.names)
    if (std::find(all.begin(), all.end(), name) == all.end())
      fail(ExitCode::usage, "--fields: the scene has no field \"{}\"; {}", name,
           scene::suggestion(name, all));
  if (existing_ != Existing::error) return;
  for (const int frame : frames_)
    for (const std::string& name : names_)
      if (const auto path = pictures_.folder / fileName(frame, name); pathExists(path))
        fail(ExitCode::inputOutput, "{} exists; use --overwrite, --skip-existing or --resume",
             path.string());
}

bool FieldFiles::misses(int frame, const std::string& field, const FrameSink& sink) const {
  const std::string name = fileName(frame, field);
  if (existing_ == Existing::skip) return !pathExists(pictures_.folder / name);
  return existing_ != Existing::resume || !sink.holds(frame, name);
}

bool FieldFiles::misses(int frame, const FrameSink& sink) const {
  return std::any_of(names_.begin(), names_.end(),
                     [&](const std::string& name) { return misses(frame, name, sink); });
}

std::vector<FrameFile> FieldFiles::read(int frame, const std::vector<sim::Field>& fields,
                                        const FrameSink& sink) const {
  std::vector<FrameFile> files;
  for (const sim::Field& field : fields)
    if (isChosen(field) && misses(frame, *field.name, sink))
      files.push_back(
          {fileName(frame, *field.name), encodeField(choice_.format, field.size, sim::fieldValues(field))});
  return files;
}

}  // namespace simreel::frame
