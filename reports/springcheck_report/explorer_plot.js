"use strict";

/* The explorer's curves as plotly draws them: a panel for each measure. */
const explorerPlot = (function () {
  const { shown, value } = allCases;
  const { distinct, ok } = selection;

  /* Its value as the axis has it. */
  const number = (choice, name, place) => {
    const found = shown(name, place);
    return found !== null && choice.log.includes("y") ? Math.abs(found) || null : found;
  };
  /* Where crosses of failed cases without a value stand: below all values. */
  function foot(choice, name, all) {
    const values = all.flatMap(({ places }) => places.map((place) => number(choice, name, place))).filter((one) => one !== null);
    if (!values.length) return choice.log.includes("y") ? 1 : 0;
    const [least, most] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
    return choice.log.includes("y") ? least / Math.max(2, (most / least) ** 0.1) : least - 0.08 * (most - least || Math.abs(most) || 1);
  }

  function traces(choice, all) {
    const list = [];
    choice.y.forEach((name, panel) => {
      const bottom = foot(choice, name, all);
      for (const method of distinct(all.map((curve) => curve.method))) {
        // One trace of all its curves, with gaps between them: thousands of traces would be slow.
        const own = all.filter((curve) => curve.method === method);
        const { colour, mark, dash } = allCases.looks[own[0].name];
        const places = own.flatMap((curve, i) => (i ? [null, ...curve.places] : curve.places));
        const labels = own.flatMap((curve, i) => [...(i ? [""] : []), ...curve.places.map(() => curve.label)]);
        const common = (of, called) => ({
          type: "scatter", name: escaped(own.length > 1 ? `${method} (${own.length} curves)` : own[0].label), legendgroup: method,
          x: of.map((place) => place === null ? null : shown(choice.x, place)), customdata: of, hoverinfo: "text",
          xaxis: panel ? `x${panel + 1}` : "x", yaxis: panel ? `y${panel + 1}` : "y",
          text: of.map((place, i) => place === null ? "" : `<b>${escaped(called[i])}</b><br>${escaped(told(place, [choice.x, name])).replaceAll("\n", "<br>")}`),
        });
        const isOk = places.map((place) => place === null || ok(place));
        const rings = places.map((place, i) => (isOk[i] ? colour : allCases.statuses[value("status", place)] ?? "#555555"));
        list.push({
          ...common(places, labels), y: places.map((place) => place === null ? null : number(choice, name, place)), showlegend: panel === 0,
          mode: selection.isMeasureAlong(choice) ? "markers" : "lines+markers", line: { color: colour, width: 1.5, dash },
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
  const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

  /* A line for each of the columns with its full value, then status and key. */
  function told(place, names) {
    const lines = names.map((name) => {
      const { label, unit } = allCases.column(name);
      const judge = ["answer_difference", "volume_difference"].includes(name) && value("judge", place);
      return `${label} = ${shown(name, place) ?? "none"}${unit ? ` ${unit}` : ""}${judge ? ` (of ${judge})` : ""}`;
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

  function layout(choice, all, width) {
    const count = choice.y.length, panel = 270, gap = 75;
    const columns = Math.min(count, width < 640 ? 1 : 2), rows = Math.ceil(count / columns);
    const lengths = distinct(all.map(({ method }) => method)).map((method) => 46 + 6.3 * method.length);
    if (all.length > lengths.length) lengths.push(6.3 * 12 * lengths.length);  // "(2 curves)"
    const legend = 20 * Math.ceil(1.15 * lengths.reduce((sum, one) => sum + one, 0) / Math.max(width - 100, 200)) + 10;
    const inside = rows * panel + (rows - 1) * gap;
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue("--plate-ink"), line = style.getPropertyValue("--plate-line");
    const found = {
      grid: { rows, columns, pattern: "independent", xgap: 0.2, ygap: gap / panel }, height: inside + 16 + 60 + legend,
      margin: { l: 62, r: 16, t: 16, b: 60 + legend },
      hovermode: "closest", font: { size: 11.5, color: ink }, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      hoverlabel: { align: "left", bgcolor: style.getPropertyValue("--plate"), font: { color: ink } },
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

  return { foot, layout, number, told, traces };
})();
