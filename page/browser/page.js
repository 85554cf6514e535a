// The page: an editor, a form, and workers that render parts of one image. No framework, no network but this folder.
import { isPng, pngOfRgba, ppmOfPng } from "./png.js";

const $ = (id) => document.getElementById(id);
const delay = 60; // milliseconds without a key before an edit renders
const mostWorkers = 8; // at first; each holds the scene in its own memory
const firstScene = "scenes/hello.scn"; // whose image first.jpg is
const mostLink = 100_000; // characters; browsers and chats cut longer ones

// --- files: examples, and what the user adds ---

let examples = { scenes: [], files: {}, binary: {} };
const added = new Map(); // name to bytes, as given
const readable = new Map(); // name to bytes that the engine reads, of images

const bytesOf = (text) => new TextEncoder().encode(text);
const fromBase64 = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const baseName = (name) => name.slice(name.lastIndexOf("/") + 1);

function storedBytes(name) {
  if (added.has(name)) return added.get(name);
  if (name in examples.files) return bytesOf(examples.files[name]);
  return name in examples.binary ? fromBase64(examples.binary[name]) : null;
}

/// The browser's decoder, for JPEG and interlaced PNG. Its values can differ from raypro's by one in 255.
async function ppmByBrowser(bytes) {
  const bitmap = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const head = bytesOf(`P6\n${bitmap.width} ${bitmap.height}\n255\n`),
    ppm = new Uint8Array(head.length + (data.length / 4) * 3);
  ppm.set(head);
  for (let from = 0, to = head.length; from < data.length; from += 4, to += 3)
    ppm.set(data.subarray(from, from + 3), to);
  return ppm;
}

/// What the engine gets for a file: images of the browser's formats as PPM. One that cannot be read stays as it is, and
/// the scene that names it says so.
async function readableBytes(name) {
  if (readable.has(name)) return readable.get(name);
  let bytes = storedBytes(name);
  try {
    if (isPng(bytes)) bytes = (await ppmOfPng(bytes)) ?? (await ppmByBrowser(bytes));
    else if (bytes[0] === 0xff && bytes[1] === 0xd8) bytes = await ppmByBrowser(bytes);
  } catch {
    /* the engine refuses it by its name */
  }
  readable.set(name, bytes);
  return bytes;
}

/// All files that are called like something in the text, or in a text file that is.
function filesFor(text) {
  const names = [...new Set([...Object.keys(examples.files), ...Object.keys(examples.binary), ...added.keys()])];
  const wanted = new Set(),
    texts = [text];
  while (texts.length > 0) {
    const now = texts.pop();
    for (const name of names) {
      if (wanted.has(name) || !now.includes(baseName(name))) continue;
      wanted.add(name);
      const other = storedBytes(name);
      if (/\.(scn|mtl|obj|json|ya?ml|txt)$/i.test(name)) texts.push(new TextDecoder().decode(other));
    }
  }
  return [...wanted];
}

/// A file that the user added lies beside the scene.
function placeOf(name, scene) {
  const folder = scene.slice(0, scene.lastIndexOf("/") + 1);
  return added.has(name) && !name.includes("/") ? folder + name : name;
}

// --- workers ---

let module = null;
const spare = []; // that are started and wait for a scene
let job = null; // the image that is being made, or shown

function startWorker() {
  const worker = new Worker("worker.js", { type: "module" });
  worker.ready = new Promise((resolve) => {
    worker.onmessage = ({ data }) => {
      listModes(data.modes);
      resolve(worker);
    };
  });
  worker.postMessage({ module });
  return worker;
}

function keepSpares(count) {
  while (spare.length < count) spare.push(startWorker());
  while (spare.length > count) spare.pop().terminate();
}

function stop() {
  for (const worker of job?.workers ?? []) worker.terminate();
  if (job) job.workers = [];
}

function optionWords() {
  const words = [];
  for (const option of ["mode", "width", "height", "samples", "seed"])
    if ($(option).value !== "") words.push("-" + option, $(option).value);
  return [
    ...words,
    ...$("more")
      .value.split(/\s+/)
      .filter((word) => word !== ""),
  ];
}

