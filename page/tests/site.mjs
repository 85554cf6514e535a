// The site that make site gathers: links, names, sizes and, in Chromium, widths and contrasts. Run by page/tests/run.sh.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { dirname, join, normalize, relative } from "node:path";
import test, { after, before } from "node:test";
import { Browser, serve } from "./Browser.mjs";

const { SITE, CHROMIUM } = process.env;
const files = readdirSync(SITE, { recursive: true })
  .map(String)
  .filter((name) => statSync(join(SITE, name)).isFile());
const pages = files.filter((name) => name.endsWith(".html"));
const textOf = (page) => readFileSync(join(SITE, page), "utf8");
const all = (pattern, text) => [...text.matchAll(pattern)];
const decoded = (text) => decodeURIComponent(text.replaceAll("&amp;", "&"));

test("the site is smaller than 15 MB", () => {
  const bytes = files.reduce((sum, name) => sum + statSync(join(SITE, name)).size, 0);
  assert(pages.length > 20 && bytes < 15e6, `${pages.length} pages, ${bytes} bytes`);
});

test("every link leads to a place in the site", () => {
  const examples = JSON.parse(textOf("web/examples.json")).scenes.map((scene) => scene.name);
  for (const page of pages)
    for (const [, address] of all(/(?:href|src)="([^"]*)"/g, textOf(page))) {
      if (address.startsWith("data:")) continue;
      assert(!/^[a-z]+:|^\/\//.test(address), `${page} needs another server: ${address}`);
      const [path, fragment] = address.split("#");
      const goal = path ? normalize(join(dirname(page), decoded(path))) : page;
      assert(existsSync(join(SITE, goal)), `${page} links to ${address}`);
      if (goal === "web/index.html" && fragment)
        assert(examples.includes(decoded(fragment).match(/^scene=([^&]*)/)[1]), `${page} opens ${fragment}`);
      else if (fragment) assert(textOf(goal).includes(`id="${decoded(fragment)}"`), `${page} links to ${address}`);
    }
});

test("pages have titles; images have words and sizes", () => {
  const titles = pages.map((page) => textOf(page).match(/<title>([^<]+)<\/title>/)?.[1]);
  assert(titles.every((title) => title));
  assert.deepEqual(
    titles.filter((title, i) => titles.indexOf(title) !== i),
    [],
  );
  for (const page of pages)
    for (const [image] of all(/<img [^>]*>/g, textOf(page))) {
      assert.match(image, /alt="[^"]+"/, page);
      assert.match(image, /width="\d+" height="\d+"/, page);
    }
});

test("nearly every rendered image of the writeup can be edited", () => {
  const text = pages.filter((page) => page.startsWith("writeup/")).map(textOf).join("");
  const commands = all(/<code class="command">build\/raypro /g, text).length,
    links = all(/class="edit"/g, text).length;
  assert(links >= 0.9 * commands && links > 50, `${links} of ${commands}`);
});

let browser, server;
before(async () => {
  if (!CHROMIUM) return;
  server = await serve(SITE);
  browser = Browser.start(CHROMIUM);
});
after(async () => {
  await browser?.close();
  server?.close();
});

// Texts whose contrast with what is behind them is below 4.5 : 1; images and boxes above others are left out.
const faint = `(() => {
  const channels = color => color.match(/[\\d.]+/g).map(Number);
  const linear = v => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4;
  const light = color => { const [r, g, b] = channels(color).map(v => linear(v / 255));
    return .2126 * r + .7152 * g + .0722 * b; };
  const behind = e => {
    if (!e) return "rgb(255,255,255)";
    const color = getComputedStyle(e).backgroundColor;
    return channels(color)[3] === 0 ? behind(e.parentElement) : color;
  };
  const contrast = e => {
    const [a, b] = [light(getComputedStyle(e).color), light(behind(e))].sort((x, y) => y - x);
    return (a + .05) / (b + .05);
  };
  return [...document.querySelectorAll("p, a, li, h1, h2, h3, td, th, code, pre, figcaption, label, button")]
    .filter(e => e.textContent.trim() && e.offsetParent && contrast(e) < 4.5)
    .slice(0, 3).map(e => e.outerHTML.slice(0, 100));
})()`;

test(
  "pages fit a phone, and their text has contrast",
  { skip: !CHROMIUM && "there is no Chromium" },
  async () => {
    for (const page of pages)
      for (const scheme of ["light", "dark"]) {
        await browser.open(server.address + relative(".", page), { width: 390, height: 844, scheme });
        await browser.until("document.readyState === 'complete'");
        const [width, height] = await browser.value(
          "[document.documentElement.scrollWidth, document.documentElement.scrollHeight]",
        );
        assert(width <= 390, `${page} is ${width} pixels wide`);
        assert(height < 60_000, `${page} is ${height} pixels high`);
        if (page.startsWith("writeup")) assert(height < 7_000, `${page} is ${height} pixels high`);
        assert.deepEqual(await browser.value(faint), [], `${page}, ${scheme}`);
      }
  },
);

test(
  "no page of the writeup is long, and its images fill wide windows",
  { skip: !CHROMIUM && "there is no Chromium" },
  async () => {
    for (const page of pages.filter((page) => page.startsWith("writeup/"))) {
      await browser.open(server.address + page, { width: 1280 });
      await browser.until("document.readyState === 'complete'");
      const height = await browser.value("document.documentElement.scrollHeight");
      assert(height <= 6000, `${page} is ${height} pixels high`);
      await browser.open(server.address + page, { width: 2560 });
      await browser.until("document.readyState === 'complete'");
      const right = await browser.value(`Math.max(...[...document.querySelectorAll("main *")]
        .map(e => e.getBoundingClientRect().right))`);
      assert(right > 2400, `${page} ends at ${right}`);
    }
  },
);

test(
  "an edit link opens the image's scene with its options",
  { skip: !CHROMIUM && "there is no Chromium" },
  async () => {
    await browser.open(server.address + "writeup/camera.html");
    await browser.until("document.querySelector('.edit')");
    const link = await browser.value(
      "[...document.querySelectorAll('.edit')].find(a => a.hash.includes('depth')).href",
    );
    await browser.open(link);
    await browser.until(`document.body?.dataset.state === "finished"`);
    assert.equal(await browser.value("document.getElementById('mode').value"), "depth");
    assert.equal(await browser.value("document.getElementById('image').width"), 640);
  },
);
