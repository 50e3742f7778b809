#include "frame/sink/open_sink.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"
#include "frame/sink/sequence_sink.hpp"
#include "frame/sink/stream_sink.hpp"
#include "frame/sink/video_sink.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace simreel::frame {

std::unique_ptr<FrameSink> openSink(const OutputName& output, Existing existing, const RunInfo& run,
                                    std::span<const int> frames, const std::string& streamFormat) {
  switch (output.kind) {
    case OutputName::Kind::video:
      return openVideoSink(output, existing, run, frames);
    case OutputName::Kind::stream:
      if (existing == Existing::resume || existing == Existing::skip)
        fail(ExitCode::usage,
             "--output -: --resume and --skip-existing keep frames of an earlier run, which a stream does "
             "not have; leave them out");
      return openStreamSink(streamFormat, run, frames);
    case OutputName::Kind::sequence:
    case OutputName::Kind::single:
      break;
  }
  return openSequenceSink(output, existing, run, frames);
}

namespace {

/// Throws UserError(inputOutput) if `folder` cannot be created. Creates a temporary folder with a random
/// name in the nearest existing parent as a test. Does not create `folder`, because another run may be
/// creating it at the same time.
void checkFolder(const std::filesystem::path& folder) {
  std::filesystem::path above = folder;
  while (!above.empty() && !pathExists(above)) above = above.parent_path();
  std::string probe = (above / ".simreel.XXXXXX").string();
  if (::mkdtemp(probe.data()) == nullptr)
    fail(ExitCode::inputOutput, "cannot create folder {}: {}", folder.string(), std::strerror(errno));
  ::rmdir(probe.c_str());
}

}  // namespace

namespace {

/// Returns the name of the first existing file of `frames` and the number of other existing files, as "NAME
/// and 2 more exist". Returns an empty text if no file exists.
std::string existingFiles(const OutputName& output, std::span<const int> frames) {
  std::size_t count = 0;
  std::filesystem::path first;
  for (const int frame : frames) {
    const std::filesystem::path file = output.file(frame);
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) continue;
    if (count++ == 0) first = file;
  }
  if (count == 0) return {};
  const std::string more = count == 1 ? "" : fmt::format(" and {} more", count - 1);
  return fmt::format("{}{} exist{}", first.string(), more, count == 1 ? "s" : "");
}

}  // namespace

void refuseExisting(const OutputName& output, std::span<const int> frames) {
  if (const std::string files = existingFiles(output, frames); !files.empty())
    fail(ExitCode::inputOutput, "{}; use --overwrite, --skip-existing or --resume", files);
}

void tellOfRedrawn(const OutputName& output, std::span<const int> frames,
                   const std::map<int, ManifestFrame>& kept) {
  std::vector<int> redrawn;
  for (const int frame : frames)
    if (!kept.contains(frame)) redrawn.push_back(frame);
  const std::string files = existingFiles(output, redrawn);
  if (files.empty()) return;
  const std::string manifest = output.manifestFile().string();
  if (pathExists(output.manifestFile()))
    info("{} without being listed as whole in {}; drawn anew", files, manifest);
  else
    warn("{} without {}, which says how frames were made; all are drawn anew", files, manifest);
}

namespace {

/// Throws UserError(inputOutput) if a folder has the name of a picture.
void refuseFolders(const OutputName& output, std::span<const int> frames) {
  for (const int frame : frames) {
    const std::filesystem::path file = output.file(frame);
    std::error_code unknown;
    if (std::filesystem::is_directory(file, unknown))
      fail(ExitCode::inputOutput, "cannot write the picture {}: a folder has this name; remove it",
           file.string());
  }
}

/// Throws UserError if the output is a video that exists and must not be replaced, or cannot be: videos are
/// written to files beside it and renamed.
void checkVideo(const std::filesystem::path& file, Existing existing) {
  std::error_code unknown;
  const auto status = std::filesystem::symlink_status(file, unknown);
  if (!std::filesystem::exists(status)) return;
  if (existing == Existing::error)
    fail(ExitCode::inputOutput, "{} exists; use --overwrite or --skip-existing", file.string());
  if (std::filesystem::is_other(std::filesystem::status(file, unknown)))
    fail(ExitCode::usage,
         "--output {}: this is a pipe or a device, and a video is a file; to pipe pictures, use -o -",
         file.string());
}

}  // namespace

void checkOutput(const OutputName& output, Existing existing, std::span<const int> frames) {
  if (output.kind == OutputName::Kind::stream || frames.empty()) return;
  if (output.kind == OutputName::Kind::video) {
    checkVideo(output.file(frames.front()), existing);
  } else {
    if (existing == Existing::error) refuseExisting(output, frames);
    refuseFolders(output, frames);
  }
  if (output.manifest && isForeignManifest(output.manifestFile()))
    fail(ExitCode::inputOutput,
         "{} is not simreel's and would be replaced; choose another folder, or use --no-manifest",
         output.manifestFile().string());
  if (!output.folder.empty() && !pathExists(output.folder))
    checkFolder(output.folder);
  else
    checkWritable(output.manifestFile());
}

}  // namespace simreel::frame
