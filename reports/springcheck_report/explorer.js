"use strict";

/* Any cases of the file along any setting, several measures side by side. */
(function () {
  const root = document.querySelector(".explorer");
  const start = /^#(explore|case=[^?]*)\?/;
  const mostPanels = 4, mostRows = 300;
  const element = (name, further = {}) => Object.assign(document.createElement(name), further);
  const value = allCases.value;
  const { along, distinct, isNumber, ofTest, ok, settings, measures, tests } = selection;

  /* What is shown: y: measures; models: names of methods; fixed: {column: value as text}. */
  let choice = { test: null, x: null, y: [], models: [], fixed: {}, log: "" };
  const measured = (places) => selection.measured(choice.test, places);
  const models = (places) => selection.models(choice, places);

  /* -- Controls ----------------------------------------------------------------------------------- */

  const form = element("form", { className: "controls" });
  form.addEventListener("submit", (event) => event.preventDefault());
  const said = element("p", { className: "note said" });
  said.setAttribute("role", "status");
  const plot = element("div", { className: "plot" });
  const rings = element("div", { className: "rings" });
  const frame = element("div", { className: "frame" });
  frame.append(plot, rings);
  const readout = element("pre", { className: "readout", textContent: "Point at a mark to read it; click it to see its case." });
  const buttons = element("p", { className: "buttons" });
  const table = element("details", { className: "rows" });
  root.append(form, said, frame, readout, buttons, table);

  function labelled(text, control) {
    const label = element("label");
    label.append(`${text} `, control);
    return label;
  }
  function select(name, label, options, chosen, change) {
    const found = element("select", { name });
    for (const [text, title, group] of options) {
      let parent = found;
      if (group) {
        parent = [...found.querySelectorAll("optgroup")].find((one) => one.label === group) ?? element("optgroup", { label: group });
        found.append(parent);
      }
      parent.append(new Option(title, text, false, text === chosen));
    }
    found.addEventListener("change", () => change(found.value));
    return labelled(label, found);
  }
  function boxes(name, title, options, chosen, change) {
    const fold = element("details", { className: "boxes" });
    fold.dataset.name = name;
    fold.open = opened.has(name);
    fold.addEventListener("toggle", () => (fold.open ? opened.add(name) : opened.delete(name)));
    fold.append(element("summary", { textContent: title }));
    for (const [text, label, colour] of options) {
      const box = element("input", { type: "checkbox", name, value: text, checked: chosen.includes(text) });
      box.addEventListener("change", () => change([...fold.querySelectorAll("input:checked")].map((one) => one.value)));
      const line = element("label");
      line.append(box, ` ${label}`);
      if (colour) line.style.setProperty("--mark", colour);
      fold.append(line);
    }
    return fold;
  }
  const opened = new Set();

  function usualModels(places) {
    const kept = places.filter((place) => Object.entries(choice.fixed).every(([name, text]) => String(value(name, place)) === text));
    const all = models(kept.length ? kept : places);
    const own = all.filter((name) => allCases.usual.includes(name));
    return own.length ? own : all;
  }

  function fill() {
    const focused = document.activeElement?.form === form && document.activeElement;
    const again = focused && { name: focused.name, value: focused.type === "checkbox" ? focused.value : null };
    const places = ofTest(choice.test);
    const can = along(places);
    const title = (name) => allCases.heading(name);
    form.replaceChildren(
      select("test", "Test", tests.map((test) => [test, test]), choice.test, (test) => change({ test }, "x")),
      select("x", "Along x", [...can.settings.map((name) => [name, title(name), "settings"]), ...can.measures.map((name) => [name, title(name), "measures"])], choice.x,
        (x) => change({ x }, "fixed")),
      ...selection.fixable(choice, places).map((name) => {
        const values = distinct(places.map((place) => value(name, place)));
        const none = places.some((place) => value(name, place) === null) ? [["null", "none"]] : [];
        values.sort((a, b) => (isNumber(name) ? a - b : String(a).localeCompare(String(b), undefined, { numeric: true })));
        return select(`fixed.${name}`, allCases.column(name).label, [["", "any"], ...values.map((one) => [String(one), String(one)]), ...none], choice.fixed[name] ?? "", (text) => {
          const fixed = { ...choice.fixed, [name]: text };
          if (!text) delete fixed[name];
          change({ fixed });
        });
      }),
      boxes("y", `Measures: ${choice.y.length} of ${measured(places).length}`, measured(places).map((name) => [name, title(name)]), choice.y,
        (y) => { if (y.length) change({ y: [...choice.y.filter((name) => y.includes(name)), ...y.filter((name) => !choice.y.includes(name))].slice(-mostPanels) }); else fill(); }),
      boxes("m", `Methods: ${choice.models.length} of ${models(places).length}`, models(places).map((name) => [name, name, allCases.looks[name]?.colour]), choice.models,
        (models) => change({ models })),
      ...[["All methods", models(places)], ["The usual ones", usualModels(places)]].map(([textContent, own]) => {
        const button = element("button", { type: "button", name: textContent, textContent });
        button.addEventListener("click", () => change({ models: own }));
        return button;
      }),
      ...["x", "y"].map((axis) => {
        const box = element("input", { type: "checkbox", name: `log-${axis}`, checked: choice.log.includes(axis) });
        box.addEventListener("change", () => change({ log: box.checked ? choice.log + axis : choice.log.replace(axis, "") }));
        return labelled(`log ${axis}`, box);
      }));
    if (again) [...form.elements].find((one) => one.name === again.name && (again.value === null || one.value === again.value))?.focus();
  }

  /* -- Drawing ------------------------------------------------------------------------------------ */

  let current = [];
  let isSeen = false;
  function draw() {
    fill();
    const found = selection.shown(choice);
    current = found.curves;
    const count = current.reduce((sum, { places }) => sum + places.length, 0);
    const bad = current.flatMap(({ places }) => places).filter((place) => !ok(place));
    const by = distinct(bad.map((place) => value("status", place)));
    const failures = by.map((status) => `${bad.filter((place) => value("status", place) === status).length} ${status.replaceAll("_", " ")}`);
    const places = current.flatMap((curve) => curve.places);
    const lost = places.filter((place) => (choice.log.includes("x") && value(choice.x, place) <= 0)
      || (choice.log.includes("y") && choice.y.some((name) => value(name, place) === 0)));
    said.textContent = [complaint, count ? `${count} ${count === 1 ? "case" : "cases"}${failures.length ? `, of which ${failures.join(", ")}` : ""}.` : "No case fits this choice.",
      lost.length ? `${lost.length} have no place on a logarithmic axis.` : "",
      found.merged ? `${found.merged} more are the same simulations beside another reference.` : ""].filter(Boolean).join(" ");
    rings.replaceChildren();
    fillTable();
    if (isSeen) drawPlot();
  }

  async function drawPlot() {
    await loadPlotly();
    const options = { responsive: true, displaylogo: false, displayModeBar: false };
    Plotly.react(plot, explorerPlot.traces(choice, current), explorerPlot.layout(choice, current, root.clientWidth), options).then(() => {
      plot.dataset.drawn = String(Number(plot.dataset.drawn ?? 0) + 1);
      if (plot.dataset.heard) return;
      plot.dataset.heard = "yes";
      plot.on("plotly_hover", ({ points: [point] }) => mark(point.customdata));
      plot.on("plotly_click", ({ points: [point] }) => { location.hash = caseAddress(value("key", point.customdata)); });
      plot.on("plotly_relayout", () => rings.replaceChildren());
    });
  }

  /* The case in all panels, and its values below. */
  function mark(place) {
    rings.replaceChildren();
    choice.y.forEach((name, panel) => {
      const [x, y] = ["x", "y"].map((axis) => plot._fullLayout[`${axis}axis${panel ? panel + 1 : ""}`]);
      const shown = explorerPlot.number(choice, name, place) ?? (ok(place) ? null : explorerPlot.foot(choice, name, current));
      if (shown === null) return;
      const ring = element("i");
      ring.style.left = `${x._offset + x.d2p(allCases.shown(choice.x, place))}px`;
      ring.style.top = `${y._offset + y.d2p(shown)}px`;
      rings.append(ring);
    });
    const words = [value("name", place), value("cells", place), value("load", place)].filter(Boolean).join(", ");
    readout.textContent = `${words}\n${explorerPlot.told(place, [choice.x, ...choice.y])}`;
  }

  /* -- The same as a table, and files ------------------------------------------------------------- */

  function sheet() {
    const places = current.flatMap((series) => series.places);
    const used = settings.filter((name) => places.some((place) => value(name, place) !== null));
    const names = ["key", "name", "status", "test", "cells", ...used.filter((name) => name !== choice.x), choice.x, ...choice.y.filter((name) => name !== choice.x)];
    return { names, rowsOf: (cell) => places.map((place) => names.map((name) => cell(name, place) ?? "")) };
  }
  function csv() {
    const quoted = (cell) => (/[",\n]/.test(String(cell)) ? `"${String(cell).replaceAll('"', '""')}"` : String(cell));
    const { names, rowsOf } = sheet();
    return [names, ...rowsOf(value)].map((row) => row.map(quoted).join(",")).join("\n") + "\n";
  }
  function fillTable() {
    const count = current.reduce((sum, { places }) => sum + places.length, 0);
    table.replaceChildren(element("summary", { textContent: `The ${count} cases as a table` }));
    if (table.open) showRows();
  }
  function showRows() {
    if (table.querySelector("table")) return;
    const { names, rowsOf } = sheet(), rows = rowsOf(allCases.shown);
    const box = element("div", { className: "scroll" }), found = element("table");
    const head = found.createTHead().insertRow();
    for (const name of names) head.append(element("th", { scope: "col", textContent: allCases.heading(name) }));
    const body = found.createTBody();
    for (const row of rows.slice(0, mostRows)) {
      const line = body.insertRow();
      row.forEach((cell, i) => {
        if (i) line.insertCell().textContent = typeof cell === "number" ? String(Number(cell.toPrecision(6))) : cell;
        else line.insertCell().append(element("a", { href: caseAddress(cell), textContent: cell.slice(0, 8) }));
      });
    }
    box.append(found);
    table.append(box);
    if (rows.length > mostRows) table.append(element("p", { className: "note", textContent: `The first ${mostRows} of ${rows.length}; all are in the CSV.` }));
  }
  table.addEventListener("toggle", () => { if (table.open) showRows(); });

  function save(name, text, type) {
    const link = element("a", { download: name, href: URL.createObjectURL(new Blob([text], { type })) });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }
  const fileName = () => `${choice.test}-over-${choice.x}`.replace(/[^A-Za-z0-9.]+/g, "-");
  const kinds = [
    ["PNG", () => Plotly.downloadImage(plot, { format: "png", filename: fileName(), scale: 3, width: plot.clientWidth, height: plot.clientHeight })],
    ["SVG", () => Plotly.downloadImage(plot, { format: "svg", filename: fileName(), width: plot.clientWidth, height: plot.clientHeight })],
    ["CSV", () => save(`${fileName()}.csv`, csv(), "text/csv")],
  ];
  buttons.append("Save as ", ...kinds.map(([text, act]) => {
    const button = element("button", { type: "button", textContent: text });
    button.addEventListener("click", act);
    return button;
  }));

  /* -- The choice, and the page's address --------------------------------------------------------- */

  let complaint = "";
  function usual(test) {
    const can = along(ofTest(test)).settings;
    return can.includes("nu") ? "nu" : can[0] ?? along(ofTest(test)).measures[0] ?? measures[0];
  }
  /* What of the choice no longer fits is chosen anew: from the axis on, or what is fixed alone. */
  function complete(from) {
    const places = ofTest(choice.test);
    if (from === "x") choice.x = usual(choice.test);
    if (from) choice.fixed = selection.telling(choice, places);
    const fits = measured(places);
    choice.y = choice.y.filter((name) => fits.includes(name));
    const first = [allCases.answers[choice.test], "answer_difference"].filter((name) => fits.includes(name));
    if (!choice.y.length) choice.y = first.length ? first : fits.slice(0, 1);
    choice.models = from ? usualModels(places) : choice.models.filter((name) => places.some((place) => selection.model(choice, place) === name));
  }
  function change(changes, from) {
    complaint = "";
    choice = { ...choice, ...changes };
    complete(from);
    history.replaceState(null, "", address());
    draw();
  }
  function address() {
    const words = new URLSearchParams({ test: choice.test, x: choice.x, y: choice.y.join(",") });
    if (String(choice.models) !== String(usualModels(ofTest(choice.test))))
      for (const name of choice.models.length ? choice.models : [""]) words.append("m", name);
    const fixed = Object.entries(choice.fixed);
    for (const [name, text] of fixed) words.append(`fixed.${name}`, text);
    if (!fixed.length) words.append("fixed", "none");
    if (choice.log) words.append("log", choice.log);
    return `#explore?${words}`;
  }
  const caseAddress = (key) => address().replace("#explore", `#case=${key}`);
  function followAddress() {
    if (!start.test(location.hash)) return;
    const isCase = location.hash.startsWith("#case=");
    if (isCase && isSeen) return;  // its choice is shown already
    const words = new URLSearchParams(location.hash.slice(location.hash.indexOf("?") + 1));
    const wrong = [];
    const known = (name, text, all) => {
      if (text !== null && !all.includes(text)) wrong.push(`${name} ${text}`);
      return all.includes(text) ? text : null;
    };
    const test = known("test", words.get("test"), tests) ?? choice.test;
    const can = along(ofTest(test));
    choice = { ...choice, test, models: [], fixed: {}, log: words.get("log") ?? "" };
    choice.x = known("axis", words.get("x"), [...can.settings, ...can.measures]) ?? usual(test);
    choice.y = (words.get("y") ?? "").split(",").filter((name) => name && known("measure", name, measured(ofTest(test)))).slice(0, mostPanels);
    const fixed = [...words].filter(([name]) => name.startsWith("fixed."));
    complete(fixed.length || words.has("fixed") ? null : "fixed");
    for (const [name, text] of fixed) {
      const column = name.slice("fixed.".length);
      const values = allCases.column(column) ? ofTest(test).map((place) => String(value(column, place))) : [];
      if (known(column, text, values) !== null) choice.fixed[column] = text;
    }
    const named = words.getAll("m").filter((name) => name === "" || known("method", name, models(ofTest(test))));
    choice.models = named.length ? named.filter(Boolean) : usualModels(ofTest(test));
    complaint = wrong.length ? `The address asks for ${wrong.join(", ")}, which ${allCases.file} does not have here.` : "";
    draw();
    if (!isCase) bringToTop(root.closest("section"));
  }

  root.hidden = false;
  choice.test = tests.find((test) => along(ofTest(test)).settings.length) ?? tests[0];
  complete("x");
  draw();
  followAddress();
  window.addEventListener("hashchange", followAddress);
  new IntersectionObserver((entries) => {
    if (isSeen || !entries.some((entry) => entry.isIntersecting)) return;
    isSeen = true;
    draw();
  }, { rootMargin: "200px" }).observe(frame);
})();
