"use strict";

/* One case: what it is, what came out, its body and the command that computes it again. Shown where
   the page's address ends in #case=KEY, or in #case=KEY?CHOICE with the explorer's choice to go back to. */
(function () {
  const start = "#case=";
  const dialog = document.createElement("dialog");
  dialog.id = "case";
  dialog.setAttribute("aria-label", "case");
  document.body.append(dialog);

  const element = (name, text, further = {}) => Object.assign(document.createElement(name), { textContent: text ?? "" }, further);
  const words = (text) => (text ?? "").replaceAll("_", " ");

  function rows(role, place) {
    const found = allCases.namesOf(role).map((name) => [allCases.heading(name), allCases.shown(name, place), name]);
    return found.filter(([, value]) => value !== null);
  }

  function tableOf(title, entries) {
    const table = element("table");
    table.createCaption().textContent = title;
    const body = table.createTBody();
    for (const [label, value] of entries) {
      const row = body.insertRow();
      row.append(element("th", label, { scope: "row" }));
      row.insertCell().textContent = String(value);
    }
    return table;
  }

  function command(place) {
    const text = allCases.value("command", place);
    if (!text) return [element("p", "It was measured elsewhere, so there is no command that computes it.")];
    const copy = element("button", "Copy", { type: "button" });
    copy.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(text);
        copy.textContent = "Copied";
      } catch {  // browsers refuse it to some pages from files
        getSelection().selectAllChildren(line);
        copy.textContent = "Marked";
      }
    });
    const line = element("pre", text);
    const notes = [];
    if (!allCases.value("reference", place)) notes.push("It was computed without a reference; run holds the same state against the usual one.");
    if (text.includes(".toml")) notes.push("The scene's file is meant, whose folder is not known here.");
    if (allCases.value("body", place) === "file") notes.push("Its mesh is a file, whose name is not known here: add --mesh FILE.msh.");
    return [element("h3", "Compute it again"), line, copy, ...(notes.length ? [element("p", notes.join(" "), { className: "note" })] : [])];
  }

  function bodyLink(key) {
    const viewer = [...document.querySelectorAll(".viewer")].find((one) => one.hasCase?.(key));
    if (!viewer) return [];
    const button = element("button", "Look at its body", { type: "button", className: "body" });
    button.addEventListener("click", () => {
      close();
      viewer.showCase(key);
      bringToTop(viewer);
    });
    return [button];
  }

  function fill(key) {
    const places = allCases.withKey(key);
    const out = element("button", "Close", { type: "button", className: "close" });
    out.addEventListener("click", close);
    if (places.length !== 1) {
      const said = places.length ? `${places.length} cases of ${allCases.file} begin so.` : `${allCases.file} holds ${allCases.count} cases, and none of that key.`;
      dialog.replaceChildren(out, element("h2", `No case ${key}`), element("p", said));
      return;
    }
    const [place] = places;
    const name = (column) => allCases.value(column, place);
    const title = [name("name"), name("scene"), name("cells"), name("load")].filter(Boolean).join(", ");
    const status = element("p", `${words(name("status"))}${name("reason") ? `: ${name("reason")}` : ""}`);
    const whole = [["key", name("key")], ...["material", "reference", "judge"].filter(name).map((column) => [allCases.heading(column), name(column)])];
    dialog.replaceChildren(out, element("h2", title), status, ...bodyLink(name("key")), ...command(place),
      tableOf("What came out", rows("measure", place)), tableOf("Settings", rows("setting", place)),
      tableOf("Case", whole));
  }

  function close() {
    dialog.close();
  }
  dialog.addEventListener("close", () => {
    if (!location.hash.startsWith(start)) return;
    const choice = location.hash.split("?")[1];
    history.replaceState(null, "", choice ? `#explore?${choice}` : before || "#");
  });
  let before = "";
  function follow(event) {
    if (!location.hash.startsWith(start)) {
      if (dialog.open) close();
      return;
    }
    const old = event?.oldURL ? new URL(event.oldURL).hash : "";
    if (!old.startsWith(start)) before = old;
    fill(location.hash.slice(start.length).split("?")[0]);
    if (!dialog.open) dialog.showModal();
    dialog.scrollTop = 0;
  }
  window.addEventListener("hashchange", follow);
  follow();
})();
