// A stand-in for VS Code: as much of its interface as the extension of AF2 uses.
const { spawn } = require("child_process");
const fs = require("fs");
const { pathToFileURL } = require("url");

class Uri {
  constructor(text) { this.text = text; }
  static parse(text) { return new Uri(text); }
  static file(path) { return new Uri(pathToFileURL(path).href); }
  get scheme() { return new URL(this.text).protocol.slice(0, -1); }
  get authority() { return new URL(this.text).host; }
  get path() { return decodeURIComponent(new URL(this.text).pathname); }
  get fsPath() { return this.path; }
  toString() { return this.text; }
}

/// A language client that speaks to the real server.
class LanguageClient {
  constructor(id, name, server) {
    Object.assign(this, { server, number: 0, waiting: new Map(), input: Buffer.alloc(0) });
  }

  async start() {
    this.process = spawn(this.server.command, this.server.args, { stdio: ["pipe", "pipe", "inherit"] });
    this.process.stdout.on("data", (data) => this.receive(data));
    await this.sendRequest("initialize", { capabilities: {
      textDocument: { documentSymbol: { hierarchicalDocumentSymbolSupport: true } } } });
    this.sendNotification("initialized", {});
  }

  async stop() {
    await this.sendRequest("shutdown", null);
    this.sendNotification("exit", null);
  }

  write(message) {
    const text = JSON.stringify({ jsonrpc: "2.0", ...message });
    this.process.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
  }

  sendNotification(method, params) { this.write({ method, params }); }

  sendRequest(method, params) {
    const id = ++this.number;
    this.write({ id, method, params });
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  receive(data) {
    this.input = Buffer.concat([this.input, data]);
    for (;;) {
      const begin = this.input.indexOf("\r\n\r\n") + 4;
      if (begin < 4) return;
      const end = begin + Number(/Content-Length: (\d+)/.exec(this.input.toString("latin1", 0, begin))[1]);
      if (this.input.length < end) return;
      const message = JSON.parse(this.input.subarray(begin, end).toString("utf8"));
      this.input = this.input.subarray(end);
      const asked = !message.method && this.waiting.get(message.id);
      if (asked && message.error) asked.reject(new Error(message.error.message));
      else if (asked) asked.resolve(message.result);
    }
  }
}

class TestItem {
  constructor(id, label, uri) {
    Object.assign(this, { id, label, uri, children: new TestItems(this) });
  }
}

class TestItems {
  constructor(parent) { Object.assign(this, { parent, items: new Map() }); }
  add(item) { item.parent = this.parent; this.items.set(item.id, item); }
  get(id) { return this.items.get(id); }
  delete(id) { this.items.delete(id); }
  forEach(visit) { this.items.forEach(visit); }
  replace(items) { this.items.clear(); for (const item of items) this.add(item); }
}

/// `editor` records what the extension does; `vscode` is the module that it sees.
function makeEditor(program, folder) {
  const editor = { commands: new Map(), panels: [], messages: [], runs: [], client: null, controller: null };
  const nothing = () => ({ dispose() {} });
  const openDocuments = new Map();

  async function openTextDocument(uri) {
    const known = openDocuments.get(uri.toString());
    if (known) return known;
    const document = { uri, languageId: "af2", isUntitled: false, text: fs.readFileSync(uri.fsPath, "utf8") };
    openDocuments.set(uri.toString(), document);
    editor.client.sendNotification("textDocument/didOpen", { textDocument:
      { uri: uri.toString(), languageId: "af2", version: 1, text: document.text } });
    return document;
  }

  function createTestRun() {
    const run = { results: new Map(), started: () => {}, end: () => { run.isOver = true; } };
    for (const kind of ["passed", "failed", "errored"])
      run[kind] = (item, messages) => run.results.set(item.label, { kind, messages });
    editor.runs.push(run);
    return run;
  }

  function createTestController() {
    const items = new TestItems(undefined);
    editor.controller = { items, createTestRun, dispose() {},
      createTestItem: (id, label, uri) => new TestItem(id, label, uri),
      createRunProfile: (label, kind, run) => { editor.run = run; } };
    return editor.controller;
  }

  function createWebviewPanel(type, title, column, options) {
    const panel = { type, title, options, webview: {}, shown: 1, reveal: () => { ++panel.shown; },
      onDidDispose: (action) => { panel.disposed = action; }, dispose: () => panel.disposed() };
    editor.panels.push(panel);
    return panel;
  }

  const vscode = {
    Uri,
    Position: class { constructor(line, character) { Object.assign(this, { line, character }); } },
    Location: class { constructor(uri, range) { Object.assign(this, { uri, range }); } },
    TestMessage: class { constructor(message) { this.message = message; } },
    Disposable: { from: nothing },
    ViewColumn: { Beside: -2 },
    TestRunProfileKind: { Run: 1 },
    env: { asExternalUri: async (uri) => uri },
    tests: { createTestController },
    commands: {
      registerCommand: (name, action) => { editor.commands.set(name, action); return nothing(); },
      executeCommand: async (name, uri) => {
        if (name !== "vscode.executeDocumentSymbolProvider") throw new Error(name);
        return editor.client.sendRequest("textDocument/documentSymbol", { textDocument: { uri: uri.toString() } });
      },
    },
    window: {
      createOutputChannel: () => ({ appendLine() {}, show() {}, dispose() {} }),
      createWebviewPanel,
      showInformationMessage: (text) => { editor.messages.push(text); },
      showErrorMessage: (text) => { editor.messages.push(text); },
      get activeTextEditor() { return editor.active; },
    },
    workspace: {
      getConfiguration: () => ({ get: (name) => ({ path: program.path, checks: true, checkDelay: 0 })[name] }),
      onDidChangeConfiguration: nothing, onDidOpenTextDocument: nothing, onDidSaveTextDocument: nothing,
      textDocuments: [],
      openTextDocument,
      findFiles: async () => fs.readdirSync(folder).filter((name) => name.endsWith(".af2"))
        .map((name) => Uri.file(`${folder}/${name}`)),
    },
  };
  const client = { LanguageClient: class extends LanguageClient {
    constructor(...parameters) { super(...parameters); editor.client = this; }
  } };
  return { editor, vscode, client };
}

module.exports = { makeEditor, Uri };
