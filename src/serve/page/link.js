// Connection to `simreel serve`. Sends requests at the rate at which pictures arrive.

export class Link {
  constructor(on) {
    this.on = on;
    this.ready = false;
    this.waiting = new Map(); // latest unsent request of each kind, during a drag
    this.sentAt = 0;
    this.open();
  }

  open() {
    const address = new URL("live", location.href);
    address.protocol = "ws:";
    this.socket = new WebSocket(address, "simreel");
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => { this.ready = true; this.on.open?.(); };
    this.socket.onmessage = (event) => this.hear(event.data);
    this.socket.onclose = (event) => {
      this.ready = false;
      this.on.closed?.(event);
      setTimeout(() => this.open(), 1000);
    };
  }

  hear(data) {
    if (typeof data === "string") {
      const message = JSON.parse(data);
      this.on[message.kind]?.(message);
      return;
    }
    const bytes = new Uint8Array(data);
    const end = bytes.indexOf(10);
    const about = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)));
    const files = [];
    let at = end + 1;
    for (const size of about.files ?? [bytes.length - at]) {
      files.push(new Blob([bytes.subarray(at, at + size)], { type: about.type }));
      at += size;
    }
    this.on.picture?.(about, files);
  }

  // Confirms that a picture is on the screen, so that the server can send the next one. Then sends the waiting
  // requests.
  shown(number) {
    if (this.ready) this.socket.send(`shown ${number}`);
    this.sentAt = 0;
    this.flush();
  }

  send(request) {
    if (this.ready) this.socket.send(JSON.stringify(request));
  }

  takeOver() {
    if (this.ready) this.socket.send("edit");
  }

  // Queues a request during a drag. Waiting requests are sent after the next picture, or after a tenth of a second.
  move(kind, request) {
    this.waiting.set(kind, { ...request, moving: true });
    this.flush();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.flush(), 120);
  }

  // Sends the final request at the end of a drag.
  settle(kind, request) {
    this.waiting.delete(kind);
    this.send({ ...request, moving: false });
  }

  flush() {
    if (performance.now() - this.sentAt < 100 || this.waiting.size === 0) return;
    for (const request of this.waiting.values()) this.send(request);
    this.waiting.clear();
    this.sentAt = performance.now();
  }
}
