// The scenes whose bytes are compared, and how the files of a scene become what the engine reads.
import { readFileSync, readdirSync, statSync } from "node:fs";
import { isPng, ppmOfPng } from "../browser/png.js";

// Scenes that take more than about a second with their own options.
const leftOut = /thumbnails|README|many_lights|depth\.txt/;
const isYaml = ({ name }) => /\.ya?ml$/.test(name);

export const size = ["-width", "64", "-height", "48", "-samples", "1"];

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

/// At most 48 scenes with the options of their first comment: COMP30019's, then JSON, then .scn.
export function scenes(examples) {
  const order = (name) => (name.endsWith(".txt") ? 0 : name.endsWith(".json") ? 1 : 2);
  return examples.scenes
    .filter((scene) => !leftOut.test(scene.name) && !isYaml(scene))
    .sort((a, b) => order(a.name) - order(b.name))
    .slice(0, 48);
}

/// Those of scenes/ in YAML, which a page reads only if it was built with yaml-cpp.
export const yamlScenes = (examples) =>
  examples.scenes.filter((scene) => scene.name.startsWith("scenes/") && isYaml(scene));
