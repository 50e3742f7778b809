#include "batch/pieces/piece_plan.hpp"

#include "base/error.hpp"
#include "base/version.hpp"
#include "batch/plan/plan_json.hpp"
#include "frame/frames_spec.hpp"

#include <algorithm>
#include <set>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;

constexpr const char* piecesFormat = "simreel-pieces";
constexpr int piecesVersion = 1;

PiecePlan parsedPieces(const std::string& text) {
  const auto json = parseStrictJson(text);
  const JsonValue object(json);
  expectFormat(object, piecesFormat, piecesVersion);
  if (const std::string program = object.at("program").text(); program != version())
    throw JsonError(fmt::format(
        "it was written by simreel {}, and other versions cannot read its checkpoints", program));
  PiecePlan plan;
  plan.output = object.at("output").text();
  plan.assets = foldersIn(object.at("assets"));
  plan.overrides = overridesIn(object.at("overrides"));
  plan.fields = object.at("fields").text();
  plan.counts = object.at("counts").boolean();
  object.at("pieces").eachItem([&](const JsonValue& item) {
    Piece piece{frame::parseFrames(item.at("frames").text())};
    if (!plan.pieces.empty() && plan.pieces.back().frames.back() != piece.first())
      item.wrong("does not begin with the last frame of the previous piece");
    plan.pieces.push_back(std::move(piece));
  });
  if (plan.pieces.empty()) throw JsonError("it has no pieces");
  return plan;
}

}  // namespace

std::vector<Piece> splitFrames(const std::vector<int>& frames, std::size_t pieces) {
  if (pieces > frames.size())
    fail(ExitCode::usage, "--pieces {}: there are {} frames to draw", pieces, frames.size());
  std::vector<Piece> result;
  for (std::size_t i = 0; i < pieces; ++i) {
    const std::size_t begin = frames.size() * i / pieces;
    const std::size_t end = std::min(frames.size() * (i + 1) / pieces + 1, frames.size());
    result.push_back({{frames.begin() + static_cast<std::ptrdiff_t>(begin),
                       frames.begin() + static_cast<std::ptrdiff_t>(end)}});
  }
  return result;
}

std::vector<int> PiecePlan::allFrames() const {
  std::set<int> frames;
  for (const Piece& piece : pieces) frames.insert(piece.frames.begin(), piece.frames.end());
  return {frames.begin(), frames.end()};
}

frame::OutputName PiecePlan::wholeOutput() const {
  return frame::parseOutput(output, allFrames().size());
}

std::string PiecePlan::pieceOutputText(std::size_t piece) const {
  const frame::OutputName whole = wholeOutput();
  const fs::path own = folder / fmt::format("{:04}", piece);
  const bool pattern = whole.kind == frame::OutputName::Kind::sequence && !whole.wholeFolder;
  return pattern ? (own / fs::path(output).filename()).string() : own.string() + "/";
}

frame::OutputName PiecePlan::pieceOutput(std::size_t piece) const {
  return frame::parseOutput(pieceOutputText(piece), pieces.at(piece).frames.size());
}

RenderRequest PiecePlan::simulation(const std::string& command) const {
  RenderRequest request;
  request.input = {sceneFile(), {}, overrides, assets};
  request.output = folder.string() + "/";
  request.frames = "none";
  request.existing = frame::Existing::resume;
  request.command = command;
  for (std::size_t i = 1; i < pieces.size(); ++i) request.checkpointAt.insert(pieces[i].first());
  return request;
}

RenderRequest PiecePlan::drawing(std::size_t piece, const std::string& command) const {
  RenderRequest request;
  request.input = {sceneFile(), {}, overrides, assets};
  request.output = pieceOutputText(piece);
  request.frames = frame::framesText({pieces.at(piece).frames.begin(), pieces.at(piece).frames.end()});
  request.existing = frame::Existing::resume;
  if (!fields.empty()) request.fields = fields;
  request.counts = counts;
  request.command = command;
  if (piece > 0)
    request.from = frame::parseOutput(folder.string() + "/", 2).checkpointFile(pieces[piece].first());
  return request;
}

std::string planText(const PiecePlan& plan) {
  std::string text = openObject({{"format", piecesFormat},
                                 {"version", piecesVersion},
                                 {"program", version()},
                                 {"output", plan.output},
                                 {"assets", folderList(plan.assets)},
                                 {"overrides", overrideList(plan.overrides)},
                                 {"fields", plan.fields},
                                 {"counts", plan.counts}});
  text += ",\n  \"pieces\": [";
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const auto& frames = plan.pieces[i].frames;
    text += (i == 0 ? "\n    " : ",\n    ") +
            lineOf({{"piece", i}, {"frames", frame::framesText({frames.begin(), frames.end()})}});
  }
  return text + "\n  ]\n}\n";
}

PiecePlan readPiecePlan(const fs::path& folder) {
  const fs::path file = folder / "plan.json";
  const std::string text = readPlan(file, "pieces");
  PiecePlan plan;
  try {
    plan = parsedPieces(text);
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "plan {} cannot be read: {}", file.string(), error.what());
  }
  plan.folder = folder;
  return plan;
}

}  // namespace simreel::batch
