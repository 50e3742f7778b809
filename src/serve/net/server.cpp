#include "serve/net/server.hpp"

#include "base/error.hpp"
#include "base/log.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <deque>
#include <exception>
#include <libwebsockets.h>
#include <new>
#include <optional>
#include <set>
#include <sys/socket.h>
#include <thread>
#include <utility>
#include <vector>

namespace simreel::serve {

namespace {

constexpr std::size_t pieceBytes = std::size_t{32} << 10;  ///< max number of bytes of one write to a socket
/// Maximum number of connections whose headers are read at the same time.
constexpr unsigned short headerRooms = 64;
constexpr std::size_t maxStrangers = 32;
/// Maximum number of sent pictures that a viewer has not confirmed as shown.
constexpr int picturesUnderWay = 2;

/// State of one connection. The callbacks of libwebsockets create and delete it.
struct Connection {
  std::uint64_t viewer = 0;  ///< number of the viewer; 0 for a plain HTTP connection
  std::shared_ptr<const std::string> body;
  std::size_t sent = 0;
  // Only connections of viewers use the following members.
  bool binary = false;
  std::shared_ptr<const Picture> picture;    ///< picture whose message is in `body`
  std::uint64_t heard = 0;                   ///< version of the latest message that was sent
  std::uint64_t shown = 0, sentPicture = 0;  ///< number of the latest picture that the viewer has shown,
                                             ///< and of the latest that was sent
  std::deque<std::uint64_t> underWay;
  std::string asked;  ///< received parts of an incomplete message
  bool tooLong = false;
};

/// Memory that libwebsockets provides for each connection.
struct Slot {
  Connection* connection;
};

std::string headerText(lws* wsi, lws_token_indexes header) {
  const int length = lws_hdr_total_length(wsi, header);
  if (length <= 0) return {};
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  const int copied = lws_hdr_copy(wsi, text.data(), length + 1, header);
  text.resize(static_cast<std::size_t>(std::max(copied, 0)));
  return text;
}

constexpr const char* policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'";

constexpr std::array<std::pair<const char*, const char*>, 6> safeHeaders = {{
    {"content-security-policy:", policy},
    {"x-content-type-options:", "nosniff"},
    {"referrer-policy:", "no-referrer"},
    {"cross-origin-resource-policy:", "same-origin"},
    {"cross-origin-opener-policy:", "same-origin"},
    {"cache-control:", "no-store"},
}};

/// Headers by which browsers do not show the page in a frame. A second content-security-policy header
/// restricts the first.
constexpr std::array<std::pair<const char*, const char*>, 2> unframedHeaders = {{
    {"content-security-policy:", "frame-ancestors 'none'"},
    {"x-frame-options:", "DENY"},
}};

}  // namespace

struct Server::State {
  Options options;
  const Guard& guard;
  Hub& hub;
  lws_context* context = nullptr;
  lws_vhost* host = nullptr;
  std::thread thread;
  std::atomic<bool> stop{false};
  std::set<lws*> viewers;
  std::deque<lws*> strangers;  ///< connections that have not sent the token, oldest first
  int connections = 0;
  std::vector<unsigned char> scratch;

  State(Options wanted, const Guard& checks, Hub& news)
      : options(std::move(wanted)), guard(checks), hub(news), scratch(LWS_PRE + pieceBytes) {}

