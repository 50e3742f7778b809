#pragma once
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace simreel::serve {

/// Picture in the form that is sent to all viewers. It consists of a line of JSON that describes it, a
/// newline, and the bytes of the image files.
struct Picture {
  std::uint64_t number = 0;  ///< number of the picture, ascending
  std::string message;
};

/// Request of a viewer.
struct Request {
  std::uint64_t viewer = 0;
  std::string text;  ///< the request as JSON
};

/// Connects the thread that makes pictures with the thread that talks to viewers. It stores only the latest
/// message of each kind and the latest picture, so slow viewers do not make it grow.
class Hub {
 public:
  /// Sets the function that is called, on any thread, when there is something new to send to viewers.
  void onNews(std::function<void()> wake);

  // The following functions are for the thread that makes pictures.

  /// Returns the pending requests in their order. Waits up to `seconds` for the first one.
  [[nodiscard]] std::deque<Request> waitForRequests(double seconds);
  /// Sets the latest message of a kind. It is sent to all viewers, including those that connect later.
  void tell(const std::string& kind, std::string text);
  /// Sends a message to one viewer.
  void answer(std::uint64_t viewer, std::string text);
  void publish(Picture picture);
  /// Offers a file for download under a name. Replaces an earlier file with this name.
  void offer(const std::string& name, std::string bytes);
  [[nodiscard]] std::size_t viewers() const;
  /// Returns the viewer that may change the scene; 0 if there are no viewers.
  [[nodiscard]] std::uint64_t editor() const;
  [[nodiscard]] bool stopping() const;

  // The following functions are for the thread that talks to viewers.

  std::uint64_t enter();
  void leave(std::uint64_t viewer);
  /// Makes this viewer the editor, the only viewer that may change the scene.
  void makeEditor(std::uint64_t viewer);
  /// Adds a request. Returns false if too many requests are pending.
  bool ask(Request request);
  struct Message {
    std::uint64_t version = 0;
    std::shared_ptr<const std::string> text;
  };
  /// Returns the oldest message that is newer than `version`, the version of the last message sent to a
  /// viewer. Returns nullopt if there is no newer message.
  [[nodiscard]] std::optional<Message> messageAfter(std::uint64_t version) const;
  [[nodiscard]] std::optional<std::string> answerFor(std::uint64_t viewer);
  [[nodiscard]] std::shared_ptr<const Picture> picture() const;
  /// Returns the file offered under a name. Returns null if the name is unknown.
  [[nodiscard]] std::shared_ptr<const std::string> offered(const std::string& name) const;
  /// Stops both threads. Either thread may call it.
  void stop();

 private:
  static constexpr std::size_t maxRequests = 4096, maxAnswers = 16;

  void wake() const;
  void tellViewers();

  mutable std::mutex mutex_;
  std::condition_variable asked_;
  std::function<void()> wake_;
  std::deque<Request> requests_;
  std::map<std::string, Message> messages_;  ///< latest message by kind
  std::uint64_t version_ = 0;
  std::map<std::uint64_t, std::deque<std::string>> answers_;  ///< answers that have not been sent yet, by
                                                              ///< connected viewer
  std::uint64_t nextViewer_ = 1, editor_ = 0;
  std::shared_ptr<const Picture> picture_;
  std::map<std::string, std::shared_ptr<const std::string>> offers_;
  bool stop_ = false;
};

}  // namespace simreel::serve
