// Starts `torse lsp` for files of TOML; `torse` is on the path.
const { LanguageClient } = require("vscode-languageclient/node");

let client;

exports.activate = () => {
  const server = { command: "torse", args: ["lsp"] };
  const texts = { documentSelector: [{ scheme: "file", language: "toml" }] };
  client = new LanguageClient("torse", "torse", server, texts);
  return client.start();
};

exports.deactivate = () => client && client.stop();
