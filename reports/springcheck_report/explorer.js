"use strict";

/* Any cases of the file along any setting, several measures side by side. */
(function () {
  const root = document.querySelector(".explorer");
  const start = /^#(explore|case=[^?]*)\?/;
  const mostPanels = 4, mostRows = 300;
  const element = (name, further = {}) => Object.assign(document.createElement(name), further);
  const value = allCases.value;
  const distinct = (values) => [...new Set(values)].filter((one) => one !== null);
  const every = [...Array(allCases.count).keys()];

  /* What is shown: y: measures; models: names of methods; fixed: {column: value as text}. */
  let choice = { test: null, x: null, y: [], models: [], fixed: {}, log: "" };

  /* -- What can be chosen ------------------------------------------------------------------------- */

  const present = distinct(every.map((place) => value("test", place)));
  const tests = [...Object.keys(allCases.answers), ...present.filter((test) => !Object.hasOwn(allCases.answers, test))];
  const ofTest = (test) => every.filter((place) => value("test", place) === test);
  const settings = allCases.namesOf("setting");
  const measures = allCases.namesOf("measure");
  const isNumber = (name) => allCases.column(name)?.kind === "number";

  /* Numbers that differ between cases; of cases that differ in none, those that they have. */
  function along(places) {
    const those = (least) => (name) => isNumber(name) && distinct(places.map((place) => value(name, place))).length >= least;
    const found = settings.filter(those(2));
    return { settings: found.length ? found : settings.filter(those(1)), measures: measures.filter(those(1)) };
  }
  const measured = (places) => {
    const own = allCases.answers[choice.test];
    return measures.filter((name) => name === own || places.some((place) => value(name, place) !== null));
  };

  /* Columns that can be held fixed: the mesh and the load in words stand for their settings, unless one of
     these runs along the axis. */
  function fixable(places) {
    const group = allCases.column(choice.x)?.group;
    const names = [...(group === "body" ? [] : ["cells"]), ...(group === "load" ? [] : ["load"]), "material", "scene", "reference"];
    for (const name of settings) {
      const column = allCases.column(name);
      const told = column.variant || name === choice.x
        || (column.group === "body" && (group !== "body" || /^(cells|size)\./.test(name)))
        || (column.group === "load" && group !== "load");
      if (!told) names.push(name);
    }
    return names.filter((name) => new Set(places.map((place) => value(name, place))).size > 1);
  }
  /* What makes the mechanical problem; of all else any value is shown at first. */
  const isProblem = (name) => ["cells", "load", "scene"].includes(name) || ["body", "material", "load"].includes(allCases.column(name).group);

  /* Of what can be fixed, the values with which most of the axis is covered, by most methods. */
  function telling(places) {
    const names = fixable(places).filter(isProblem);
    const groups = new Map();
    for (const place of places) {
      if (value(choice.x, place) === null) continue;
      const own = JSON.stringify(names.map((name) => value(name, place)));
      if (!groups.has(own)) groups.set(own, { at: new Set(), models: new Set() });
      groups.get(own).at.add(value(choice.x, place));
      groups.get(own).models.add(value("name", place));
    }
    const best = [...groups].sort(([, a], [, b]) => b.at.size - a.at.size || b.models.size - a.models.size)[0];
    const values = best ? JSON.parse(best[0]) : [];
    return Object.fromEntries(names.map((name, i) => [name, String(values[i])]));
  }

  const model = (place) => value(allCases.column(choice.x)?.variant ? "model" : "name", place);

  /* -- What is shown ------------------------------------------------------------------------------ */

  let merged = 0;  // cases that are drawn once with another, the same simulation beside another reference
  function shown() {
    const fixed = Object.entries(choice.fixed);
    const kept = ofTest(choice.test).filter((place) => value(choice.x, place) !== null
      && choice.models.includes(model(place))
      && fixed.every(([name, text]) => String(value(name, place)) === text));
    const free = fixable(kept).filter((name) => name !== "material");
    merged = 0;
    return models(kept).flatMap((name) => curvesOf(name, kept.filter((place) => model(place) === name), free));
  }
  /* Of one method: a curve for each of what else its cases differ in. The reference tells them apart only where
     what is shown depends on it. */
  function curvesOf(method, places, free) {
    const differing = free.filter((name) => new Set(places.map((place) => value(name, place))).size > 1);
    const simulation = (place) => JSON.stringify([choice.x, ...differing].filter((name) => name !== "reference").map((name) => value(name, place)));
    const figures = (place) => JSON.stringify(choice.y.map((name) => value(name, place)));
    const once = new Map();
    for (const place of places) {
      const own = simulation(place) + figures(place);
      if (!once.has(own)) once.set(own, place);
    }
    merged += places.length - once.size;
    const kept = [...once.values()];
    const isReferenceTold = new Set(kept.map(simulation)).size < kept.length;
    const told = differing.filter((name) => name !== "reference" || isReferenceTold);
    const curves = new Map();
    for (const place of kept) {
      const label = [method, ...told.map((name) => `${short(name)}${value(name, place) ?? "none"}`)].join(", ");
      if (!curves.has(label)) curves.set(label, { label, method, name: value("name", place), places: [] });
      curves.get(label).places.push(place);
    }
    const found = [...curves.values()].sort((a, b) => a.label.localeCompare(b.label, undefined, { numeric: true }));
    for (const curve of found) curve.places.sort((a, b) => value(choice.x, a) - value(choice.x, b));
    return found;
  }
  const short = (name) => (["cells", "load"].includes(name) ? "" : `${name} `);
  const isMeasureAlong = () => measures.includes(choice.x);

  const number = (name, place) => {
    const found = value(name, place);
    return found !== null && choice.log.includes("y") ? Math.abs(found) || null : found;
  };
  /* Where crosses of failed cases without a value stand: below all values. */
  function foot(name, all) {
    const values = all.flatMap(({ places }) => places.map((place) => number(name, place))).filter((one) => one !== null);
    if (!values.length) return choice.log.includes("y") ? 1 : 0;
    const [least, most] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
    return choice.log.includes("y") ? least / Math.max(2, (most / least) ** 0.1) : least - 0.08 * (most - least || Math.abs(most) || 1);
  }

  function traces(all) {
    const list = [];
    choice.y.forEach((name, panel) => {
      const bottom = foot(name, all);
      for (const method of distinct(all.map((curve) => curve.method))) {
        // One trace of all its curves, with gaps between them: thousands of traces would be slow.
        const own = all.filter((curve) => curve.method === method);
        const { colour, mark, dash } = allCases.looks[own[0].name];
        const places = own.flatMap((curve, i) => (i ? [null, ...curve.places] : curve.places));
        const labels = own.flatMap((curve, i) => [...(i ? [""] : []), ...curve.places.map(() => curve.label)]);
        const common = (of, called) => ({
          type: "scatter", name: escaped(own.length > 1 ? `${method} (${own.length} curves)` : own[0].label), legendgroup: method,
          x: of.map((place) => place === null ? null : value(choice.x, place)), customdata: of, hoverinfo: "text",
          xaxis: panel ? `x${panel + 1}` : "x", yaxis: panel ? `y${panel + 1}` : "y",
          text: of.map((place, i) => place === null ? "" : `<b>${escaped(called[i])}</b><br>${escaped(told(place, [choice.x, name])).replaceAll("\n", "<br>")}`),
        });
        const isOk = places.map((place) => place === null || ok(place));
        const rings = places.map((place, i) => (isOk[i] ? colour : allCases.statuses[value("status", place)] ?? "#555555"));
        list.push({
          ...common(places, labels), y: places.map((place) => place === null ? null : number(name, place)), showlegend: panel === 0,
          mode: isMeasureAlong() ? "markers" : "lines+markers", line: { color: colour, width: 1.5, dash },
          marker: {
            color: colour, symbol: isOk.map((one) => (one ? mark : `${mark.replace("-open", "")}-open-dot`)),
            size: isOk.map((one) => (one ? 7 : 11)), line: { width: isOk.map((one) => (one ? 1 : 2)), color: rings },
          },
        });
        const lost = places.filter((place) => place !== null && !ok(place) && value(name, place) === null);
        if (lost.length)
          list.push({ ...common(lost, lost.map((place) => labels[places.indexOf(place)])), y: lost.map(() => bottom), showlegend: false, mode: "markers", marker: { color: colour, symbol: "x-thin-open", size: 10, line: { width: 2 } } });
      }
    });
    return list;
  }
  const ok = (place) => value("status", place) === "ok";
  const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

  /* A line for each of the columns with its full value, then status and key. */
  function told(place, names) {
    const lines = names.map((name) => {
      const { label, unit } = allCases.column(name);
      const judge = ["answer_difference", "volume_difference"].includes(name) && value("judge", place);
      return `${label} = ${value(name, place) ?? "none"}${unit ? ` ${unit}` : ""}${judge ? ` (of ${judge})` : ""}`;
    });
    return [...lines, `${value("status", place).replaceAll("_", " ")}, case ${value("key", place).slice(0, 8)}`].join("\n");
  }

  /* A title of an axis in lines that fit beside a panel. */
  function inLines(text) {
    const lines = [""];
    for (const word of text.split(" ")) {
      if (lines.at(-1).length + word.length > 34) lines.push("");
      lines[lines.length - 1] += `${word} `;
    }
    return lines.map((line) => escaped(line.trim())).join("<br>");
  }

  function layout(all, width) {
    const count = choice.y.length, panel = 270, gap = 75;
    const columns = Math.min(count, width < 640 ? 1 : 2), rows = Math.ceil(count / columns);
    const lengths = distinct(all.map(({ method }) => method)).map((method) => 46 + 6.3 * (method.length + 12));
    const legend = 20 * Math.ceil(1.15 * lengths.reduce((sum, one) => sum + one, 0) / Math.max(width - 100, 200)) + 10;
    const inside = rows * panel + (rows - 1) * gap;
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue("--ink"), line = style.getPropertyValue("--line");
    const found = {
      grid: { rows, columns, pattern: "independent", xgap: 0.2, ygap: gap / panel }, height: inside + 16 + 60 + legend,
      margin: { l: 62, r: 16, t: 16, b: 60 + legend },
      hovermode: "closest", font: { size: 11.5, color: ink }, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      hoverlabel: { align: "left", bgcolor: style.getPropertyValue("--paper"), font: { color: ink } },
      legend: { orientation: "h", y: -56 / inside, yanchor: "top", x: 0, font: { size: 11 } },
    };
    choice.y.forEach((name, panel) => {
      const common = { automargin: true, gridcolor: line, zerolinecolor: line, linecolor: ink, ticks: "outside" };
      const { label, unit } = allCases.column(name);
      const heading = `${choice.log.includes("y") ? `|${label}|` : label}${unit ? ` [${unit}]` : ""}`;
      found[`xaxis${panel ? panel + 1 : ""}`] = { ...common, title: { text: escaped(allCases.heading(choice.x)), standoff: 6 }, type: choice.log.includes("x") ? "log" : "linear" };
      found[`yaxis${panel ? panel + 1 : ""}`] = { ...common, exponentformat: "power",
        title: { text: inLines(heading), standoff: 6 }, type: choice.log.includes("y") ? "log" : "linear" };
    });
    return found;
  }

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

  const models = (places) => distinct(places.map(model)).sort();
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
      ...fixable(places).map((name) => {
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
    current = shown();
    const count = current.reduce((sum, { places }) => sum + places.length, 0);
    const bad = current.flatMap(({ places }) => places).filter((place) => !ok(place));
    const by = distinct(bad.map((place) => value("status", place)));
    const failures = by.map((status) => `${bad.filter((place) => value("status", place) === status).length} ${status.replaceAll("_", " ")}`);
    const places = current.flatMap((curve) => curve.places);
    const lost = places.filter((place) => (choice.log.includes("x") && value(choice.x, place) <= 0)
      || (choice.log.includes("y") && choice.y.some((name) => value(name, place) === 0)));
    said.textContent = [complaint, count ? `${count} ${count === 1 ? "case" : "cases"}${failures.length ? `, of which ${failures.join(", ")}` : ""}.` : "No case fits this choice.",
      lost.length ? `${lost.length} have no place on a logarithmic axis.` : "",
      merged ? `${merged} more are the same simulations beside another reference.` : ""].filter(Boolean).join(" ");
    rings.replaceChildren();
    fillTable();
    if (isSeen) drawPlot();
  }

  async function drawPlot() {
    await loadPlotly();
    const settings = { responsive: true, displaylogo: false, displayModeBar: false };
    Plotly.react(plot, traces(current), layout(current, root.clientWidth), settings).then(() => {
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
      const shown = number(name, place) ?? (ok(place) ? null : foot(name, current));
      if (shown === null) return;
      const ring = element("i");
      ring.style.left = `${x._offset + x.d2p(value(choice.x, place))}px`;
      ring.style.top = `${y._offset + y.d2p(shown)}px`;
      rings.append(ring);
    });
    const model = [value("name", place), value("cells", place), value("load", place)].filter(Boolean).join(", ");
    readout.textContent = `${model}\n${told(place, [choice.x, ...choice.y])}`;
  }

  /* -- The same as a table, and files ------------------------------------------------------------- */

  function sheet() {
    const places = current.flatMap((series) => series.places);
    const used = settings.filter((name) => places.some((place) => value(name, place) !== null));
    const names = ["key", "name", "status", "test", "cells", ...used.filter((name) => name !== choice.x), choice.x, ...choice.y.filter((name) => name !== choice.x)];
    return { names, rows: places.map((place) => names.map((name) => value(name, place) ?? "")) };
  }
  function csv() {
    const quoted = (cell) => (/[",\n]/.test(String(cell)) ? `"${String(cell).replaceAll('"', '""')}"` : String(cell));
    const { names, rows } = sheet();
    return [names, ...rows].map((row) => row.map(quoted).join(",")).join("\n") + "\n";
  }
  function fillTable() {
    const count = current.reduce((sum, { places }) => sum + places.length, 0);
    table.replaceChildren(element("summary", { textContent: `The ${count} cases as a table` }));
    if (table.open) showRows();
  }
  function showRows() {
    if (table.querySelector("table")) return;
    const { names, rows } = sheet();
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
    if (from) choice.fixed = telling(places);
    const fits = measured(places);
    choice.y = choice.y.filter((name) => fits.includes(name));
    const first = [allCases.answers[choice.test], "answer_difference"].filter((name) => fits.includes(name));
    if (!choice.y.length) choice.y = first.length ? first : fits.slice(0, 1);
    choice.models = from ? usualModels(places) : choice.models.filter((name) => places.some((place) => model(place) === name));
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
