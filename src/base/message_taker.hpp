#pragma once
#include <functional>
#include <string>

namespace simreel {

/// Receives the level ("error", "warning", "info", "detail") and the text of a message.
using MessageTaker = std::function<void(const char* level, const std::string& text)>;

/// From this call on, messages go to the function `newTaker` instead of standard error. An empty function
/// restores standard error. The function is called on any thread, one message at a time, and must not write
/// messages itself.
void setMessageTaker(MessageTaker newTaker);

}  // namespace simreel