async function render() {
  stop();
  clearRays();
  const of = Math.max(1, Math.min(64, Number($("workers").value) || 1)),
    name = $("name").value || "scene.scn";
  const now = (job = {
    name,
    of,
    options: optionWords(),
    workers: [],
    parts: [],
    begun: performance.now(),
    state: "opening",
    text: $("scene").value,
  });
  document.body.dataset.state = "opening";
  const names = filesFor(now.text).filter((file) => file !== name);
  const files = await Promise.all(names.map(async (file) => [placeOf(file, name), await readableBytes(file)]));
  files.push([name, bytesOf(now.text)]);
  keepSpares(of);
  const workers = await Promise.all(spare.splice(0, of).map((worker) => worker.ready));
  keepSpares(of);
  if (job !== now) return workers.forEach((worker) => worker.terminate());
  now.workers = workers;
  workers.forEach((worker, i) => {
    worker.onmessage = ({ data }) => {
      if (job === now) take(now, data);
    };
    worker.onerror = (event) => {
      if (job === now) fail(now, { mistake: "the engine failed: " + event.message, kind: "engine" });
    };
    worker.postMessage({ files, scene: name, options: now.options, index: i + 1, of });
  });
}

function take(now, message) {
  if (message.opened) opened(now, message);
  else if (message.pass) drawPass(now, message);
  else if (message.part !== undefined) collect(now, message);
  else if (message.round) for (const worker of now.workers.slice(1)) worker.postMessage({ round: message.round });
  else if (message.finished) finish(now, message.finished);
  else if (message.rays) showRays(now, message);
  else if (message.file) download(new Blob([message.file]), "pfm");
  else if (message.mistake) fail(now, message);
}

function opened(now, { opened: region, warnings, index }) {
  if (index === 1) tell(warnings, false);
  if (index === 1 && pixel && isInside(region, pixel)) now.workers[0].postMessage({ pixel });
  if (now.region) return; // any worker may be the first
  now.region = region;
  const { width, height } = region;
  if ($("image").width !== width || $("image").height !== height) Object.assign($("image"), { width, height });
  $("image").parentElement.style.setProperty("--aspect", width / height);
  now.pixels = $("image").getContext("2d").getImageData(0, 0, width, height);
  setState(now, "rendering");
}

/// Pixels of other parts have alpha 0 and stay.
function drawPass(now, { pass }) {
  const to = new Uint32Array(now.pixels.data.buffer),
    from = new Uint32Array(pass.buffer);
  if (to.length !== from.length) return;
  for (let i = 0; i < from.length; ++i) if (from[i] >>> 24) to[i] = from[i];
  $("image").getContext("2d").putImageData(now.pixels, 0, 0);
  now.first ??= performance.now() - now.begun;
  status(now);
}

function collect(now, { part, index }) {
  now.parts.push([index, part]);
  if (now.parts.length < now.of) return;
  const parts = now.parts.filter(([, bytes]) => bytes);
  now.parts = [];
  now.workers[0].postMessage({ parts });
}

function finish(now, ppm) {
  const { width, height } = now.region,
    data = now.pixels.data;
  for (let i = 0, from = ppm.length - 3 * width * height; i < data.length; i += 4) {
    data.set(ppm.subarray(from, (from += 3)), i);
    data[i + 3] = 255;
  }
  $("image").getContext("2d").putImageData(now.pixels, 0, 0);
  now.seconds = (performance.now() - now.begun) / 1000;
  now.workers.splice(1).forEach((worker) => worker.terminate());
  setState(now, "finished");
}

function fail(now, { mistake, kind, about }) {
  if (about === "pixel") return clearRays(mistake);
  stop();
  tell(mistake, true, now.name);
  setState(now, "failed");
  if (kind === "engine") $("status").textContent = "The engine stopped; the next render starts a new one.";
}

function setState(now, state) {
  now.state = document.body.dataset.state = state;
  status(now);
}

