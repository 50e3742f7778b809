#include "batch/slurm/queue.hpp"

#include "base/file.hpp"
#include "base/log.hpp"
#include "batch/slurm/ask.hpp"

#include <charconv>
#include <optional>
#include <sstream>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;

fs::path listFile(const fs::path& folder) {
  return folder / "submitted.txt";
}

std::vector<Submitted> submittedFrom(const fs::path& folder) {
  std::vector<Submitted> all;
  if (!pathExists(listFile(folder))) return all;
  std::istringstream lines(readFile(listFile(folder), "list"));
  for (Submitted job; lines >> job.work >> job.id >> job.offset;) all.push_back(job);
  return all;
}

std::optional<std::size_t> taskOf(std::string_view text) {
  std::size_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

void noteSubmitted(const fs::path& folder, const Submitted& job) {
  const fs::path file = listFile(folder);
  const std::string before = pathExists(file) ? readFile(file, "list") : std::string();
  writeFileAtomically(file, before + fmt::format("{} {} {}\n", job.work, job.id, job.offset));
}

SlurmQueue::SlurmQueue(const fs::path& folder) {
  const auto submitted = folder.empty() ? std::vector<Submitted>() : submittedFrom(folder);
  if (submitted.empty()) return;
  // The query is by user, because squeue fails for an id that Slurm has forgotten. --array prints one line
  // per array item.
  const Answer answer =
      ask({"squeue", "--noheader", "--array", fmt::format("--user={}", ::getuid()), "--format=%i"});
  if (!answer.fine())
    warn("squeue failed ({}); jobs that the cluster still has count as missing", answer.why());
  std::istringstream lines(answer.output);
  for (std::string line; lines >> line;) {
    const std::size_t bar = line.find('_');
    const std::optional<std::size_t> task =
        bar == std::string::npos ? 0 : taskOf(std::string_view(line).substr(bar + 1));
    for (const Submitted& job : submitted)
      if (task && job.id == line.substr(0, bar)) numbers_[job.work].insert(*task + job.offset);
  }
}

bool SlurmQueue::has(const std::string& work, std::size_t number) const {
  const auto found = numbers_.find(work);
  return found != numbers_.end() && found->second.contains(number);
}

}  // namespace simreel::batch
