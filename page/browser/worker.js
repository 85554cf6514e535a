// One worker renders one part of an image; the first also joins the parts and answers questions about pixels.
//   in    {module}  then  {files, scene, options, index, of}  then  {parts}, {round}, {pixel}, {film}
//   out   {ready}, {opened}, {mistake}, {pass}, {part}, {round}, {finished}, {rays}, {file}
import { Engine, Mistake } from "./engine.js";

let engine = null,
  job = null;

const post = (message, transfer = []) =>
  self.postMessage(
    message,
    transfer.map((bytes) => bytes.buffer),
  );

/// Lets messages in between two passes.
const turn = () => new Promise((resolve) => setTimeout(resolve));

async function renderRound() {
  for (let hasMore = true; hasMore; await turn()) {
    const pass = engine.renderPart(job.index, job.of);
    hasMore = pass.hasMore;
    post({ pass: pass.rgba, index: job.index }, [pass.rgba]);
  }
  if (job.index > 1) {
    const part = engine.part();
    post({ part, index: job.index }, [part]);
  } else {
    post({ part: null, index: 1 });
  }
}

async function finishRound(parts) {
  for (const [index, bytes] of parts) engine.takePart(index, job.of, bytes);
  const round = engine.finishRound();
  if (round) {
    post({ round });
    return renderRound();
  }
  const ppm = engine.film("image.ppm");
  post({ finished: ppm }, [ppm]);
}

async function answer(message) {
  if (message.module) {
    engine = await Engine.start(message.module);
    post({ ready: true, modes: engine.list("modes") });
  } else if (message.scene) {
    job = message;
    for (const [name, bytes] of message.files) engine.putFile(name, bytes);
    const warnings = engine.open(message.scene, message.options);
    post({ opened: engine.region, warnings, index: job.index });
    await turn();
    await renderRound();
  } else if (message.parts) {
    await finishRound(message.parts);
  } else if (message.round) {
    engine.takeRound(message.round);
    await renderRound();
  } else if (message.pixel) {
    post({ rays: engine.raysOf(...message.pixel), pixel: message.pixel });
  } else if (message.film) {
    const file = engine.film(message.film);
    post({ file, name: message.film }, [file]);
  }
}

self.onmessage = async ({ data }) => {
  try {
    await answer(data);
  } catch (error) {
    const known = error instanceof Mistake;
    const text = known
      ? error.message
      : "the engine failed: " +
        error.message +
        (error instanceof RangeError || /unreachable|stack|memory/.test(error.message)
          ? " (too deep, or too little memory)"
          : "");
    post({
      mistake: text,
      kind: known ? error.kind : "engine",
      index: job?.index ?? 1,
      about: data.pixel ? "pixel" : "image",
    });
  }
};
