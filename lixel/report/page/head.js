// The head of a page: what was run, and how to run it again.

function showFacts(facts) {
  byId("facts").append(...Object.entries(facts).filter(([, value]) => value !== "")
    .map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, String(value)))));
  byId("command").textContent = run.command;
  byId("copy").addEventListener("click", copyCommand);
}

// From a file the clipboard may be refused; the command is then selected, ready for the keyboard.
async function copyCommand() {
  try {
    await navigator.clipboard.writeText(run.command);
    byId("copy").textContent = "Copied";
  } catch {
    getSelection().selectAllChildren(byId("command"));
    byId("copy").textContent = "Selected";
  }
  setTimeout(() => { byId("copy").textContent = "Copy"; }, 2000);
}
