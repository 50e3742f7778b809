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

/// A picture as it goes to every viewer: a line of JSON that describes it, "\n", and the file's bytes.
struct Picture {
  std::uint64_t number = 0;  ///< ascending
  std::string message;
};

/// What a viewer asks for.
struct Request {
  std::uint64_t viewer = 0;
  std::string text;  ///< JSON
};

/// Where the thread that makes pictures and the one that talks to viewers meet. Nothing here grows with
/// what a viewer leaves unread: of each kind of message there is the latest alone, and of pictures, too.
class Hub {
 public:
  /// Called from any thread where there is news for viewers.
  void onNews(std::function<void()> wake);

  // Of the thread that makes pictures.

  /// Requests in the order in which they came; waits that long (s) for one.
  [[nodiscard]] std::deque<Request> take(double seconds);
  /// For all viewers, those that come later too: the latest message of its kind.
  void tell(const std::string& kind, std::string text);
  /// For one.
  void answer(std::uint64_t viewer, std::string text);
  void show(Picture picture);
  /// A file for who asks for it by name, in place of that of before.
  void offer(const std::string& name, std::string bytes);
  [[nodiscard]] std::size_t viewers() const;
  /// Who may change things; 0: nobody is there.
  [[nodiscard]] std::uint64_t editor() const;
  [[nodiscard]] bool stopping() const;

  // Of the one that talks to viewers.

  std::uint64_t enter();
  void leave(std::uint64_t viewer);
  /// Makes this viewer the editor.
  void makeEditor(std::uint64_t viewer);
  /// False where too many wait.
  bool ask(Request request);
  struct Message {
    std::uint64_t version = 0;
    std::shared_ptr<const std::string> text;
  };
  /// The oldest message that this viewer, who has seen those up to `version`, has not.
  [[nodiscard]] std::optional<Message> messageAfter(std::uint64_t version) const;
  [[nodiscard]] std::optional<std::string> answerFor(std::uint64_t viewer);
  [[nodiscard]] std::shared_ptr<const Picture> picture() const;
  /// Null: none is offered.
  [[nodiscard]] std::shared_ptr<const std::string> offered(const std::string& name) const;
  /// From either: ends both.
  void stop();

 private:
  static constexpr std::size_t mostRequests = 4096, mostAnswers = 16;

  void wake() const;
  void tellViewers();

  mutable std::mutex mutex_;
  std::condition_variable asked_;
  std::function<void()> wake_;
  std::deque<Request> requests_;
  std::map<std::string, Message> messages_;  ///< by kind
  std::uint64_t version_ = 0;
  std::map<std::uint64_t, std::deque<std::string>> answers_;  ///< of each viewer that is there
  std::uint64_t nextViewer_ = 1, editor_ = 0;
  std::shared_ptr<const Picture> picture_;
  std::map<std::string, std::shared_ptr<const std::string>> offers_;
  bool stop_ = false;
};

}  // namespace simreel::serve
