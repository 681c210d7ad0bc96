// The preview of a rule file: its rules, tests and a mesh, in the page of `af2 playground --watch`.
const { spawn } = require("child_process");
const vscode = require("vscode");

const previews = new Map(); // by path: the panel and the program

/// The address that the program prints first; rejected with its message if it ends instead.
function addressOf(program) {
  return new Promise((resolve, reject) => {
    let output = "", errors = "";
    program.stdout.on("data", (data) => {
      output += data;
      if (output.includes("\n")) resolve(output.split("\n", 1)[0]);
    });
    program.stderr.on("data", (data) => { errors += data; });
    program.on("error", reject);
    program.on("exit", () => reject(new Error(errors.trim() || "it ended")));
  });
}

function htmlFor(uri) {
  const origin = `${uri.scheme}://${uri.authority}`;
  const address = uri.toString(true).replace(/&/g, "&amp;").replace(/"/g, "&quot;");
  return `<!DOCTYPE html>
<html>
<head>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; frame-src ${origin}; style-src 'unsafe-inline'">
<style>html, body, iframe { width: 100%; height: 100%; margin: 0; padding: 0; border: 0; }</style>
</head>
<body><iframe title="AF2 preview" src="${address}"></iframe></body>
</html>`;
}

/// Shows the file as it is on disk; the page follows each time that it is saved.
async function showPreview(command, document) {
  const path = document.uri.fsPath;
  const known = previews.get(path);
  if (known) return known.panel.reveal(undefined, true);
  const program = spawn(command, ["playground", path, "--watch", "--port", "0"], { stdio: ["ignore", "pipe", "pipe"] });
  try {
    const address = await addressOf(program);
    const uri = await vscode.env.asExternalUri(vscode.Uri.parse(address));
    const name = path.split(/[\\/]/).pop();
    const panel = vscode.window.createWebviewPanel(
      "af2.preview", `Preview ${name}`, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true });
    panel.webview.html = htmlFor(uri);
    previews.set(path, { panel, program });
    panel.onDidDispose(() => {
      previews.delete(path);
      program.kill();
    });
  } catch (error) {
    program.kill();
    vscode.window.showErrorMessage(`'${command} playground' cannot be started: ${error.message}`);
  }
}

function closePreviews() {
  for (const { panel } of [...previews.values()]) panel.dispose();
}

module.exports = { showPreview, closePreviews };
