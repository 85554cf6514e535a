// The scenes whose bytes are compared, and how the files of a scene become what the engine reads.
import { readFileSync, readdirSync, statSync } from "node:fs";
import { isPng, ppmOfPng } from "../../source/web/page/png.js";

// Scenes that take more than about a second with their own options, and YAML, which a page does not read.
const leftOut = /thumbnails|README|\.ya?ml$|many_lights|depth\.txt/;

export const size = ["-width", "64", "-height", "48"];

async function read(folder, files) {
  for (const name of readdirSync(folder).sort()) {
    const path = folder + "/" + name;
    if (leftOut.test(path)) continue;
    if (statSync(path).isDirectory()) await read(path, files);
    else files.set(path, isPng(readFileSync(path)) ? await ppmOfPng(readFileSync(path)) : readFileSync(path));
  }
  return files;
}

/// All files of scenes/, images as PPM.
export const files = () => read("scenes", new Map());

/// At most 48 scenes with the options of their first comment: .scn, then JSON, then COMP30019's.
export function scenes(examples) {
  const order = (name) => (name.endsWith(".txt") ? 0 : name.endsWith(".json") ? 1 : 2);
  return examples.scenes
    .filter(({ name }) => !leftOut.test(name))
    .sort((a, b) => order(a.name) - order(b.name))
    .slice(0, 48);
}
