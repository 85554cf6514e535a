// A headless Chromium for tests, driven by the DevTools protocol through a pipe, and a server of a folder on loopback.
import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";

/// Media types by extension.
export const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".jpg": "image/jpeg",
};

/// Serves a folder to this machine alone; returns its address and a function that ends it.
export async function serve(folder) {
  const server = createServer((request, response) => {
    const name = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname)).replace(
      /\/$/,
      "/index.html",
    );
    try {
      const bytes = readFileSync(join(folder, name));
      response.writeHead(200, { "Content-Type": types[extname(name)] ?? "application/octet-stream" }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export class Browser {
  static start(program) {
    const profile = mkdtempSync(join(tmpdir(), "raypro-chromium-"));
    const process = spawn(
      program,
      [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--remote-debugging-pipe",
        "--user-data-dir=" + profile,
        "about:blank",
      ],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
    );
    return new Browser(process, profile);
  }

  constructor(process, profile) {
    Object.assign(this, { process, profile, calls: new Map(), last: 0, errors: [] });
    let rest = "";
    process.stdio[4].on("data", (data) => {
      const messages = (rest + data).split("\0");
      rest = messages.pop();
      for (const message of messages) this.take(JSON.parse(message));
    });
  }

  take(message) {
    if (message.method === "Runtime.exceptionThrown")
      this.errors.push(message.params.exceptionDetails.exception?.description);
    const call = this.calls.get(message.id);
    if (!call) return;
    this.calls.delete(message.id);
    message.error ? call.reject(new Error(message.error.message)) : call.resolve(message.result);
  }

  send(method, params = {}, sessionId = this.session) {
    const id = ++this.last;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    return new Promise((resolve, reject) => this.calls.set(id, { resolve, reject }));
  }

  /// Opens a page in a window of that size.
  async open(address, { width = 1280, height = 900, scheme = "light" } = {}) {
    if (!this.session) {
      const { targetId } = await this.send("Target.createTarget", { url: "about:blank" }, undefined);
      this.session = (await this.send("Target.attachToTarget", { targetId, flatten: true }, undefined)).sessionId;
      await this.send("Runtime.enable");
      await this.send("Page.enable");
    }
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 500 });
    await this.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
    await this.send("Page.navigate", { url: "about:blank" });
    await this.send("Page.navigate", { url: address });
  }

  /// The value of an expression; a promise is waited for.
  async value(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /// Waits until an expression is true.
  async until(expression, seconds = 60) {
    for (
      const end = Date.now() + 1000 * seconds;
      Date.now() < end;
      await new Promise((resolve) => setTimeout(resolve, 20))
    )
      if (await this.value(`Boolean(${expression})`)) return;
    throw new Error(
      `never came true: ${expression}; the page says: ${await this.value("document.body?.innerText.slice(0, 600)")}`,
    );
  }

  async screenshot(whole = false) {
    return Buffer.from((await this.send("Page.captureScreenshot", { captureBeyondViewport: whole })).data, "base64");
  }

  move(x, y) {
    return this.send("Input.dispatchMouseEvent", { type: "mouseMoved", x, y });
  }

  async click(x, y) {
    for (const type of ["mousePressed", "mouseReleased"])
      await this.send("Input.dispatchMouseEvent", { type, x, y, button: "left", clickCount: 1 });
  }

  async key(key, modifiers = 0) {
    for (const type of ["keyDown", "keyUp"])
      await this.send("Input.dispatchKeyEvent", {
        type,
        key,
        code: key,
        modifiers,
        windowsVirtualKeyCode: key === "Enter" ? 13 : 0,
      });
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once("exit", resolve));
    this.send("Browser.close", {}, undefined).catch(() => {});
    const patience = setTimeout(() => this.process.kill("SIGKILL"), 5000);
    await ended;
    clearTimeout(patience);
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 10 });
  }
}