  void listen();
  int handle(lws* wsi, lws_callback_reasons reason, Slot* slot, void* in, std::size_t length);
  int answer(lws* wsi, Connection& to, std::string_view path);
  int refuse(lws* wsi, Connection& to, int status, const char* text);
  int begin(lws* wsi, Connection& to, int status, const char* type,
            std::shared_ptr<const std::string> body) const;
  int sendBody(lws* wsi, Connection& to);
  [[nodiscard]] bool admits(lws* wsi) const;
  int receive(lws* wsi, Connection& from, const char* in, std::size_t length);
  void welcome(lws* wsi);
  void know(lws* wsi);
  int say(lws* wsi, Connection& from);
  bool next(Connection& to);
  int sendPiece(lws* wsi, Connection& to);
};

namespace {

int callback(lws* wsi, lws_callback_reasons reason, void* user, void* in, std::size_t length) {
  auto* state = static_cast<Server::State*>(lws_context_user(lws_get_context(wsi)));
  // No exception may pass through libwebsockets, which is written in C. On an exception, this connection
  // ends and the others continue.
  try {
    return state->handle(wsi, reason, static_cast<Slot*>(user), in, length);
  } catch (...) {
    return -1;
  }
}

void libraryLog(int /*level*/, const char* line) {
  std::string text(line);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  detail("simreel: web server: {}", text);
}

constexpr std::uint16_t secondsToPing = 20, secondsToHangUp = 45;

const lws_retry_bo_t liveness = {nullptr, 0, 0, secondsToPing, secondsToHangUp, 0};

const lws_protocols protocols[] = {
    {"http", callback, sizeof(Slot), 4096, 0, nullptr, 0},
    {"simreel", callback, sizeof(Slot), 4096, 0, nullptr, 0},
    {nullptr, nullptr, 0, 0, 0, nullptr, 0},
};

}  // namespace

void Server::State::listen() {
  lws_set_log_level(LLL_ERR | LLL_WARN, libraryLog);
  lws_context_creation_info info{};
  info.port = options.port;
  info.iface = options.address == "0.0.0.0" ? nullptr : options.address.c_str();
  info.protocols = protocols;
  info.user = this;
  info.gid = static_cast<decltype(info.gid)>(-1);
  info.uid = static_cast<decltype(info.uid)>(-1);
  info.options = LWS_SERVER_OPTION_DISABLE_IPV6 | LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND;
  info.fd_limit_per_thread = maxConnections + 100;
  info.timeout_secs = 10;
  info.keepalive_timeout = 5;
  info.retry_and_idle_policy = &liveness;
  info.server_string = "simreel";
  info.vhost_name = "simreel";
  info.max_http_header_data = 4096;
  info.max_http_header_pool = headerRooms;
  errno = 0;
  context = lws_create_context(&info);
  if (context != nullptr) host = lws_get_vhost_by_name(context, info.vhost_name);
  const int cause = errno;
  if (host == nullptr || lws_get_vhost_listen_port(host) <= 0) {
    if (context != nullptr) lws_context_destroy(context);
    context = nullptr;
    fail(ExitCode::inputOutput, "cannot listen at {}:{}{}{}; choose another port with --port, or 0 for any",
         options.address, options.port, cause != 0 ? ": " : "", cause != 0 ? std::strerror(cause) : "");
  }
}

int Server::State::handle(lws* wsi, lws_callback_reasons reason, Slot* slot, void* in, std::size_t length) {
  switch (reason) {
    case LWS_CALLBACK_FILTER_NETWORK_CONNECTION:
      return connections >= maxConnections ? 1 : 0;
    case LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED:
      ++connections;
      welcome(wsi);
      return 0;
    case LWS_CALLBACK_WSI_DESTROY:
      if (connections > 0) --connections;
      know(wsi);
      return 0;
    case LWS_CALLBACK_HTTP:
      if (slot->connection == nullptr) slot->connection = new Connection();
      return answer(wsi, *slot->connection, {static_cast<const char*>(in), length});
    case LWS_CALLBACK_HTTP_WRITEABLE:
      return slot == nullptr || slot->connection == nullptr ? 0 : sendBody(wsi, *slot->connection);
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
      return admits(wsi) ? 0 : -1;
    case LWS_CALLBACK_ESTABLISHED:
      know(wsi);
      slot->connection = new Connection();
      slot->connection->viewer = hub.enter();
      viewers.insert(wsi);
      lws_callback_on_writable(wsi);
      return 0;
    case LWS_CALLBACK_RECEIVE:
      return receive(wsi, *slot->connection, static_cast<const char*>(in), length);
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return sendPiece(wsi, *slot->connection);
    case LWS_CALLBACK_CLOSED:
      viewers.erase(wsi);
      if (slot->connection != nullptr) hub.leave(slot->connection->viewer);
      delete std::exchange(slot->connection, nullptr);
      return 0;
    case LWS_CALLBACK_CLOSED_HTTP:
    case LWS_CALLBACK_HTTP_DROP_PROTOCOL:
      if (slot != nullptr) delete std::exchange(slot->connection, nullptr);
      return 0;
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
      for (lws* viewer : viewers) lws_callback_on_writable(viewer);
      return 0;
    default:
      return 0;
  }
}

/// Adds a connection that has not sent the token. Each such connection occupies memory for its headers. If
/// there are too many, closes the oldest one, so that a viewer with the token never has to wait.
void Server::State::welcome(lws* wsi) {
  strangers.push_back(wsi);
  if (strangers.size() <= maxStrangers) return;
  // A timeout of libwebsockets would restart with each received byte.
  ::shutdown(lws_get_socket_fd(strangers.front()), SHUT_RDWR);
  strangers.pop_front();
}

void Server::State::know(lws* wsi) {
  strangers.erase(std::remove(strangers.begin(), strangers.end(), wsi), strangers.end());
}

int Server::State::refuse(lws* wsi, Connection& to, int status, const char* text) {
  return begin(wsi, to, status, "text/plain; charset=utf-8", std::make_shared<const std::string>(text));
}

int Server::State::answer(lws* wsi, Connection& to, std::string_view path) {
  if (!guard.allowsHost(headerText(wsi, WSI_TOKEN_HOST)))
    return refuse(wsi, to, 403, "simreel: this address is not this machine's\n");
  if (lws_hdr_total_length(wsi, WSI_TOKEN_GET_URI) <= 0) return refuse(wsi, to, 405, "simreel: only GET\n");
  std::string_view name;
  if (!guard.splitPath(path, name))
    return refuse(wsi, to, 403, "simreel: open the whole address that `simreel serve` has printed\n");
  know(wsi);
  const std::unique_ptr<Content> found = options.find(name.empty() ? "index.html" : name);
  if (!found) return refuse(wsi, to, 404, "simreel: there is nothing of this name\n");
  return begin(wsi, to, 200, found->type.c_str(), found->bytes);
}

int Server::State::begin(lws* wsi, Connection& to, int status, const char* type,
                         std::shared_ptr<const std::string> body) const {
  std::array<unsigned char, LWS_PRE + 2048> buffer{};
  unsigned char* const start = buffer.data() + LWS_PRE;
  unsigned char* at = start;
  unsigned char* const end = buffer.data() + buffer.size() - 1;
  if (lws_add_http_common_headers(wsi, static_cast<unsigned>(status), type, body->size(), &at, end) != 0)
    return 1;
  const auto add = [&](const char* header, const char* value) {
    return lws_add_http_header_by_name(wsi, reinterpret_cast<const unsigned char*>(header),
                                       reinterpret_cast<const unsigned char*>(value),
                                       static_cast<int>(std::strlen(value)), &at, end) == 0;
  };
  for (const auto& [header, value] : safeHeaders)
    if (!add(header, value)) return 1;
  for (const auto& [header, value] : unframedHeaders)
    if (!options.embed && !add(header, value)) return 1;
  if (lws_finalize_write_http_header(wsi, start, &at, end) != 0) return 1;
  to.body = std::move(body);
  to.sent = 0;
  lws_callback_on_writable(wsi);
  return 0;
}

int Server::State::sendBody(lws* wsi, Connection& to) {
  if (!to.body) return 0;
  const std::size_t piece = std::min(pieceBytes, to.body->size() - to.sent);
  const bool last = to.sent + piece == to.body->size();
  std::memcpy(scratch.data() + LWS_PRE, to.body->data() + to.sent, piece);
  if (lws_write(wsi, scratch.data() + LWS_PRE, piece, last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) <
      static_cast<int>(piece))
    return -1;
  to.sent += piece;
  if (!last) {
    lws_callback_on_writable(wsi);
    return 0;
  }
  to.body = nullptr;
  return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
}

bool Server::State::admits(lws* wsi) const {
  const std::string hostName = headerText(wsi, WSI_TOKEN_HOST);
  const std::string origin = headerText(wsi, WSI_TOKEN_ORIGIN);
  const std::string path = headerText(wsi, WSI_TOKEN_GET_URI);
  std::string_view name;
  return guard.allowsHost(hostName) && Guard::allowsOrigin(origin, hostName) &&
         guard.splitPath(path, name) && name == "live" &&
         viewers.size() < static_cast<std::size_t>(maxViewers);
}

int Server::State::receive(lws* wsi, Connection& from, const char* in, std::size_t length) {
  if (from.asked.size() + length > maxBytesAsked || lws_frame_is_binary(wsi) != 0) {
    lws_close_reason(wsi,
                     from.asked.size() + length > maxBytesAsked ? LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE
                                                                : LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE,
                     nullptr, 0);
    return -1;
  }
  from.asked.append(in, length);
  if (lws_remaining_packet_payload(wsi) > 0 || lws_is_final_fragment(wsi) == 0) return 0;
  return say(wsi, from);
}

/// Handles a complete message from a viewer. Handles messages that concern only this connection, and passes
/// all others to the thread that makes pictures.
int Server::State::say(lws* wsi, Connection& from) {
  std::string text = std::exchange(from.asked, {});
  constexpr std::string_view confirmation = "shown ";
  if (std::string_view(text).starts_with(confirmation)) {
    const std::uint64_t number = std::strtoull(text.c_str() + confirmation.size(), nullptr, 10);
    while (!from.underWay.empty() && from.underWay.front() <= number) from.underWay.pop_front();
    lws_callback_on_writable(wsi);
    return 0;
  }
  if (text == "edit") {
    hub.makeEditor(from.viewer);
    return 0;
  }
  if (hub.ask({from.viewer, std::move(text)})) return 0;
  lws_close_reason(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, nullptr, 0);
  return -1;
}

/// Chooses the data to send to a viewer next. Answers and messages come before pictures. Returns false if
/// there is nothing to send.
bool Server::State::next(Connection& to) {
  to.sent = 0;
  to.binary = false;
  to.picture = nullptr;
  if (std::optional<std::string> mine = hub.answerFor(to.viewer)) {
    to.body = std::make_shared<const std::string>(*std::move(mine));
    return true;
  }
  if (const auto message = hub.messageAfter(to.heard)) {
    to.heard = message->version;
    to.body = message->text;
    return true;
  }
  // No further picture is sent until the viewer has shown enough earlier ones. Only the latest picture is
  // stored, once for all viewers.
  const std::shared_ptr<const Picture> latest = hub.picture();
  if (!latest || latest->number == to.sentPicture || to.underWay.size() >= picturesUnderWay) return false;
  to.picture = latest;
  to.body = std::shared_ptr<const std::string>(latest, &latest->message);
  to.binary = true;
  to.sentPicture = latest->number;
  to.underWay.push_back(latest->number);
  return true;
}

int Server::State::sendPiece(lws* wsi, Connection& to) {
  if (!to.body && !next(to)) return 0;
  const std::size_t piece = std::min(pieceBytes, to.body->size() - to.sent);
  const bool first = to.sent == 0;
  const bool last = to.sent + piece == to.body->size();
  std::memcpy(scratch.data() + LWS_PRE, to.body->data() + to.sent, piece);
  const int how = lws_write_ws_flags(to.binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT, first, last);
  if (lws_write(wsi, scratch.data() + LWS_PRE, piece, static_cast<lws_write_protocol>(how)) <
      static_cast<int>(piece))
    return -1;
  to.sent += piece;
  if (last) to.body = nullptr;
  lws_callback_on_writable(wsi);
  return 0;
}

Server::Server(Options options, const Guard& guard, Hub& hub)
    : state_(std::make_unique<State>(std::move(options), guard, hub)) {
  State& s = *state_;
  s.listen();
  hub.onNews([context = s.context] { lws_cancel_service(context); });
  s.thread = std::thread([&s] {
    while (!s.stop)
      if (lws_service(s.context, 0) < 0) break;
  });
}

Server::~Server() {
  State& s = *state_;
  s.hub.stop();
  s.stop = true;
  lws_cancel_service(s.context);
  s.thread.join();
  s.hub.onNews({});
  lws_context_destroy(s.context);
}

int Server::port() const {
  return lws_get_vhost_listen_port(state_->host);
}

}  // namespace simreel::serve
