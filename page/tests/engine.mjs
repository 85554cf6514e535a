// The engine in Node, without a browser: its bytes are raypro's. Run by page/tests/run.sh.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import test from "node:test";
import { Engine, Mistake } from "../browser/engine.js";
import { pngOfRgba, ppmOfPng } from "../browser/png.js";
import { files, scenes, size, yamlScenes } from "./scenes.mjs";

const { RAYPRO, RAYIMG, WEB } = process.env;
const folder = mkdtempSync(tmpdir() + "/raypro-web-");
process.on("exit", () => rmSync(folder, { recursive: true }));
const module = await WebAssembly.compile(readFileSync(WEB + "/raypro.wasm"));
const examples = JSON.parse(readFileSync(WEB + "/examples.json"));
const all = await files();
const sha = (bytes) => createHash("sha256").update(bytes).digest("hex");

async function engineWith(given = all) {
  const engine = await Engine.start(module);
  for (const [name, bytes] of given) engine.putFile(name, bytes);
  return engine;
}

/// The bytes that raypro writes to a file of that extension.
function native(scene, options, extension = "pfm") {
  const file = `${folder}/native.${extension}`;
  execFileSync(RAYPRO, [scene, file, "-quiet", ...options], { stdio: ["ignore", "ignore", "ignore"] });
  return readFileSync(file);
}

/// Renders in `of` engines, as the page's workers do.
async function inParts(scene, options, of, name = "image.pfm") {
  const engines = await Promise.all(Array.from({ length: of }, () => engineWith()));
  for (const engine of engines) engine.open(scene, options);
  for (let round = null; ;) {
    engines.forEach((engine, i) => {
      if (round && i > 0) engine.takeRound(round);
      while (engine.renderPart(i + 1, of).hasMore) continue;
    });
    engines.forEach((engine, i) => {
      if (i > 0) engines[0].takePart(i + 1, of, engine.part());
    });
    round = engines[0].finishRound();
    if (!round) return engines[0].film(name);
  }
}

/// What the engine says of a text.
async function mistakeIn(text, options = [], name = "scene.scn") {
  const engine = await engineWith(new Map([[name, Buffer.from(text)]]));
  try {
    engine.open(name, options);
  } catch (error) {
    assert(error instanceof Mistake, error.stack);
    return error.message;
  }
  return "";
}

const hashes = {};
async function compareBytes(list) {
  for (const { name, options } of list) {
    hashes[name] = sha(native(name, [...size, ...options]));
    assert.equal(sha(await inParts(name, [...size, ...options], 1)), hashes[name], name);
  }
  writeFileSync(WEB + "/hashes.json", JSON.stringify(hashes));
}
test("every scene has the bytes of raypro", () => compareBytes(scenes(examples)));

const withoutYaml = (await mistakeIn("Eye: [0, 0, 1]", [], "scene.yaml")).includes("built without YAML");
test("every scene in YAML has the bytes of raypro", { skip: withoutYaml && "built without YAML" }, async () => {
  assert(yamlScenes(examples).length > 10);
  await compareBytes(yamlScenes(examples));
});

test("a mistake in YAML is told in raypro's words", { skip: withoutYaml && "built without YAML" }, async () => {
  for (const text of ["Eye: [0, 0, 1\nLights: 3\n", "Eye: [0, 0]\nObjects:\n  - {type: spere}\n"]) {
    writeFileSync(folder + "/scene.yaml", text);
    const said = spawnSync(RAYPRO, ["scene.yaml", "x.pfm"], { cwd: folder }).stderr.toString();
    assert.match(said, /scene\.yaml:\d+:\d+/);
    assert.equal((await mistakeIn(text, [], "scene.yaml")).trim(), said.trim());
  }
});

test("three engines render what one does", async () => {
  for (const options of [
    ["-samples", "5"],
    ["-filter", "gaussian", "-samples", "4"],
    ["-error", "8", "-mode", "path"],
    ["-denoise", "-samples", "4", "-mode", "path"],
    ["-share", "on", "-samples", "4", "-mode", "path"],
    ["-adaptive", "neighbors", "-samples", "9"],
    ["-mode", "depth"],
  ])
    assert.equal(
      sha(await inParts("scenes/hello.scn", [...size, ...options], 3)),
      sha(native("scenes/hello.scn", [...size, ...options])),
      options.join(" "),
    );
});

test("a displayed image has raypro's bytes", async () => {
  const options = [...size, "-srgb", "-samples", "3"];
  assert.deepEqual(
    Buffer.from(await inParts("scenes/gloss.scn", options, 2, "image.ppm")),
    native("scenes/gloss.scn", options, "ppm"),
  );
});

