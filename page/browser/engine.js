// The engine: one instance of raypro.wasm and calls that take and give strings and bytes. Runs in workers and in Node.

// What a page answers where a program would ask the system: no files, no arguments, a clock.
function system(memory) {
  const view = () => new DataView(memory().buffer);
  const none = 8; // EBADF
  const nothing = (count, size) => {
    view().setUint32(count, 0, true);
    view().setUint32(size, 0, true);
    return 0;
  };
  const known = {
    clock_time_get(clock, precision, at) {
      view().setBigUint64(at, BigInt(Math.round(1e6 * (performance.timeOrigin + performance.now()))), true);
      return 0;
    },
    environ_sizes_get: nothing,
    args_sizes_get: nothing,
    environ_get: () => 0,
    args_get: () => 0,
    proc_exit(status) {
      throw new Error("the engine ended with status " + status);
    },
    fd_write(file, vectors, count, written) {
      let bytes = 0;
      for (let i = 0; i < count; ++i) bytes += view().getUint32(vectors + 8 * i + 4, true);
      view().setUint32(written, bytes, true);
      return 0;
    },
  };
  return new Proxy({}, { get: (_, name) => known[name] || (() => none) });
}

/// A mistake in the scene or in the options, in raypro's own words.
export class Mistake extends Error {
  constructor(message, kind) {
    super(message);
    this.kind = kind;
  }
}

export class Engine {
  /// From the compiled module.
  static async start(module) {
    let memory = null;
    const wasi = system(() => memory);
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ||= {})[name] = wasi[name];
    const instance = await WebAssembly.instantiate(module, imports);
    memory = instance.exports.memory;
    instance.exports._initialize?.();
    return new Engine(instance.exports);
  }

  constructor(exports) {
    this.exports = exports;
  }

  /// Copies a string or bytes into the engine's memory for the time of a call.
  #lend(values, call) {
    const lent = values.map((value) => {
      const bytes = typeof value === "string" ? new TextEncoder().encode(value + "\0") : value;
      const at = this.exports.allocate(bytes.length);
      if (at === 0) throw new Mistake("there is not enough memory", "memory");
      new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
      return [at, bytes.length];
    });
    try {
      return call(...lent);
    } finally {
      for (const [at] of lent) this.exports.release(at);
    }
  }

  #text() {
    const { memory, text, text_size } = this.exports;
    return new TextDecoder().decode(new Uint8Array(memory.buffer, text(), text_size()));
  }
  #bytes() {
    const { memory, bytes, bytes_size } = this.exports;
    return new Uint8Array(memory.buffer, bytes(), bytes_size()).slice();
  }
  /// A status, unless it stands for a mistake.
  #checked(status) {
    if (status < 0) throw new Mistake(this.#text(), status === -2 ? "options" : status === -3 ? "scene" : "engine");
    return status;
  }

  putFile(name, bytes) {
    this.#checked(this.#lend(["/" + name, bytes], ([at], [data, size]) => this.exports.put_file(at, data, size)));
  }
  removeFiles() {
    this.exports.remove_files();
  }
  /// Opens a scene that was put; `options` are words of raypro's command line. Returns the warnings.
  open(name, options = []) {
    const words = [name, "image.ppm", ...options].join("\n");
    this.#checked(this.#lend([words], ([at]) => this.exports.open(at)));
    return this.#text();
  }
  /// What -list prints of a subject.
  list(subject) {
    this.#checked(this.#lend([subject], ([at]) => this.exports.list(at)));
    return this.#text();
  }
  check() {
    this.#checked(this.exports.check());
    return this.#text();
  }
  /// The rectangle of the whole image that is rendered; rows count from the bottom.
  get region() {
    const { left, bottom, width, height } = this.exports;
    return { left: left(), bottom: bottom(), width: width(), height: height() };
  }
  /// Takes a pass of samples. Returns whether more are due in this round, and the image so far.
  renderPart(index, of) {
    const hasMore = this.#checked(this.exports.render_part(index, of)) === 1;
    return { hasMore, rgba: this.#bytes() };
  }
  part() {
    this.#checked(this.exports.part());
    return this.#bytes();
  }
  takePart(index, of, bytes) {
    this.#checked(this.#lend([bytes], ([at, size]) => this.exports.take_part(index, of, at, size)));
  }
  takeRound(bytes) {
    this.#checked(this.#lend([bytes], ([at, size]) => this.exports.take_round(at, size)));
  }
  /// The state of the next round; null when the image is finished.
  finishRound() {
    return this.#checked(this.exports.finish_round()) === 1 ? this.#bytes() : null;
  }
  /// The finished image as a file.
  film(name) {
    this.#checked(this.#lend([name], ([at]) => this.exports.film(at)));
    return this.#bytes();
  }
  /// The rays of a pixel: what -debugpixel prints, and for each ray of that [kind, depth, x0, y0, x1, y1, look, ...], its
  /// lines in the image as page/PixelRays.h says.
  raysOf(x, y) {
    this.#checked(this.exports.debug_pixel(x, y));
    return { tree: this.#text(), lines: JSON.parse(new TextDecoder().decode(this.#bytes())) };
  }
}
