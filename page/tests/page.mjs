// The page in a headless Chromium, clicked by a script. Run by page/tests/run.sh after engine.mjs, which leaves
// hashes.json.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { Browser, serve } from "./Browser.mjs";
import { size } from "./scenes.mjs";

const { RAYPRO, WEB, CHROMIUM } = process.env;
let browser, server;
before(async () => {
  server = await serve(WEB);
  browser = Browser.start(CHROMIUM);
});
after(async () => {
  await browser.close();
  server.close();
});

const finished = (state) => `document.body?.dataset.state === "${state}"`;
const open = async (fragment = "scene=scenes/hello.scn&options=-width 64 -height 64 -samples 1") => {
  await browser.open(server.address + "#" + fragment);
  await browser.until(finished("finished"));
};
const textOf = (id) => browser.value(`document.getElementById("${id}").textContent`);

/// Types a scene in place of the one that is there, as an editor's user does.
const type = async (text) =>
  browser.value(`{ const e = document.getElementById("scene"); e.value = ${JSON.stringify(text)};
  e.dispatchEvent(new Event("input")); raypro.job().state = document.body.dataset.state = "edited"; }`);

/// The SHA-256 of the PFM that the page would let its user download.
const hashOfImage = () =>
  browser.value(`new Promise(resolve => {
  const worker = raypro.job().workers[0], before = worker.onmessage;
  worker.onmessage = async ({ data }) => {
    worker.onmessage = before;
    const digest = await crypto.subtle.digest("SHA-256", data.file);
    resolve([...new Uint8Array(digest)].map(byte => byte.toString(16).padStart(2, "0")).join(""));
  };
  worker.postMessage({ film: "image.pfm" });
})`);

test("every scene has the bytes of raypro, from two workers", async () => {
  await open();
  await browser.value(`document.getElementById("workers").value = 2`);
  const hashes = JSON.parse(readFileSync(WEB + "/hashes.json"));
  assert(Object.keys(hashes).length >= 40);
  for (const [name, hash] of Object.entries(hashes)) {
    await browser.value(`raypro.showExample(${JSON.stringify(name)},
      [...${JSON.stringify(size)}, ...raypro.optionsOf(${JSON.stringify(name)})])`);
    await browser.until(finished("finished"));
    assert.equal(await hashOfImage(), hash, name);
  }
  assert.deepEqual(browser.errors, []);
});

test("one worker renders what two do", async () => {
  const hashes = [];
  for (const workers of [1, 2]) {
    await open("scene=scenes/hello.scn&options=-samples 4 -width 64 -height 64");
    await browser.value(
      `{ document.getElementById("workers").value = ${workers}; document.getElementById("render").click(); }`,
    );
    await browser.until(`raypro.job().of === ${workers} && ${finished("finished")}`);
    hashes.push(await hashOfImage());
  }
  assert.equal(hashes[0], hashes[1]);
});

test("a mistake has its place marked and its message shown", async () => {
  await open();
  await type("camera 0 0 5 0 0 -1 0 1 0 .4 .1 9\nsphere -1 0 0 0 -1\n");
  await browser.until(finished("failed"));
  assert.match(await textOf("messages"), /scenes\/hello\.scn:2:17: .*positive|scenes\/hello\.scn:2:17: /);
  assert.equal(await browser.value(`document.querySelector("#marks b").textContent`), "-1");
  const [mark, text] = await browser.value(
    `[document.querySelector("#marks b"), document.getElementById("scene")].map(e => e.getBoundingClientRect().y)`,
  );
  assert(mark > text + 20 && mark < text + 60, "the mark is in the second line");
  await type("sphere -1 0 0 0 1\n");
  await browser.until(finished("finished"));
  assert.equal(await browser.value(`document.querySelectorAll("#marks b").length`), 0);
});

test("a click shows the tree of -debugpixel", async () => {
  await open("scene=scenes/hello.scn&options=-width 64 -height 48 -samples 1");
  const box = await browser.value(
    `document.getElementById("image").getBoundingClientRect().toJSON()`,
  );
  await browser.click(box.x + (box.width * 20.5) / 64, box.y + (box.height * 30.5) / 48);
  await browser.until(`document.getElementById("rays").dataset.pixel`);
  const said = execFileSync(RAYPRO, [
    "scenes/hello.scn",
    "-width",
    "64",
    "-height",
    "48",
    "-samples",
    "1",
    "-debugpixel",
    "20",
    "17",
  ]).toString();
  assert.equal(await textOf("rays"), said.trimEnd());
});

