#include "batch/slurm/ask.hpp"

#include "base/file.hpp"
#include "base/process.hpp"

#include <cerrno>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

namespace simreel::batch {

std::string Answer::why() const {
  return error != 0 ? std::strerror(error) : firstLine(messages);
}

Answer ask(const std::vector<std::string>& words) {
  Answer answer;
  const int output = makeMemoryFile("simreel-output"), messages = makeMemoryFile("simreel-messages");
  pid_t child = -1;
  answer.error = output < 0 || messages < 0
                     ? errno
                     : startProcess(words, {.input = -1, .output = output, .messages = messages}, child);
  if (answer.error == 0) {
    while (::waitpid(child, &answer.status, 0) < 0 && errno == EINTR) {
    }
    childEnded(child);
    answer.output = endOfMemoryFile(output);
    answer.messages = endOfMemoryFile(messages);
  }
  for (const int descriptor : {output, messages})
    if (descriptor >= 0) ::close(descriptor);
  return answer;
}

}  // namespace simreel::batch
