// The test explorer: the tests and properties of rule files, which the language server finds and runs.
const vscode = require("vscode");

/// `request(command, argument, token)` runs a command of the language server.
function makeTestExplorer(request) {
  const controller = vscode.tests.createTestController("af2", "AF2 rules");

  function fileItem(uri) {
    const id = uri.toString();
    let item = controller.items.get(id);
    if (!item) {
      item = controller.createTestItem(id, uri.path.split("/").pop(), uri);
      item.canResolveChildren = true;
      controller.items.add(item);
    }
    return item;
  }

  /// The outline names the kind of each item.
  async function readTests(uri) {
    const symbols = await vscode.commands.executeCommand("vscode.executeDocumentSymbolProvider", uri) || [];
    const found = symbols.filter((symbol) => symbol.detail === "test" || symbol.detail === "property");
    if (found.length === 0) return controller.items.delete(uri.toString());
    fileItem(uri).children.replace(found.map((symbol) => {
      const item = controller.createTestItem(`${uri} ${symbol.name}`, symbol.name, uri);
      item.range = symbol.range;
      return item;
    }));
  }

  controller.resolveHandler = async (item) => {
    const uris = item ? [item.uri] : await vscode.workspace.findFiles("**/*.af2");
    for (const uri of uris) {
      await vscode.workspace.openTextDocument(uri); // the language server answers about open files
      await readTests(uri);
    }
  };

  function messagesOf(result, uri) {
    return result.failures.map((failure) => {
      const text = `expected ${failure.expected}, got ${failure.got}`;
      const message = new vscode.TestMessage(result.explanation ? `${text}\n${result.explanation}` : text);
      message.location = new vscode.Location(uri, new vscode.Position(failure.line - 1, 0));
      return message;
    });
  }

  function report(run, item, results) {
    const result = results.find((r) => r.title === item.label);
    if (!result) run.errored(item, new vscode.TestMessage("The file has no such test any more."));
    else if (result.passed) run.passed(item);
    else run.failed(item, messagesOf(result, item.uri));
  }

  async function runFile(run, file, items, token) {
    for (const item of items) run.started(item);
    try {
      const argument = { uri: file.uri.toString(), titles: items.map((item) => item.label) };
      const { results } = await request("af2.test", argument, token);
      for (const item of items) report(run, item, results);
    } catch (error) {
      for (const item of items) run.errored(item, new vscode.TestMessage(error.message));
    }
  }

  function childrenOf(item) {
    const children = [];
    item.children.forEach((child) => children.push(child));
    return children;
  }

  /// The chosen tests by file, without those that are excluded.
  function chosenTests(asked) {
    const files = new Map();
    const add = (file, item) => {
      // By id, because a file that is read again has new items.
      if ((asked.exclude || []).some((other) => other.id === item.id || other.id === file.id)) return;
      files.set(file, [...(files.get(file) || []), item]);
    };
    const roots = [];
    controller.items.forEach((file) => roots.push(file));
    for (const item of asked.include || roots) {
      if (item.parent) add(item.parent, item);
      else for (const child of childrenOf(item)) add(item, child);
    }
    return files;
  }

  async function runTests(asked, token) {
    if (!asked.include) await controller.resolveHandler();
    for (const item of asked.include || []) if (!item.parent) await controller.resolveHandler(item);
    const run = controller.createTestRun(asked);
    for (const [file, items] of chosenTests(asked))
      if (!token.isCancellationRequested) await runFile(run, file, items, token);
    run.end();
  }

  controller.createRunProfile("Run", vscode.TestRunProfileKind.Run, runTests, true);

  const update = (document) => (document.languageId === "af2" ? readTests(document.uri) : undefined);
  const listeners = [
    vscode.workspace.onDidOpenTextDocument(update),
    vscode.workspace.onDidSaveTextDocument(update),
  ];
  for (const document of vscode.workspace.textDocuments) update(document);
  return vscode.Disposable.from(controller, ...listeners);
}

module.exports = { makeTestExplorer };
