#include "frame/field_files.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "sim/field_values.hpp"

#include <algorithm>
#include <cstring>

namespace simreel::frame {

namespace {

bool holds(const std::filesystem::path& file, const std::vector<std::byte>& bytes) {
  std::error_code error;
  if (std::filesystem::file_size(file, error) != bytes.size() || error) return false;
  try {
    const std::string present = readFile(file, "field");
    return present.size() == bytes.size() && std::memcmp(present.data(), bytes.data(), bytes.size()) == 0;
  } catch (const UserError&) {
    return false;
  }
}

}  // namespace

FieldFiles::FieldFiles(const OutputName& pictures, FieldFormat format, Existing existing,
                       std::vector<int> frames)
    : pictures_(pictures), format_(format), existing_(existing), frames_(std::move(frames)) {
  if (pictures.kind != OutputName::Kind::sequence && pictures.kind != OutputName::Kind::single)
    fail(ExitCode::usage, "--fields needs pictures to write beside: a folder, NAME_####.png or NAME.png");
}

std::filesystem::path FieldFiles::file(int frame, const std::string& field) const {
  const std::string stem = std::filesystem::path(pictures_.fileName(frame)).stem().string();
  return pictures_.folder / fmt::format("{}.{}.{}", stem, field, extension(format_));
}

void FieldFiles::begin(const std::vector<sim::Field>& fields) {
  for (const sim::Field& field : fields) names_.push_back(*field.name);
  if (names_.empty()) fail(ExitCode::usage, "--fields: no object of the scene is a field");
  if (existing_ != Existing::error) return;
  for (const int frame : frames_)
    for (const std::string& name : names_)
      if (const auto path = file(frame, name); pathExists(path))
        fail(ExitCode::inputOutput, "{} exists; use --overwrite, --skip-existing or --resume",
             path.string());
}

bool FieldFiles::wants(int frame) const {
  return existing_ != Existing::skip || misses(frame);
}

bool FieldFiles::misses(int frame) const {
  return !std::all_of(names_.begin(), names_.end(),
                      [&](const std::string& name) { return pathExists(file(frame, name)); });
}

FieldFiles::Contents FieldFiles::read(int frame, const std::vector<sim::Field>& fields) const {
  Contents contents;
  for (const sim::Field& field : fields)
    contents.emplace_back(file(frame, *field.name),
                          encodeField(format_, field.size, sim::fieldValues(field)));
  return contents;
}

void FieldFiles::write(const Contents& contents) const {
  for (const auto& [path, bytes] : contents) {
    if (existing_ == Existing::skip && pathExists(path)) continue;
    if (existing_ == Existing::resume && holds(path, bytes)) continue;
    writeFileAtomically(path, bytes);
  }
}

}  // namespace simreel::frame