test("arrow keys and Enter show the rays of a pixel", async () => {
  await open("scene=scenes/sphere.scn&options=-width 64 -height 48");
  await browser.value(`document.getElementById("image").focus()`);
  await browser.key("ArrowLeft");
  await browser.key("Enter");
  await browser.until(`document.getElementById("rays").dataset.pixel === "31 23"`);
  assert.match(await textOf("rays"), /^pixel 31 23 of 64 x 48/);
});

const count = (selector) => browser.value(`document.querySelectorAll(${JSON.stringify(selector)}).length`);
const middleOf = (selector) =>
  browser.value(`{ const box = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect();
    [box.x + box.width / 2, box.y + box.height / 2]; }`);
const meant = () =>
  browser.value(`[...document.querySelectorAll(".meant")].map(e => e.tagName.toLowerCase() + e.dataset.ray)`);

test("the rays of a pixel are in the image, and in a link", async () => {
  await open("scene=scenes/hello.scn&options=-width 64 -height 48 -samples 1&pixel=40,14");
  await browser.until(`document.getElementById("rays").dataset.pixel === "40 14"`);
  const rays = await count("#paths g");
  assert(rays > 10, `${rays} rays`);
  assert.equal(await count("#rays .ray"), rays);
  await browser.value(`document.getElementById("share").click()`);
  await browser.until(`location.hash.endsWith("&pixel=40,14")`);
  await type("sphere -1 0 0 0 1\n");
  await browser.until(finished("finished"));
  await browser.until(`document.getElementById("rays").dataset.pixel === "40 14"`);
  assert((await count("#paths g")) < rays, "rays of the old scene are gone");
  await browser.value(`document.getElementById("share").click()`);
  await browser.until(`location.hash.startsWith("#text=")`);
  await browser.open(await browser.value("location.href"));
  await browser.until(`document.getElementById("rays").dataset.pixel === "40 14"`);
  await browser.value(`raypro.showExample("scenes/sphere.scn")`);
  assert.equal(await count("#paths *"), 0);
  await browser.until(finished("finished"));
  assert.equal(await count("#paths *"), 0);
});

test("a row and a line of a ray highlight each other", async () => {
  await open("scene=scenes/hello.scn&options=-width 64 -height 48 -samples 1 -shadow_samples 1&pixel=50,20");
  await browser.until(`document.getElementById("rays").dataset.pixel`);
  await browser.value(`document.querySelector('#rays [data-ray="1"]').scrollIntoView()`);
  await browser.move(...(await middleOf(`#rays [data-ray="1"]`)));
  assert.deepEqual(await meant(), ["g1", "span1"].toSorted());
  // A point of a line that is within the image.
  await browser.value(`document.getElementById("image").scrollIntoView()`);
  const [x, y, ray] = await browser.value(`{
    const found = [];
    for (const path of document.querySelectorAll("#paths path"))
      for (let share = 0.1; share < 1; share += 0.1) {
        const at = path.getPointAtLength(path.getTotalLength() * share);
        const on = new DOMPoint(at.x, at.y).matrixTransform(path.getScreenCTM());
        const group = document.elementFromPoint(on.x, on.y)?.closest("#paths g");
        if (group) found.push([on.x, on.y, group.dataset.ray]);
      }
    found.at(-1); }`);
  await browser.move(x, y);
  assert.deepEqual((await meant()).toSorted(), [`g${ray}`, `span${ray}`]);
  await browser.value(`document.getElementById("rays").focus()`);
  await browser.move(1, 1);
  assert.deepEqual(await meant(), []);
  for (const key of ["ArrowDown", "ArrowDown"]) await browser.key(key);
  assert.deepEqual((await meant()).toSorted(), ["g1", "span1"]);
});

test("a slider limits the bounces that are shown", async () => {
  await open("scene=scenes/hello.scn&options=-width 64 -height 48 -samples 1&pixel=50,20");
  await browser.until(`document.getElementById("rays").dataset.pixel`);
  const limit = (depth) =>
    browser.value(`{ const e = document.getElementById("depth"); e.value = ${depth};
      e.dispatchEvent(new Event("input")); document.getElementById("depth-shown").textContent; }`);
  const deepest = Number(await browser.value(`document.getElementById("depth").max`));
  assert(deepest >= 2, `${deepest} bounces`);
  const all = await count("#paths g");
  assert.equal(await limit(deepest), "all");
  assert.equal(await count("#paths g.deeper"), 0);
  assert.equal(await limit(0), "0");
  assert.equal((await count("#paths g.deeper")) + (await count(`#paths g[data-depth="0"]`)), all);
  assert((await count("#paths g.deeper")) > 0);
});

