#include "batch/slurm/slurm.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "batch/slurm/ask.hpp"
#include "batch/slurm/queue.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;

/// Returns the number after "MaxArraySize = ", or Slurm's default if there is none.
std::size_t maxArraySizeOf(const std::string& config) {
  constexpr std::size_t standard = 1001;
  const std::size_t at = config.find("MaxArraySize");
  if (at == std::string::npos) return standard;
  const std::size_t digit = config.find_first_of("0123456789\n", at);
  std::size_t size = 0;
  const auto read =
      std::from_chars(config.data() + std::min(digit, config.size()), config.data() + config.size(), size);
  return read.ec == std::errc() && size > 1 ? size : standard;
}

fs::path ownProgram() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

}  // namespace

std::vector<std::string> shellWords(const std::string& text) {
  std::vector<std::string> words;
  std::optional<std::string> word;
  char quote = 0;
  const auto add = [&](char c) {
    if (!word) word.emplace();
    *word += c;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
      if (!word) word.emplace();  // A pair of quotes without content is an empty word.
    } else if (quote == 0 && c == '\\' && i + 1 < text.size()) {
      add(text[++i]);
    } else if (quote != 0 || !blank) {
      add(c);
    } else if (word) {
      words.push_back(*std::exchange(word, std::nullopt));
    }
  }
  if (quote != 0) fail(ExitCode::usage, "--sbatch {}: a {} is not closed", text, quote);
  if (word) words.push_back(*word);
  return words;
}

std::string arrayText(const std::vector<std::size_t>& numbers, std::size_t offset) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i] - offset);
    if (last > i) text += fmt::format("-{}", numbers[last] - offset);
    i = last + 1;
  }
  return text;
}

std::vector<std::vector<std::size_t>> splitArray(const std::vector<std::size_t>& numbers,
                                                 std::size_t maxSize) {
  constexpr std::size_t maxParts = 10'000;  // Each number takes up to six digits and a comma.
  std::vector<std::vector<std::size_t>> parts;
  for (const std::size_t number : numbers) {
    if (parts.empty() || number - parts.back().front() >= maxSize || parts.back().size() >= maxParts)
      parts.emplace_back();
    parts.back().push_back(number);
  }
  return parts;
}

Slurm::Slurm(const fs::path& folder, std::vector<std::string> more)
    : folder_(fs::absolute(folder).lexically_normal()), more_(std::move(more)) {
  const Answer config = ask({"scontrol", "show", "config"});
  if (config.error == ENOENT)
    fail(ExitCode::usage,
         "--slurm: there is no scontrol here; use it on a machine that submits to a Slurm cluster, or run "
         "the plan in another way (--plan-only)");
  if (!config.fine()) fail(ExitCode::inputOutput, "--slurm: the cluster does not answer: {}", config.why());
  maxArraySize_ = maxArraySizeOf(config.output);
}

std::vector<std::string> Slurm::submit(const Work& work) {
  makeFolders(folder_);
  if (work.numbers.empty()) return {submitOne(work, "", 0, 0)};
  std::vector<std::string> ids;
  for (const auto& part : splitArray(work.numbers, maxArraySize_)) {
    const std::size_t offset = part.back() < maxArraySize_ ? 0 : part.front();
    ids.push_back(submitOne(work, arrayText(part, offset), offset, ids.size()));
  }
  return ids;
}

std::string Slurm::submitOne(const Work& work, const std::string& array, std::size_t offset,
                             std::size_t part) {
  std::string line = "exec " + inShellQuotes(ownProgram().string());
  for (const std::string& word : work.arguments) line += " " + inShellQuotes(word);
  if (!array.empty()) line += fmt::format(" \"$((SLURM_ARRAY_TASK_ID + {}))\"", offset);
  const fs::path script =
      folder_ / fmt::format("{}{}.sh", work.name, part == 0 ? "" : fmt::format(".{}", part));
  writeFileAtomically(
      script, "#!/bin/sh\n# exec replaces the shell, so that signals from Slurm reach the program.\n" +
                  line + "\n");
  std::vector<std::string> words = {
      "sbatch",
      "--parsable",
      "--job-name=simreel-" + work.name,
      "--requeue",
      "--open-mode=append",
      "--output=" + (folder_ / (work.name + (array.empty() ? ".%j.log" : ".%A_%a.log"))).string()};
  if (!array.empty()) words.push_back("--array=" + array);
  if (!work.after.empty()) {
    std::string after = work.afterAnyResult ? "--dependency=afterany" : "--dependency=afterok";
    for (const std::string& id : work.after) after += ":" + id;
    words.insert(words.end(), {after, "--kill-on-invalid-dep=yes"});
  }
  words.insert(words.end(), more_.begin(), more_.end());
  words.push_back(script.string());
  const Answer answer = ask(words);
  if (!answer.fine()) fail(ExitCode::inputOutput, "sbatch rejected {}: {}", script.string(), answer.why());
  std::string id = firstLine(answer.output);
  id.resize(std::min(id.size(), id.find(';')));  // A ';' and the cluster's name may follow the id.
  noteSubmitted(folder_, {work.name, id, offset});
  return id;
}

}  // namespace simreel::batch
