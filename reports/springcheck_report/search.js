"use strict";

/* Search over sections, figures, tables and cases of the page. */
(function () {
  const most = 12;  // of each kind
  const field = document.getElementById("search");
  const panel = document.getElementById("found");
  const [status, list] = [panel.querySelector("p"), panel.querySelector("ul")];
  const heads = [["section", "Sections"], ["table", "Tables"], ["figure", "Figures"], ["case", "Cases"]];

  /* What stands above an element and names it: the nearest heading. */
  function heading(element, section) {
    let found = section.querySelector("h2");
    for (const head of section.querySelectorAll("h3, h4"))
      if (head.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING) found = head;
    return found.textContent;
  }

  /* [{kind, title, detail, words, target}], made when it is first asked for. */
  let entries = null;
  function index() {
    if (entries) return entries;
    entries = [];
    const add = (kind, title, detail, target, further = "") => {
      const words = `${title} ${detail} ${further}`.toLowerCase();
      entries.push({ kind, title, detail, words, target });
    };
    for (const section of document.querySelectorAll("main > section")) {
      const name = section.querySelector("h2").textContent;
      const inside = [...section.querySelectorAll("h3, h4")].map((head) => head.textContent).join(" ");
      add("section", name, "", section, `${inside} ${section.id}`);
      for (const table of section.querySelectorAll("table"))
        add("table", heading(table, section), name, table, `${table.id} ${table.tHead.textContent}`);
      for (const figure of section.querySelectorAll("figure"))
        add("figure", figure.querySelector("img").alt, name, figure, figure.id);
    }
    if (typeof allCases === "undefined" || !allCases.isThere) return entries;
    for (let place = 0; place < allCases.count; ++place) {
      const of = (name) => allCases.value(name, place);
      const nu = of("nu") === null ? null : `nu ${of("nu")}`;
      const title = [of("name"), of("scene"), nu, of("load"), of("status"), of("cells")].filter(Boolean).join(", ");
      add("case", title.replaceAll("_", " "), of("key").slice(0, 8), of("key"), `${of("test")} ${of("key")}`);
    }
    return entries;
  }

  function found(text) {
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    if (!words.length) return [];
    return index().filter((entry) => words.every((word) => entry.words.includes(word)));
  }

  async function show() {
    if (typeof allCases !== "undefined") await allCases.ready.catch(() => {});
    const hits = found(field.value);
    panel.hidden = !field.value.trim();
    status.textContent = hits.length
      ? heads.map(([kind]) => [hits.filter((hit) => hit.kind === kind).length, kind]).filter(([count]) => count)
          .map(([count, kind]) => `${count} ${kind}${count === 1 ? "" : "s"}`).join(", ")
      : "Nothing on this page has all of these words.";
    list.replaceChildren();
    for (const [kind, name] of heads) {
      const own = hits.filter((hit) => hit.kind === kind);
      if (!own.length) continue;
      const head = document.createElement("li");
      head.className = "head";
      head.textContent = own.length > most ? `${name}, the first ${most} of ${own.length}` : name;
      list.append(head, ...own.slice(0, most).map(item));
    }
  }

  function item(entry) {
    const [line, link, detail] = ["li", "a", "span"].map((name) => document.createElement(name));
    const isCase = entry.kind === "case";
    link.href = isCase ? `#case=${entry.target}` : `#${entry.target.id}`;
    link.textContent = entry.title;
    detail.className = "note";
    detail.textContent = entry.detail;
    link.append(" ", detail);
    link.addEventListener("click", (event) => {
      panel.hidden = true;
      if (isCase) return;
      event.preventDefault();
      go(entry.target);
    });
    line.append(link);
    return line;
  }

  /* Opens what the target is folded into. */
  function go(target) {
    for (let fold = target.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
    history.pushState(null, "", `#${target.id}`);
    target.tabIndex = -1;
    target.focus({ preventScroll: true });
    bringToTop(target);
    for (const before of document.querySelectorAll(".sought")) before.classList.remove("sought");
    target.classList.add("sought");
  }

  const links = () => [...list.querySelectorAll("a")];
  function move(step) {
    const all = links();
    const place = all.indexOf(document.activeElement) + step;
    (place < 0 ? field : all[Math.min(place, all.length - 1)])?.focus();
  }
  field.addEventListener("input", show);
  field.addEventListener("focus", show);
  panel.parentElement.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") move(1);
    else if (event.key === "ArrowUp") move(-1);
    else if (event.key === "Enter" && event.target === field) links()[0]?.click();
    else if (event.key === "Escape") { field.focus(); panel.hidden = true; }
    else return;
    event.preventDefault();
  });
  panel.parentElement.addEventListener("focusout", (event) => {
    if (event.relatedTarget && !panel.parentElement.contains(event.relatedTarget)) panel.hidden = true;
  });
  document.addEventListener("click", (event) => {
    if (!panel.parentElement.contains(event.target)) panel.hidden = true;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
    event.preventDefault();
    field.focus();
  });
})();
