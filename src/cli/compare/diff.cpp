// simreel diff A B: compares two pictures, or two sequences of pictures.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/compare/diff_report.hpp"
#include "cli/options/allowance_options.hpp"
#include "cli/options/tolerance_options.hpp"
#include "frame/file/output_name.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/files/picture.hpp"
#include "golden/pictures/picture_folder.hpp"
#include "golden/pictures/rules.hpp"
#include "golden/pictures/sequence_diff.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;
using Outcome = golden::PairResult::Outcome;

struct DiffOptions {
  std::string a, b, output;
  ToleranceOptions tolerance;
  AllowanceOptions allowance;
  bool json = false, quick = false;
};

golden::Allowance allowanceFor(const DiffOptions& options) {
  golden::Allowance allowance;
  allowance.ignoreAntialiased = options.allowance.ignoreAntialiased;
  allowance.searchRadius = options.allowance.searchRadius.value_or(0);
  if (options.allowance.mask.empty()) return allowance;
  const auto size = golden::readPicture(options.allowance.mask, "mask").image;
  golden::Terms terms;
  terms.masks.emplace_back(options.allowance.mask);
  allowance.mask = golden::allowanceOf(terms, size.width, size.height).mask;
  return allowance;
}

golden::PairTerms termsFor(const DiffOptions& options, const scene::Tolerance& tolerance) {
  return {tolerance, allowanceFor(options),
          options.quick ? golden::Measures::quick : golden::Measures::all};
}

/// Throws UserError if the output would overwrite one of the compared files.
void checkOutput(const fs::path& output, const fs::path& a, const fs::path& b) {
  for (const fs::path& input : {a, b}) {
    std::error_code unknown;
    if (!input.empty() && fs::equivalent(output, input, unknown))
      fail(ExitCode::usage, "-o {} is one of the two that are compared; choose another name",
           output.string());
  }
}

/// Prints JSON. Replaces invalid UTF-8, because file names may contain any bytes.
void printJson(const nlohmann::ordered_json& json) {
  printText(json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void comparePictures(const DiffOptions& options, const scene::Tolerance& tolerance) {
  if (!options.output.empty()) {
    if (fs::is_directory(options.output))
      fail(ExitCode::usage, "-o {} is a folder; two pictures need a file name", options.output);
    if (const std::string ending = lowerExtension(options.output); !ending.empty() && ending != ".png")
      fail(ExitCode::usage,
           "-o {}: the difference is a PNG picture; give it a name that ends in .png, not {}",
           options.output, ending);
    checkOutput(options.output, options.a, options.b);
  }
  const auto result = golden::comparePair({options.a, options.a, options.b}, termsFor(options, tolerance),
                                          options.output, true);
  if (options.json)
    printJson(pairJson(options.a, options.b, result));
  else if (verbosity() != Verbosity::quiet)
    printText(pairText(result, tolerance));
  if (result.outcome == Outcome::different) setExitCode(static_cast<int>(ExitCode::different));
}

golden::PairList findPairs(const DiffOptions& options, bool folders) {
  auto list =
      folders ? golden::pairFolders(options.a, options.b) : golden::pairPatterns(options.a, options.b);
  if (list.pairs.empty() && list.onlyA.empty() && list.onlyB.empty())
    fail(ExitCode::nothingRan, "neither {} nor {} has any pictures{}", options.a, options.b,
         list.passedOver.empty() ? "" : "; passed over: " + golden::someOf(list.passedOver));
  return list;
}

void compareSequences(const DiffOptions& options, const scene::Tolerance& tolerance, bool folders) {
  const fs::path folderA = folders ? fs::path(options.a) : fs::path(options.a).parent_path();
  const fs::path folderB = folders ? fs::path(options.b) : fs::path(options.b).parent_path();
  const auto list = findPairs(options, folders);
  if (!options.output.empty()) {
    makeFolders(options.output);
    checkOutput(options.output, folderA.empty() ? "." : folderA, folderB.empty() ? "." : folderB);
  }
  const bool text = !options.json && verbosity() != Verbosity::quiet;
  SequenceReport report;
  report.onlyA = list.onlyA;
  report.onlyB = list.onlyB;
  report.passedOver = list.passedOver;
  golden::comparePairs(list.pairs, termsFor(options, tolerance), options.output,
                       [&](const golden::Pair& pair, const golden::PairResult& result) {
                         report.add(pair, result);
                         if (text) printText(pairLine(pair, result));
                       });
  if (options.json)
    printJson(report.json(options.a, options.b));
  else if (text)
    printText(report.summary(options.a, options.b));
  if (const int unreadable = report.count(Outcome::unreadable); unreadable > 0) {
    std::fflush(stdout);
    fail(ExitCode::inputOutput, "{} of {} pairs could not be compared; the lines above say why", unreadable,
         list.pairs.size());
  }
  if (report.differs()) setExitCode(static_cast<int>(ExitCode::different));
}

void diff(const DiffOptions& options) {
  const scene::Tolerance tolerance = golden::strictTolerance(options.tolerance.given());
  if (options.quick && tolerance.maxFlipMean)
    fail(ExitCode::usage,
         "--max-flip-mean is a bound on FLIP, which --quick does not measure; give one of them");
  const auto kindOf = [](const std::string& name) -> std::string {
    std::error_code unknown;
    if (fs::is_directory(name, unknown)) return "a folder";
    return golden::isPattern(name) && !fs::exists(name, unknown) ? "a pattern" : "a picture";
  };
  const std::string kind = kindOf(options.a), other = kindOf(options.b);
  if (kind != other)
    fail(ExitCode::usage, "{} is {}, {} is {}; give two pictures, two folders or two patterns", options.a,
         kind, options.b, other);
  if (kind == "a picture")
    comparePictures(options, tolerance);
  else
    compareSequences(options, tolerance, kind == "a folder");
}

}  // namespace

void addDiff(CLI::App& app) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App* command = app.add_subcommand("diff", "Compare two pictures, or two sequences of them");
  command
      ->add_option("A", options->a,
                   "A picture, a folder with everything below it, or a pattern (####, %04d)")
      ->required();
  command->add_option("B", options->b, "The same kind of thing, which is compared with A")->required();
  command->add_option(
      "-o,--output", options->output,
      "File for the difference picture, blue (small) to red (large); a folder for sequences");
  options->tolerance.add(*command);
  options->allowance.add(*command);
  command->add_flag("--quick", options->quick, "Do not measure SSIM and FLIP, which take most of the time");
  command->add_flag("--json", options->json, "Print one JSON object instead of text");
  command->footer(
      "Without a bound, pictures must be equal. The window is 16 x 16 unless given. --max-channel-diff "
      "alone holds for every pixel. Every "
      "bound that is given must hold. Pictures are PNG (8 and 16 bits), JPEG, HDR, EXR and PNM; alpha "
      "counts. Files in only "
      "one of two folders differ; those that are no pictures are named.\n"
      "Exit code: 0 equal or within the bounds, 1 different, 2 usage, 6 a file cannot be read.");
  command->callback([options] { diff(*options); });
}

}  // namespace simreel::cli