function status(now) {
  const workers = `${now.of} worker${now.of > 1 ? "s" : ""}`;
  const size = now.region ? `${now.region.width}x${now.region.height}` : "";
  $("status").textContent = {
    opening: "",
    failed: "Not rendered: see the message.",
    rendering: `${size}, rendering with ${workers}`,
    finished: `${size}, ${now.seconds?.toFixed(2)} s, first image after ${Math.round(now.first)} ms, ${workers}`,
  }[now.state];
}

// --- messages and marks ---

function tell(text, isWrong, name = "") {
  $("messages").textContent = text.trimEnd();
  $("messages").classList.toggle("wrong", isWrong);
  mark(isWrong ? text : "", name);
}

/// Marks each place "name:line:column" of the messages in the text.
function mark(messages, name) {
  const places = [...messages.matchAll(/^(.*?):(\d+):(\d+): (?!warning)/gm)]
    .filter(([, file]) => file === name)
    .map(([, , line, column]) => [Number(line) - 1, Number(column) - 1]);
  const nodes = [],
    lines = places.length > 0 ? $("scene").value.split("\n") : [];
  let text = ""; // up to the next mark: a node for each line would be too many
  lines.forEach((line, i) => {
    const columns = places.filter(([at]) => at === i).map(([, column]) => column);
    if (columns.length === 0) return void (text += line + "\n");
    let done = 0;
    const characters = [...line];
    for (const column of columns.sort((a, b) => a - b)) {
      if (column < done) continue;
      const word = characters.slice(column).join("").match(/^\S*/)[0] || " ";
      nodes.push(text + characters.slice(done, column).join(""));
      nodes.push(Object.assign(document.createElement("b"), { textContent: word }));
      text = "";
      done = column + [...word].length;
    }
    text += characters.slice(done).join("") + "\n";
  });
  nodes.push(text);
  $("marks").replaceChildren(...nodes);
  scrollMarks();
}

function scrollMarks() {
  $("marks").scrollTop = $("numbers").scrollTop = $("scene").scrollTop;
  $("marks").scrollLeft = $("scene").scrollLeft;
}

let numbered = 0; // lines
function number() {
  const lines = $("scene").value.split("\n").length;
  if (lines === numbered) return;
  numbered = lines;
  $("numbers").textContent = Array.from({ length: lines }, (_, i) => i + 1).join("\n") + "\n\n";
}

// --- pixels ---

const colorOfKind = ["camera", "shadow", "reflection", "transmission", "diffuse"]; // classes of style.css
const lookOfLine = ["", "hidden", "beyond", "beyond hidden"];
const opaqueRays = 60; // more are the fainter, the more there are
const invitation = $("rays").textContent;
let pixel = null; // whose rays are shown: [column, row] of the whole image, rows from the bottom
let chosen = null; // the number of a ray of it that a click or a key has chosen

const isInside = ({ left, bottom, width, height }, [x, y]) =>
  x >= left && x < left + width && y >= bottom && y < bottom + height;

/// Column and row of the image that is shown, from its upper left corner.
function askFor(column, row) {
  if (!job?.region || !job.workers[0]) return;
  pixel = [job.region.left + column, job.region.bottom + job.region.height - 1 - row];
  job.workers[0].postMessage({ pixel });
}

function clearRays(text = invitation) {
  chosen = null;
  $("rays").textContent = text;
  delete $("rays").dataset.pixel;
  $("paths").replaceChildren();
  $("bounces").hidden = true;
}

function showRays({ region }, { rays, pixel: shown }) {
  chosen = null;
  $("rays").replaceChildren(...rowsOf(rays.tree.trimEnd(), rays.lines));
  $("rays").dataset.pixel = shown.join(" ");
  drawRays(region, rays.lines, shown);
  const deepest = rays.lines.reduce((most, [, depth]) => Math.max(most, depth), 0);
  $("bounces").hidden = deepest === 0;
  Object.assign($("depth"), { max: deepest, value: deepest });
  limitDepth();
}