test("a mistake is told in raypro's words", async () => {
  const text = "sphere -1 0 0 0 -1\nspere 0\n";
  writeFileSync(folder + "/scene.scn", text);
  const said = spawnSync(RAYPRO, ["scene.scn", "x.pfm"], { cwd: folder }).stderr.toString();
  assert.match(said, /scene\.scn:1:17/);
  assert.equal((await mistakeIn(text)).trim(), said.trim());
});

test("a wrong option is named", async () => {
  assert.match(
    await mistakeIn("sphere -1 0 0 0 1", ["-sampels", "4"]),
    /unknown option '-sampels'; did you mean '?-samples/,
  );
  assert.match(await mistakeIn("sphere -1 0 0 0 1", ["-time", "4"]), /-time has no meaning in a page/);
  assert.match(await mistakeIn("sphere -1 0 0 0 1", ["-check"]), /not requests/);
});

test("a file that is missing is named with the nearest", async () => {
  const engine = await engineWith(
    new Map([
      ["a/wood.ppm", Buffer.from("P6\n1 1\n255\nabc")],
      ["a/scene.scn", Buffer.from("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 wod.ppm\n")],
    ]),
  );
  assert.throws(() => engine.open("a/scene.scn"), /no such file: 'wod\.ppm'.*did you mean 'wood\.ppm'/s);
});

test("a ray tree is that of -debugpixel", async () => {
  const engine = await engineWith();
  const options = ["-width", "256", "-height", "256", "-samples", "2"];
  engine.open("scenes/hello.scn", options);
  const said = execFileSync(RAYPRO, ["scenes/hello.scn", ...options, "-debugpixel", "150", "90"]).toString();
  assert.equal(engine.raysOf(150, 90).tree, said);
});

/// The first lines of each ray in a tree: [kind, indent].
const rowsOf = (tree) => [...tree.matchAll(/^( +)(\w+) ray/gm)].map(([, indent, kind]) => [kind, indent.length]);
const kinds = ["camera", "shadow", "reflection", "transmission", "diffuse"];

test("every ray of a tree is a line from where its parent ended", async () => {
  const [width, height] = [200, 100];
  for (const options of [
    ["-mode", "path", "-samples", "3"],
    ["-projection", "orthographic"],
    ["-projection", "fisheye"],
    ["-projection", "cylinder"],
    ["-projection", "latlong"],
  ]) {
    const engine = await engineWith();
    engine.open("scenes/hello.scn", ["-width", String(width), "-height", String(height), ...options]);
    for (const [x, y] of [[100, 30], [88, 44], [125, 41]]) {
      const { tree, lines } = engine.raysOf(x, y);
      const where = `${options.join(" ")} ${x} ${y}`;
      assert.deepEqual(lines.map(([kind]) => kinds[kind]), rowsOf(tree).map(([kind]) => kind), where);
      assert(lines.length > 2, where);
      for (const [kind, depth, left, bottom, , , look] of lines) {
        if (kinds[kind] === "camera" || depth > 1 || left === undefined) continue;
        if (kinds[kind] === "shadow" && depth > 0) continue;
        // The point that the camera ray hit is seen through its own pixel.
        assert(left >= x - 0.01 && left <= x + 1.01 && bottom >= y - 0.01 && bottom <= y + 1.01, `${where}: ${left} ${bottom}`);
        assert(look === 0 || look === 1, where);
      }
    }
  }
});

test("lines are hidden behind what is nearer, and cut where a shadow ray is blocked", async () => {
  const engine = await engineWith(
    new Map([["s.scn", Buffer.from(`camera 0 3 5  0 -.4 -1  0 1 0  .5 .01 100
point_light 1 1 1  0 .5 4  1 0 0
material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 0
box 0  -9 -1 -9  9 0 9
box 0  -1 0 0  1 1 1
`)]]),
  );
  engine.open("s.scn", ["-width", "101", "-height", "101", "-samples", "1"]);
  const { lines } = engine.raysOf(50, 58);
  const ends = lines.find(([kind]) => kinds[kind] === "shadow").slice(2);
  const looks = ends.filter((_, i) => i % 5 === 4);
  assert.deepEqual([...new Set(looks)].sort(), [0, 1, 2, 3]);
  assert.equal(looks[0], 0, "it starts where the camera sees");
  assert.equal(looks.findLast((look) => look < 2), 1, "it is blocked behind the box");
  assert.equal(looks.at(-1), 2, "it leaves in front of the box");
  for (let i = 5; i < ends.length; i += 5) assert.deepEqual(ends.slice(i, i + 2), ends.slice(i - 3, i - 1));
});

