// Answers what the page of the playground asks its server, by the program in a worker. Saving is a download.
"use strict";

(() => {
  const limit = 15;  // seconds
  const chosen = new URLSearchParams(location.search).get("file") ?? "tri/even.af2";
  const code = Uint8Array.from(atob(programCode), (letter) => letter.charCodeAt(0));
  const waiting = [];  // requests, oldest first
  let worker = null, current = null, timer = 0;

  function startWorker() {
    const source = new Blob([`"use strict";\n${programThread}\nprogramThread();`], { type: "text/javascript" });
    worker = new Worker(URL.createObjectURL(source));
    worker.postMessage({ code });
    worker.onmessage = ({ data }) => finish(data.fault ? { fault: data.fault } : JSON.parse(data.answer));
    worker.onerror = (event) => { restart(); finish({ fault: event.message || "The program has crashed." }); };
  }

  function restart() {
    worker.terminate();
    worker = null;
  }

  function finish(answer) {
    clearTimeout(timer);
    const { resolve } = current;
    current = null;
    resolve(answer);
    next();
  }

  /** One request at a time; one that goes on for too long ends with its worker. */
  function next() {
    if (current || waiting.length === 0) return;
    current = waiting.shift();
    if (!worker) startWorker();
    timer = setTimeout(() => { restart(); finish({ fault: `Stopped after ${limit} s.` }); }, 1000 * limit);
    worker.postMessage({ request: JSON.stringify(current.request) });
  }

  const aborted = () => new DOMException("overtaken", "AbortError");

  function ask(request, signal) {
    return new Promise((resolve, reject) => {
      const entry = { request, resolve };
      waiting.push(entry);
      signal?.addEventListener("abort", () => {
        const place = waiting.indexOf(entry);
        if (place >= 0) waiting.splice(place, 1);
        entry.resolve = () => {};
        reject(aborted());
      });
      next();
    });
  }

  function download(text) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    link.download = chosen.replace(/.*\//, "");
    link.click();
    URL.revokeObjectURL(link.href);
    return { version: "1" };
  }

  /** The files to begin with stand where the name of the file is. */
  function offerFiles(names) {
    const choice = document.createElement("select");
    choice.id = "start";
    choice.title = "Begin with another rule file";
    choice.append(...names.map((name) => new Option(name, name, false, name === chosen)));
    choice.addEventListener("change", () => { location.search = new URLSearchParams({ file: choice.value }); });
    document.getElementById("state").before(choice);
    document.getElementById("name").style.display = "none";  // the choice shows it
  }

  async function file() {
    const answer = await ask({ kind: "file", name: chosen });
    offerFiles(answer.files);
    return { ...answer, version: "1", fault: "", watches: false, seconds: limit };
  }

  async function answerTo(kind, parameters, text, signal) {
    if (kind === "file") return file();
    if (kind === "state") return { version: "1", imports: "" };
    if (kind === "save") return download(text);
    if (kind === "completion" || kind === "hover") return null;
    const answer = await ask({ ...parameters, kind, text, name: chosen }, signal);
    if (kind === "checks") answer.fault = "`af2 check` looks at all matches, too";
    return answer;
  }

  const network = window.fetch;
  window.fetch = async (address, options = {}) => {
    const [kind, query] = String(address).split("?");
    if (!/^[a-z]+$/.test(kind)) return network(address, options);
    const parameters = Object.fromEntries(new URLSearchParams(query ?? ""));
    const answer = await answerTo(kind, parameters, options.body ?? "", options.signal);
    return { ok: true, json: async () => answer, text: async () => "" };
  };
})();