/// The text in elements, one for each ray, whose lines are indented below its first.
function rowsOf(tree, lines) {
  const rows = [];
  let ray = -1;
  for (const line of tree.split(/(?<=\n)/)) {
    const isFirst = /^ +\w+ ray/.test(line) && ray + 1 < lines.length;
    if (isFirst) {
      const [kind, depth] = lines[++ray];
      rows.push(Object.assign(document.createElement("span"), { className: "ray " + colorOfKind[kind] }));
      Object.assign(rows.at(-1).dataset, { ray, depth });
    } else if (!rows.at(-1)?.dataset?.ray || !line.startsWith(" ")) {
      rows.push(document.createElement("span"));
    }
    rows.at(-1).append(line);
  }
  return rows;
}

const svg = (name, attributes) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};

function drawRays({ left, bottom, width, height }, lines, [column, row]) {
  const top = bottom + height,
    drawn = [];
  lines.forEach(([kind, depth, ...ends], ray) => {
    const group = svg("g", { class: colorOfKind[kind], "data-ray": ray, "data-depth": depth });
    const paths = ["", "", "", ""];
    for (let i = 0; i < ends.length; i += 5)
      paths[ends[i + 4]] +=
        `M${ends[i] - left} ${top - ends[i + 1]}L${ends[i + 2] - left} ${top - ends[i + 3]}`;
    paths.forEach((d, look) => d && group.append(svg("path", { d, class: lookOfLine[look] })));
    drawn.push(group);
  });
  drawn.push(svg("rect", { x: column - left, y: top - 1 - row, width: 1, height: 1 }));
  $("paths").setAttribute("viewBox", `0 0 ${width} ${height}`);
  $("paths").style.setProperty("--opacity", Math.max(0.15, Math.min(1, opaqueRays / lines.length)));
  $("paths").replaceChildren(...drawn);
}

/// Shows which ray is meant, in the text and in the image.
function highlight(ray) {
  for (const element of document.querySelectorAll("[data-ray]"))
    element.classList.toggle("meant", ray !== null && element.dataset.ray === String(ray));
  $("paths").classList.toggle("chosen", ray !== null);
}

function choose(ray) {
  chosen = ray === chosen ? null : ray;
  highlight(chosen);
  scrollToRow(chosen);
}

function scrollToRow(ray) {
  const row = $("rays").querySelector(`[data-ray="${ray}"]`);
  if (!row) return;
  const box = row.getBoundingClientRect(),
    pane = $("rays").getBoundingClientRect();
  if (box.top < pane.top || box.bottom > pane.bottom) $("rays").scrollTop += box.top - pane.top;
}

function stepRay(event) {
  const step = { ArrowUp: -1, ArrowDown: 1 }[event.key],
    last = $("rays").querySelectorAll("[data-ray]").length - 1;
  if (!step || last < 0) return;
  event.preventDefault();
  choose(Math.min(last, Math.max(0, (chosen ?? (step > 0 ? -1 : last + 1)) + step)));
}

function limitDepth() {
  const limit = Number($("depth").value);
  $("depth-shown").textContent = limit === Number($("depth").max) ? "all" : limit;
  for (const element of document.querySelectorAll("[data-depth]"))
    element.classList.toggle("deeper", Number(element.dataset.depth) > limit);
}

function listenToRays() {
  const rayOf = ({ target }) => target.closest?.("[data-ray]")?.dataset.ray ?? null;
  for (const place of [$("rays"), $("paths")]) {
    place.addEventListener("pointerover", (event) => {
      const ray = rayOf(event);
      highlight(ray ?? chosen);
      if (place === $("paths")) scrollToRow(ray);
    });
    place.addEventListener("pointerleave", () => highlight(chosen));
  }
  $("rays").addEventListener("click", (event) => {
    if (rayOf(event) !== null) choose(Number(rayOf(event)));
  });
  $("rays").addEventListener("keydown", stepRay);
  $("depth").addEventListener("input", limitDepth);
}

