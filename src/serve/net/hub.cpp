#include "serve/net/hub.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace simreel::serve {

void Hub::onNews(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

void Hub::wake() const {
  if (wake_) wake_();
}

std::deque<Request> Hub::waitForRequests(double seconds) {
  std::unique_lock lock(mutex_);
  if (seconds > 0)
    asked_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [&] { return stop_ || !requests_.empty(); });
  return std::exchange(requests_, {});
}

void Hub::tell(const std::string& kind, std::string text) {
  const std::lock_guard lock(mutex_);
  Message& message = messages_[kind];
  if (message.text && *message.text == text) return;
  message = {++version_, std::make_shared<const std::string>(std::move(text))};
  wake();
}

void Hub::answer(std::uint64_t viewer, std::string text) {
  const std::lock_guard lock(mutex_);
  const auto found = answers_.find(viewer);
  if (found == answers_.end()) return;
  if (found->second.size() >= maxAnswers) found->second.pop_front();
  found->second.push_back(std::move(text));
  wake();
}

void Hub::publish(Picture picture) {
  const std::lock_guard lock(mutex_);
  picture_ = std::make_shared<const Picture>(std::move(picture));
  wake();
}

void Hub::offer(const std::string& name, std::string bytes) {
  const std::lock_guard lock(mutex_);
  offers_[name] = std::make_shared<const std::string>(std::move(bytes));
}

std::shared_ptr<const std::string> Hub::offered(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = offers_.find(name);
  return found == offers_.end() ? nullptr : found->second;
}

std::size_t Hub::viewers() const {
  const std::lock_guard lock(mutex_);
  return answers_.size();
}

std::uint64_t Hub::editor() const {
  const std::lock_guard lock(mutex_);
  return editor_;
}

bool Hub::stopping() const {
  const std::lock_guard lock(mutex_);
  return stop_;
}

/// Tells all viewers how many viewers there are and which one edits. The caller must hold the lock.
void Hub::tellViewers() {
  messages_["viewers"] = {
      ++version_, std::make_shared<const std::string>(fmt::format(
                      "{{\"kind\":\"viewers\",\"count\":{},\"editor\":{}}}", answers_.size(), editor_))};
  asked_.notify_all();
  wake();
}

std::uint64_t Hub::enter() {
  const std::lock_guard lock(mutex_);
  const std::uint64_t viewer = nextViewer_++;
  answers_[viewer].push_back(fmt::format("{{\"kind\":\"you\",\"viewer\":{}}}", viewer));
  if (editor_ == 0) editor_ = viewer;
  tellViewers();
  return viewer;
}

void Hub::leave(std::uint64_t viewer) {
  const std::lock_guard lock(mutex_);
  answers_.erase(viewer);
  // The viewer that has been connected longest becomes the editor.
  if (editor_ == viewer) editor_ = answers_.empty() ? 0 : answers_.begin()->first;
  tellViewers();
}

void Hub::makeEditor(std::uint64_t viewer) {
  const std::lock_guard lock(mutex_);
  if (!answers_.contains(viewer)) return;
  editor_ = viewer;
  tellViewers();
}

bool Hub::ask(Request request) {
  const std::lock_guard lock(mutex_);
  if (requests_.size() >= maxRequests) return false;
  requests_.push_back(std::move(request));
  asked_.notify_all();
  return true;
}

std::optional<Hub::Message> Hub::messageAfter(std::uint64_t version) const {
  const std::lock_guard lock(mutex_);
  const Message* oldest = nullptr;
  for (const auto& [kind, message] : messages_)
    if (message.version > version && (oldest == nullptr || message.version < oldest->version))
      oldest = &message;
  if (oldest == nullptr) return std::nullopt;
  return *oldest;
}

std::optional<std::string> Hub::answerFor(std::uint64_t viewer) {
  const std::lock_guard lock(mutex_);
  const auto found = answers_.find(viewer);
  if (found == answers_.end() || found->second.empty()) return std::nullopt;
  std::string text = std::move(found->second.front());
  found->second.pop_front();
  return text;
}

std::shared_ptr<const Picture> Hub::picture() const {
  const std::lock_guard lock(mutex_);
  return picture_;
}

void Hub::stop() {
  const std::lock_guard lock(mutex_);
  stop_ = true;
  asked_.notify_all();
  wake();
}

}  // namespace simreel::serve
