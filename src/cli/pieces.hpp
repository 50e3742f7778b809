#pragma once
#include "batch/render/render_job.hpp"
#include "cli/options/slurm_options.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <string>

namespace simreel::cli {

/// Options of `simreel render --pieces N`, which renders a sequence in N pieces.
struct PiecesRequest {
  batch::RenderRequest render;
  std::size_t pieces = 1;
  std::string jobs = "1";
  SlurmOptions cluster;
  gl::ContextOptions on;
  std::string progress = "auto";
};
void renderInPieces(const PiecesRequest& request);

}  // namespace simreel::cli