let cursor = null;
function moveCursor(event) {
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
  const { width, height } = $("image");
  cursor ??= [width >> 1, height >> 1];
  if (event.key === "Enter") askFor(...cursor);
  if (!step) return;
  event.preventDefault();
  const times = event.shiftKey ? 16 : 1;
  cursor = [
    Math.min(width - 1, Math.max(0, cursor[0] + times * step[0])),
    Math.min(height - 1, Math.max(0, cursor[1] + times * step[1])),
  ];
  $("status").textContent = `column ${cursor[0]}, row ${height - 1 - cursor[1]} from the bottom: Enter shows its rays`;
}

// --- downloads, links, examples ---

function download(blob, extension) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = baseName(job.name).replace(/\.[^.]*$/, "") + "." + extension;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

async function downloadPng() {
  if (!job?.region) return;
  const { width, height } = job.region;
  download(
    await pngOfRgba(job.pixels.data, width, height, {
      Software: "raypro",
      command: ["raypro", job.name, ...job.options].join(" "),
    }),
    "png",
  );
}

async function pack(text) {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  return btoa(bytes.reduce((all, byte) => all + String.fromCharCode(byte), ""))
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replaceAll("=", "");
}
async function unpack(text) {
  const bytes = fromBase64(text.replaceAll("-", "+").replaceAll("_", "/"));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
}

/// The part of an address behind #: of an example its name, of other scenes their text.
async function fragmentOf(name, text, options) {
  if (text !== examples.files[name])
    return "text=" + (await pack(JSON.stringify(pixel ? [name, text, options, pixel] : [name, text, options])));
  return `scene=${name}&options=${options.join(" ")}` + (pixel ? `&pixel=${pixel}` : "");
}

async function share() {
  const link = new URL(location.href);
  link.hash = await fragmentOf($("name").value, $("scene").value, optionWords());
  if (link.href.length > mostLink) return tell("The scene is too long for a link.", true);
  history.replaceState(null, "", link);
  try {
    await navigator.clipboard.writeText(link.href);
    $("status").textContent =
      "The link is copied" + (added.size > 0 ? "; files that you added do not travel with it." : ".");
  } catch {
    $("status").textContent = "The link is in the address bar.";
  }
}

function setOptions(words) {
  const fields = ["mode", "width", "height", "samples", "seed"],
    more = [];
  for (const field of fields) $(field).value = "";
  for (let i = 0; i < words.length; ++i) {
    const field = words[i].replace(/^-/, "");
    if (fields.includes(field) && i + 1 < words.length) {
      if (field === "mode") listModes("  " + words[i + 1] + " ");
      $(field).value = words[++i];
    } else {
      more.push(words[i]);
    }
  }
  $("more").value = more.join(" ");
}

function show(name, text, options, at) {
  $("image").classList.toggle("first", name === firstScene && options.length === 0 && text === examples.files[name]);
  $("name").value = name;
  $("scene").value = text;
  setOptions(options);
  $("scene").scrollTop = $("scene").scrollLeft = 0;
  cursor = null;
  pixel = /^\d+,\d+$/.test(at) ? String(at).split(",").map(Number) : null;
  number();
  render();
}

function showExample(name, options, at) {
  const scene = examples.scenes.find((one) => one.name === name);
  if (!scene) return tell(`There is no example ${name}.`, true);
  $("examples").value = name;
  show(name, examples.files[name], options ?? scene.options, at);
}

/// "#text=..." is a shared scene, "#scene=name&options=..." an example; "&pixel=column,row" shows the rays of a pixel.
async function showFragment() {
  const fragment = new URLSearchParams(location.hash.slice(1).replaceAll("+", "%2B"));
  try {
    if (fragment.has("text")) return show(...JSON.parse(await unpack(fragment.get("text"))));
  } catch {
    tell("The link is damaged: its scene cannot be read.", true);
  }
  if (fragment.has("scene"))
    return showExample(
      fragment.get("scene"),
      fragment
        .get("options")
        ?.split(" ")
        .filter((word) => word),
      fragment.get("pixel"),
    );
  showExample(firstScene);
}

