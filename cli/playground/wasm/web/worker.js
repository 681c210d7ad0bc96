// The program in a thread of its own: runs in a worker, whose code is the text of this function.
"use strict";

function programThread() {
  const decoder = new TextDecoder(), encoder = new TextEncoder();
  const invalid = 28, notThere = 44;  // errors of WASI
  let program = null;

  const view = () => new DataView(program.memory.buffer);
  const bytes = (at, size) => new Uint8Array(program.memory.buffer, at, size);

  /** What the program writes; it has nothing to say but why it ends. */
  function write(file, list, count, written) {
    let size = 0;
    for (let i = 0; i < count; ++i) {
      const at = view().getUint32(list + 8 * i, true), length = view().getUint32(list + 8 * i + 4, true);
      console.log(decoder.decode(bytes(at, length)));
      size += length;
    }
    view().setUint32(written, size, true);
    return 0;
  }

  const system = {
    fd_write: write,
    fd_read: () => invalid,
    fd_close: () => 0,
    fd_seek: () => invalid,
    fd_fdstat_get: () => notThere,
    environ_sizes_get: (count, size) => { view().setUint32(count, 0, true); view().setUint32(size, 0, true); return 0; },
    environ_get: () => 0,
    clock_time_get: (clock, precision, time) => {
      view().setBigUint64(time, BigInt(Math.round(1e6 * performance.now())), true);
      return 0;
    },
    proc_exit: (code) => { throw new Error(`the program has ended with exit code ${code}`); },
  };

  async function start(code) {
    const { instance } = await WebAssembly.instantiate(code, { wasi_snapshot_preview1: system });
    program = instance.exports;
    program._initialize();
  }

  /** The answer to a request as the program gives it, both as JSON. */
  function answer(request) {
    const text = encoder.encode(request), place = program.af2Reserve(text.length);
    bytes(place, text.length).set(text);
    const result = program.af2Answer();
    return decoder.decode(bytes(result, program.af2AnswerSize()));
  }

  let started = null;
  self.addEventListener("message", async ({ data }) => {
    if (data.code) { started = start(data.code); return; }
    try {
      await started;
      self.postMessage({ answer: answer(data.request) });
    } catch (error) {
      self.postMessage({ fault: String(error.message ?? error) });
    }
  });
}
