// The page in Firefox, which no script clicks: a page beside it asks it for images and sends their hashes here. Run by
// page/tests/run.sh after engine.mjs, which leaves hashes.json.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import test from "node:test";
import { types } from "./Browser.mjs";
import { size } from "./scenes.mjs";

const { WEB, FIREFOX } = process.env;

/// What runs in Firefox: the page is in a frame, and its workers render scene after scene.
const probe = (names) => `<!DOCTYPE html><iframe src="index.html" width="900" height="700"></iframe><script type="module">
const frame = document.querySelector("iframe");
const send = (path, body) => fetch(path, { method: "POST", body: JSON.stringify(body) });
const until = async (holds) => { while (!holds()) await new Promise((resolve) => setTimeout(resolve, 5)); };
const state = () => frame.contentDocument?.body?.dataset.state;
try {
  await until(() => frame.contentWindow.raypro && state() === "finished");
  const page = frame.contentWindow.raypro;
  frame.contentDocument.getElementById("workers").value = 2;
  for (const name of ${JSON.stringify(names)}) {
    page.showExample(name, [...page.optionsOf(name), ...${JSON.stringify(size)}]);
    await until(() => state() === "finished" || state() === "failed");
    const file = await new Promise((resolve) => {
      const worker = page.job().workers[0];
      worker.onmessage = ({ data }) => resolve(data.file);
      worker.postMessage({ film: "image.pfm" });
    });
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", file));
    await send("/hash", [name, [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("")]);
  }
  await send("/done", navigator.userAgent);
} catch (error) {
  await send("/failed", String(error));
}
</script>`;

test("every scene has the bytes of raypro in Firefox", { timeout: 120_000 }, async () => {
  const expected = JSON.parse(readFileSync(WEB + "/hashes.json")),
    profile = mkdtempSync(tmpdir() + "/raypro-firefox-");
  let firefox, server;
  try {
    const found = await new Promise((resolve, reject) => {
      const hashes = {};
      server = createServer(async (request, response) => {
        const path = new URL(request.url, "http://localhost").pathname;
        if (request.method === "POST") {
          let text = "";
          for await (const chunk of request) text += chunk;
          response.end();
          if (path === "/hash") hashes[JSON.parse(text)[0]] = JSON.parse(text)[1];
          if (path === "/failed") reject(new Error(text));
          if (path === "/done") resolve(hashes);
          return;
        }
        try {
          const body = path === "/probe.html" ? probe(Object.keys(expected)) : readFileSync(join(WEB, path));
          response.writeHead(200, { "Content-Type": types[extname(path)] ?? "application/octet-stream" });
          response.end(body);
        } catch {
          response.writeHead(404).end();
        }
      }).listen(0, "127.0.0.1", () => {
        const address = `http://127.0.0.1:${server.address().port}/probe.html`;
        firefox = spawn(FIREFOX, ["--headless", "--no-remote", "--profile", profile, address], {
          stdio: "ignore",
          env: { ...process.env, HOME: profile, MOZ_DISABLE_AUTO_SAFE_MODE: "1" },
        });
        firefox.on("error", reject);
      });
    });
    assert.deepEqual(found, expected);
  } finally {
    firefox?.kill();
    server?.closeAllConnections();
    server?.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
});