test("the page starts with an image that is stored", async () => {
  await browser.open(server.address);
  await browser.until(`document.getElementById("image")?.classList.contains("first")`);
  await browser.until(finished("finished"));
  assert.equal(await browser.value(`getComputedStyle(document.getElementById("image")).backgroundImage.includes("first.jpg")`), true);
  await browser.open(server.address + "#scene=scenes/sphere.scn");
  await browser.until(`document.getElementById("image")`);
  assert.equal(await count("#image.first"), 0);
});

test("a scene of 200,000 lines is edited, and its mistake marked", async () => {
  await open("scene=scenes/sphere.scn&options=-width 16 -height 16 -samples 1");
  await type("# a line\n".repeat(200_000) + "sphere -1 0 0 0 -1\n");
  await browser.until(finished("failed"));
  assert.match(await textOf("messages"), /scenes\/sphere\.scn:200001:17: /);
  assert.equal(await count("#marks b"), 1);
  assert.deepEqual(browser.errors, []);
});

test("Ctrl-Enter renders, and a link brings the scene back", async () => {
  await open();
  await type("sphere -1 0 0 0 1\n# \u{1d11e} umlaut ä\n");
  await browser.until(finished("finished"));
  await browser.value(`raypro.job().state = document.body.dataset.state = "edited"`);
  await browser.key("Enter", 2);
  await browser.until(finished("finished"));
  await browser.value(`document.getElementById("share").click()`);
  await browser.until(`location.hash.startsWith("#text=")`);
  const link = await browser.value("location.href");
  await browser.open(link);
  await browser.until(finished("finished"));
  assert.equal(
    await browser.value(`document.getElementById("scene").value`),
    "sphere -1 0 0 0 1\n# \u{1d11e} umlaut ä\n",
  );
});

test("an edit ends what is rendered", async () => {
  await open("scene=scenes/sphere.scn");
  await browser.value(
    `{ document.getElementById("more").value = "-mode path"; document.getElementById("samples").value = 60000;
       document.getElementById("render").click(); }`,
  );
  await browser.until(finished("rendering"));
  await browser.value(
    `{ const samples = document.getElementById("samples");
       samples.value = 1; samples.dispatchEvent(new Event("input", { bubbles: true })); }`,
  );
  await browser.until(finished("finished"), 20);
});

test("a dropped file that is broken is refused by its name", async () => {
  await open();
  await browser.value(
    `raypro.addFiles([new File([new Uint8Array([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 1])], "bad.png")])`,
  );
  await type("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 bad.png\nsphere 0 0 0 0 1\n");
  await browser.until(finished("failed"));
  assert.match(await textOf("messages"), /bad\.png.*the browser cannot read this image/s);
});

test("a scene that the memory cannot hold is refused", async () => {
  await open("scene=scenes/sphere.scn");
  await browser.value(
    `{ document.getElementById("more").value = "-width 16000 -height 16000";
       document.getElementById("render").click(); }`,
  );
  await browser.until(finished("failed"));
  assert.match(await textOf("messages"), /more than the limit of 3\.00 GiB/);
});

test("a deep scene renders", async () => {
  await open("scene=scenes/sphere.scn&options=-width 16 -height 16");
  await type(
    "begin -1 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n".repeat(5_000) + "sphere -1 0 0 0 1\n" + "end\n".repeat(5_000),
  );
  await browser.until(finished("finished"));
});

test("no width scrolls sideways, and everything has a name", async () => {
  for (const width of [360, 390, 768, 1280, 2560]) {
    await browser.open(server.address + "#scene=scenes/hello.scn&options=-samples 1", { width });
    await browser.until(finished("finished"));
    assert((await browser.value("document.documentElement.scrollWidth")) <= width, `${width} pixels`);
  }
  const nameless = await browser.value(`[...document.querySelectorAll("input, select, textarea, button, canvas")]
    .filter(e => !(e.labels?.length || e.ariaLabel || e.textContent.trim())).map(e => e.id)`);
  assert.deepEqual(nameless, []);
});

test("a page asks no other machine for anything", async () => {
  await open();
  const others = await browser.value(
    `performance.getEntriesByType("resource").map(e => e.name).filter(n => !n.startsWith(location.origin))`,
  );
  assert.deepEqual(others, []);
  assert.equal(await browser.value("document.cookie + localStorage.length"), "0");
});