function listModes(lines) {
  for (const [, mode, about] of (lines ?? "").matchAll(/^ {2}(\w+) *(.*)$/gm))
    if (![...$("mode").options].some((option) => option.value === mode))
      $("mode").append(
        Object.assign(document.createElement("option"), { value: mode, textContent: mode, title: about }),
      );
}

function listExamples() {
  const courses = {
    "scenes/comp30019/": "COMP30019",
    ".json": "JSON courses",
    ".yaml": "Groningen",
    ".yml": "Groningen",
  };
  for (const { name, about } of examples.scenes) {
    const course = Object.keys(courses).find((key) => name.startsWith(key) || name.endsWith(key));
    const label = course ? courses[course] : name.startsWith("scenes/") ? "Scenes" : "Writeup";
    const group =
      [...$("examples").children].find((one) => one.label === label) ??
      $("examples").appendChild(Object.assign(document.createElement("optgroup"), { label }));
    group.append(
      Object.assign(document.createElement("option"), {
        value: name,
        title: about,
        textContent: name.replace(/^(writeup\/)?scenes\//, ""),
      }),
    );
  }
}

async function addFiles(files) {
  for (const file of files) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    if (/\.(scn|txt)$/i.test(file.name)) return show(file.name, new TextDecoder().decode(bytes), []);
    added.set(file.name, bytes);
    readable.delete(file.name);
  }
  $("dropped").replaceChildren(
    ...[...added].map(([name, bytes]) =>
      Object.assign(document.createElement("li"), { textContent: `${name} (${Math.ceil(bytes.length / 1024)} kB)` }),
    ),
  );
  render();
}

// --- events ---

let waiting = 0;
function renderSoon() {
  clearTimeout(waiting);
  waiting = setTimeout(render, delay);
}

function listen() {
  $("scene").addEventListener("input", () => {
    mark("", "");
    number();
    renderSoon();
  });
  $("scene").addEventListener("scroll", scrollMarks);
  $("name").addEventListener("change", render);
  $("options").addEventListener("input", renderSoon);
  $("options").addEventListener("submit", (event) => event.preventDefault());
  $("render").addEventListener("click", render);
  $("share").addEventListener("click", share);
  $("png").addEventListener("click", downloadPng);
  $("pfm").addEventListener("click", () => job?.workers[0]?.postMessage({ film: "image.pfm" }));
  $("examples").addEventListener("change", () => showExample($("examples").value));
  $("image").parentElement.addEventListener("click", (event) => {
    const box = $("image").getBoundingClientRect();
    cursor = [
      Math.floor(((event.clientX - box.x) / box.width) * $("image").width),
      Math.floor(((event.clientY - box.y) / box.height) * $("image").height),
    ];
    askFor(...cursor);
  });
  $("image").addEventListener("keydown", moveCursor);
  listenToRays();
  $("files").addEventListener("change", () => addFiles([...$("files").files]));
  $("files").parentElement.addEventListener("keydown", (event) => {
    if (event.key === "Enter" || event.key === " ") $("files").click();
  });
  addEventListener("keydown", (event) => {
    if (event.ctrlKey && event.key === "Enter") {
      event.preventDefault();
      render();
    }
  });
  addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("over");
  });
  addEventListener("dragleave", () => document.body.classList.remove("over"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("over");
    addFiles([...event.dataTransfer.files]);
  });
  addEventListener("hashchange", showFragment);
}

async function begin() {
  $("workers").value = Math.max(1, Math.min(mostWorkers, navigator.hardwareConcurrency || 1));
  const [answer, code] = await Promise.all([fetch("examples.json"), fetch("raypro.wasm")]);
  [examples, module] = await Promise.all([answer.json(), WebAssembly.compile(await code.arrayBuffer())]);
  keepSpares(Number($("workers").value));
  listExamples();
  listen();
  await showFragment();
}

/// For tests: what a script of clicks cannot see.
globalThis.raypro = {
  job: () => job,
  addFiles,
  showExample,
  optionsOf: (name) => examples.scenes.find((scene) => scene.name === name).options,
};
begin().catch((error) => tell("The page could not start: " + error.message, true));
