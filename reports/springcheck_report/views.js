"use strict";

/* 3D views of bodies: choices, a slider through what was recorded on the way, plots by bodyTraces. */
const viewsReady = (async function () {
  const hasWebGL = Boolean(window.WebGLRenderingContext &&
    document.createElement("canvas").getContext("webgl"));
  if (!hasWebGL) return;  // the pictures below stand for the views
  const { meshes, tests } = JSON.parse(document.getElementById("bodies").textContent);
  const { layout, quantities, ranges, scenes, traces } = bodyTraces;
  const data = await (await unpacked("bodies-data")).arrayBuffer();

  const mostAlive = 3;  // three WebGL contexts each; browsers allow about 16
  const alive = [];

  /* bodies.py gives place and count of numbers of four bytes. */
  const floats = ([place, count]) => new Float32Array(data, 4 * place, count);
  const integers = ([place, count]) => new Uint32Array(data, 4 * place, count);
  const unpackedMesh = ({ nodes, triangles, faces, edges }) =>
    ({ nodes: floats(nodes), triangles: integers(triangles), faces: integers(faces), edges: integers(edges) });

  /* What a body went through: {u, strain, volume, time, load}; of one at rest its end alone. */
  function states(body) {
    const end = { u: floats(body.displacement), strain: floats(body.strain), volume: floats(body.volume), ...body.end };
    return [...body.frames.map((frame) => ({
      u: floats(frame.displacement), strain: floats(frame.strain), volume: floats(frame.volume),
      time: frame.time, load: frame.load,
    })), end];
  }
  /* Pairs of states, one for each of that body which has more; the other is there as it was nearest in time. */
  function pairs(bodies) {
    const [own, theirs] = bodies.map((body) => (body ? states(body) : [null]));
    const nearest = (all, time) => all.reduce((best, one) =>
      (Math.abs(one?.time - time) < Math.abs(best?.time - time) ? one : best), all.at(-1));
    return theirs.length > own.length ? theirs.map((state) => [nearest(own, state.time), state])
      : own.map((state) => [state, nearest(theirs, state?.time)]);
  }

  const made = (name, further) => Object.assign(document.createElement(name), further);
  function labelled(text, control, parent) {
    const wrap = made("label");
    wrap.append(`${text} `, control);
    parent.append(wrap);
    return control;
  }
  const choice = (label, options, parent) => {
    const select = labelled(label, made("select"), parent);
    options.forEach(([value, text]) => select.add(new Option(text, value)));
    return select;
  };

  function controlsOf(element, groups) {
    const controls = made("div", { className: "controls" });
    const names = made("div", { className: "names" });
    const plot = made("div", { className: "plot" });
    const way = made("div", { className: "controls way" });
    element.append(controls, names, plot, way);
    return {
      names, plot, way,
      group: choice("Case", groups.map((g, i) => [i, g.label]), controls),
      method: choice("method", [], controls),
      reference: choice("reference", [], controls),
      quantity: choice("colour", Object.entries(quantities).map(([name, { label }]) => [name, label]), controls),
      slider: labelled("time", made("input", { type: "range", min: 0, step: 1 }), way),
      moment: way.appendChild(made("output")),
    };
  }

  /* Offers the bodies of a kind, and chooses the one of before, or one that is usual. */
  function offer(select, bodies, isOfKind) {
    const options = bodies.map((body, i) => [i, body]).filter(([, body]) => isOfKind(body))
      .map(([i, body]) => [i, body.name + (body.status === "ok" ? "" : ` (${body.status.replaceAll("_", " ")})`)]);
    const before = select.selectedOptions[0]?.text;
    select.replaceChildren(...options.map(([value, text]) => new Option(text, value)));
    const first = options.findIndex(([i, text]) => before ? text === before : bodies[i].is_usual);
    if (first >= 0) select.selectedIndex = first;
    select.parentElement.hidden = options.length === 0;
  }

  /* "t = 0.25 s, 50 % of the load; fem-stvk as it ends", or "...; fem-explicit-stvk at t = 0.251 s": of the body
     that is gone through, then of the other one where it is at another moment. */
  function toldMoment(pair, bodies) {
    const [first, other] = (bodies[1]?.frames.length ?? 0) > (bodies[0]?.frames.length ?? 0) ? [1, 0] : [0, 1];
    const state = pair[first];
    if (!state || state.time === undefined) return "";
    const text = `t = ${state.time.toPrecision(3)} s, ${(100 * state.load).toPrecision(3)} % of the load`;
    if (!pair[other] || pair[other].time?.toPrecision(3) === state.time.toPrecision(3)) return text;
    const when = pair[other].time === undefined ? "as it ends" : `at t = ${pair[other].time.toPrecision(3)} s`;
    return `${text}; ${bodies[other].name} ${when}`;
  }

  /* Where the plot's scenes are looked at from: where one is turned, the others turn, too. */
  function lookAt(plot) {
    const look = { camera: { eye: { x: 1.35, y: -1.95, z: 0.85 }, up: { x: 0, y: 0, z: 1 } } };
    function follow(change) {
      const moved = scenes.find((name) => change[`${name}.camera`]);
      if (!moved) return;
      look.camera = change[`${moved}.camera`];
      const others = {};
      for (const name of scenes)
        if (name !== moved && JSON.stringify(plot.layout[name].camera) !== JSON.stringify(look.camera))
          others[`${name}.camera`] = structuredClone(look.camera);
      if (Object.keys(others).length) Plotly.relayout(plot, others);
    }
    look.listen = () => ["plotly_relayouting", "plotly_relayout"].forEach((event) => plot.on(event, follow));
    return look;
  }

  /* Draws the plot while it is in view, and the last few that were: browsers allow few contexts, and Plotly leaves
     its own to the garbage collector. */
  function keepAlive(plot, draw, forget) {
    const state = {
      async show() {
        if (alive.includes(state)) return;
        alive.push(state);
        await loadPlotly();
        if (!alive.includes(state)) return;
        draw();
        while (alive.length > mostAlive) alive.shift().rest();
      },
      rest() {
        for (const canvas of plot.querySelectorAll("canvas"))
          canvas.getContext("webgl")?.getExtension("WEBGL_lose_context")?.loseContext();
        window.Plotly?.purge(plot);
        forget();
        delete plot.dataset.drawn;
      },
    };
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) state.show();
    }, { rootMargin: "200px" }).observe(plot);
  }

  function viewer(element) {
    const groups = tests[element.dataset.test];
    if (!groups || !groups.length) return;
    element.hidden = false;
    const { group, method, reference, quantity, slider, moment, names, plot, way } = controlsOf(element, groups);
    const look = lookAt(plot);
    let drawn = false;
    let mesh = null, chosenPairs = [], range = null;
    const chosen = () => [method, reference].map((s) => (s.value === "" ? null : groups[group.value].bodies[s.value]));

    function fill() {
      const { bodies } = groups[group.value];
      const isReference = (body) => body.kind === "finite elements";
      offer(method, bodies, (body) => !isReference(body));
      offer(reference, bodies, isReference);
      toTheEnd();
    }
    function toTheEnd() {
      mesh = unpackedMesh(meshes[groups[group.value].mesh]);
      chosenPairs = pairs(chosen());
      range = null;
      slider.max = chosenPairs.length - 1;
      slider.value = slider.max;
      way.hidden = slider.max === "0";
    }

    function draw() {
      const bodies = chosen();
      const [own, theirs] = bodies;
      for (const option of quantity.options)  // a body alone deviates from nothing
        option.disabled = Boolean(quantities[option.value].needsBoth && !(own && theirs));
      if (quantity.selectedOptions[0].disabled) quantity.value = "displacement";
      const pair = chosenPairs[slider.value];
      const over = own && theirs ? `${own.name} over ${theirs.name} (dark)` : "";
      names.replaceChildren(...[own?.name ?? "", theirs?.name ?? "", over].map((text) => made("div", { textContent: text })));
      moment.value = toldMoment(pair, bodies);
      const list = traces(mesh, pair, quantity.value);
      if (range?.quantity !== quantity.value) range = { ...ranges(mesh, chosenPairs, quantity.value), quantity: quantity.value };
      const shown = layout(range, quantity.value, Boolean(own && theirs), look.camera);
      const settings = { responsive: true, displaylogo: false, displayModeBar: false, scrollZoom: false };
      Plotly.react(plot, list, shown, settings).then(() => {
        plot.dataset.drawn = "yes";
        if (!drawn) look.listen();
        drawn = true;
      });
    }
    /* For links to the body of a case. */
    const groupOf = (key) => groups.findIndex((one) => one.bodies.some((body) => body.cases.includes(key)));
    element.hasCase = (key) => groupOf(key) >= 0;
    element.showCase = (key) => {
      group.value = groupOf(key);
      fill();
      const { bodies } = groups[group.value];
      const place = bodies.findIndex((body) => body.cases.includes(key));
      (bodies[place].kind === "finite elements" ? reference : method).value = place;
      toTheEnd();
      if (drawn) draw();
    };

    group.addEventListener("change", () => { fill(); draw(); });
    for (const select of [method, reference]) select.addEventListener("change", () => { toTheEnd(); draw(); });
    quantity.addEventListener("change", draw);
    slider.addEventListener("input", draw);
    fill();
    keepAlive(plot, draw, () => { drawn = false; });
  }
  document.querySelectorAll(".viewer").forEach(viewer);
})();