test("the stored first image is that of the page's first scene", () => {
  const options = ["-width", "512", "-height", "512", "-samples", "16"];
  execFileSync(RAYPRO, ["scenes/hello.scn", folder + "/first.png", "-quiet", ...options]);
  // The JPEG is off by 2.1/255 (rayimg diff, display RMSE); with one sample in place of 16 it would be by 3.6.
  const said = execFileSync(RAYIMG, ["diff", folder + "/first.png", WEB + "/first.jpg"]).toString();
  assert(Number(said.match(/display RMSE +([\d.]+)/)[1]) < 3, said);
});

test("an image has 512 pixels a side and 16 samples unless the scene or its options say otherwise", async () => {
  const engine = await engineWith(
    new Map([
      ["a.scn", Buffer.from("sphere -1 0 0 0 1\n")],
      ["b.scn", Buffer.from("set samples 3\nsphere -1 0 0 0 1\n")],
    ]),
  );
  const imageOf = (name, options) => {
    engine.open(name, options);
    return engine.raysOf(5, 5).tree.match(/of (\d+ x \d+).*?(?:the mean of (\d+) samples)?$/m).slice(1);
  };
  assert.deepEqual(imageOf("a.scn", []), ["512 x 512", "16"]);
  assert.deepEqual(imageOf("a.scn", ["-width", "20"]), ["20 x 256", "16"]);
  assert.deepEqual(imageOf("a.scn", ["-samples", "2"]), ["512 x 512", "2"]);
  assert.deepEqual(imageOf("b.scn", []), ["512 x 512", "3"]);
});

test("a broken image is refused by its name", async () => {
  for (const broken of [
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0]),
    Buffer.from([0xff, 0xd8, 0xff, 0]),
    Buffer.from("P6\n9999999 9999999\n255\n"),
    Buffer.from("nonsense"),
  ]) {
    const engine = await engineWith(
      new Map([
        ["t.png", broken],
        ["s.scn", Buffer.from("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 t.png\n")],
      ]),
    );
    assert.throws(() => engine.open("s.scn"), /s\.scn:1:\d+: .*t\.png/);
  }
});

test("parts that no image has are refused", async () => {
  const engine = await engineWith();
  assert.throws(() => engine.renderPart(1, 1), /no scene is open/);
  engine.open("scenes/sphere.scn", size);
  for (const [index, of] of [[5, 2], [0, 0], [-1, 4], [1, 2 ** 21]])
    assert.throws(() => engine.renderPart(index, of), /no such part/);
  assert.throws(() => engine.takePart(1, 2, new Uint8Array(100)), /not a checkpoint/);
});

test("an image beyond the memory is refused", async () => {
  assert.match(
    await mistakeIn("sphere -1 0 0 0 1", ["-width", "16000", "-height", "16000"]),
    /more than the limit of 3\.00 GiB/,
  );
  assert.match(await mistakeIn("sphere -1 0 0 0 1", ["-memory", "0.01", "-width", "900"]), /more than the limit/);
});

test("a scene of 100,000 levels needs no deeper stack", async () => {
  const deep =
    "begin -1 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n".repeat(100_000) + "sphere -1 0 0 0 1\n" + "end\n".repeat(100_000);
  assert.equal(await mistakeIn(deep, ["-width", "8", "-height", "8"]), "");
});

test("an engine goes on after a mistake", async () => {
  const engine = await engineWith();
  engine.putFile("bad.scn", Buffer.from("nonsense"));
  for (let i = 0; i < 100; ++i) assert.throws(() => engine.open("bad.scn"), Mistake);
  engine.open("scenes/sphere.scn", size);
  while (engine.renderPart(1, 1).hasMore) continue;
  while (engine.finishRound()) continue;
  assert.equal(sha(engine.film("image.pfm")), sha(native("scenes/sphere.scn", size)));
});

test("every PNG is read as raypro does, and written", async () => {
  for (const file of ["checker", "wood", "studs", "tiles", "relief"]) {
    execFileSync(RAYIMG, ["convert", `scenes/textures/${file}.png`, folder + "/as.ppm"]);
    const ours = await ppmOfPng(readFileSync(`scenes/textures/${file}.png`));
    assert.deepEqual(Buffer.from(ours), readFileSync(folder + "/as.ppm"), file);
  }
  const rgba = Uint8Array.from({ length: 4 * 7 * 5 }, (_, i) => (i % 4 === 3 ? 255 : i * 37));
  writeFileSync(
    folder + "/ours.png",
    Buffer.from(await (await pngOfRgba(rgba, 7, 5, { command: "raypro a.scn" })).arrayBuffer()),
  );
  execFileSync(RAYIMG, ["convert", folder + "/ours.png", folder + "/back.ppm"]);
  assert.deepEqual(readFileSync(folder + "/back.ppm").subarray(-105), Buffer.from(rgba.filter((_, i) => i % 4 !== 3)));
});
