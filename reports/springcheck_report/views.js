"use strict";

/* 3D views: springs, finite elements and their difference, with one camera and one scale. */
(function () {
  const hasWebGL = Boolean(window.WebGLRenderingContext &&
    document.createElement("canvas").getContext("webgl"));
  if (!hasWebGL) return;  // the pictures below stand for the views
  const { meshes, tests } = JSON.parse(document.getElementById("bodies").textContent);

  const scenes = ["scene", "scene2", "scene3"];
  const mostAlive = 3;  // three WebGL contexts each; browsers allow about 16
  const alive = [];

  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const floats = (text) => new Float32Array(bytes(text));
  const integers = (text) => new Uint32Array(bytes(text));

  const unpackedMeshes = {};
  function unpackedMesh(name) {
    if (!unpackedMeshes[name]) {
      const mesh = meshes[name];
      unpackedMeshes[name] = {
        nodes: floats(mesh.nodes), triangles: integers(mesh.triangles),
        faces: integers(mesh.faces), edges: integers(mesh.edges),
      };
    }
    return unpackedMeshes[name];
  }

  /* Coordinates [cm] of displaced nodes, one array per axis. */
  function positions(nodes, displacement) {
    const axes = [[], [], []];
    for (let i = 0; i < nodes.length; ++i) axes[i % 3].push(100 * (nodes[i] + displacement[i]));
    return axes;
  }

  /* Lengths [mm] of vectors. */
  function lengths(vectors) {
    const found = [];
    for (let i = 0; i < vectors.length; i += 3)
      found.push(1000 * Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]));
    return found;
  }
  const minus = (a, b) => a.map((value, i) => value - b[i]);
  const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

  function surface(mesh, place, values, ofCells, colours, scene) {
    const [i, j, k] = [[], [], []];
    const { triangles } = mesh;
    for (let t = 0; t < triangles.length; t += 3) {
      i.push(triangles[t]); j.push(triangles[t + 1]); k.push(triangles[t + 2]);
    }
    return {
      type: "mesh3d", x: place[0], y: place[1], z: place[2], i, j, k, scene,
      intensity: ofCells ? Array.from(mesh.faces, (face) => values[face]) : Array.from(values),
      intensitymode: ofCells ? "cell" : "vertex", coloraxis: colours, flatshading: true,
      lighting: { ambient: 0.7, diffuse: 0.45, specular: 0.05, roughness: 0.9 },
      hovertemplate: "%{intensity:.3g}<extra></extra>",
    };
  }
  /* Places moved outward along the surface's normals by a fraction of the body's size. */
  function raised(mesh, place, fraction) {
    const normals = place.map((values) => values.map(() => 0));
    const { triangles } = mesh;
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = triangles.slice(t, t + 3);
      const p = place.map((values) => values[b] - values[a]);
      const q = place.map((values) => values[c] - values[a]);
      const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
      for (const node of [a, b, c]) normal.forEach((n, axis) => { normals[axis][node] += n; });
    }
    const size = Math.max(...place.map((values) => Math.max(...values) - Math.min(...values)));
    return place.map((values, axis) => values.map((value, i) => {
      const length = Math.hypot(normals[0][i], normals[1][i], normals[2][i]) || 1;
      return value + fraction * size * normals[axis][i] / length;
    }));
  }

  /* Edges of cells, a trace above the surface, which would hide half of them. */
  function wires(mesh, place, colour, width, scene) {
    const line = [[], [], []];
    const above = raised(mesh, place, 0.006);
    for (let e = 0; e < mesh.edges.length; e += 2)
      for (let axis = 0; axis < 3; ++axis)
        line[axis].push(above[axis][mesh.edges[e]], above[axis][mesh.edges[e + 1]], null);
    return {
      type: "scatter3d", mode: "lines", x: line[0], y: line[1], z: line[2], scene,
      line: { color: colour, width }, hoverinfo: "skip", showlegend: false,
    };
  }

  function traces(group, springs, elements, quantity) {
    const mesh = unpackedMesh(group.mesh);
    const bodies = [springs, elements].map((body) => body && {
      u: floats(body.displacement), volume: floats(body.volume),
    });
    const places = bodies.map((body) => body && positions(mesh.nodes, body.u));
    const both = Boolean(bodies[0] && bodies[1]);
    const distance = both ? lengths(minus(bodies[0].u, bodies[1].u)) : null;
    const ofCells = quantity === "volume";
    const list = [];
    bodies.forEach((body, at) => {
      if (!body) return;
      const values = ofCells ? body.volume.map((v) => 100 * v)
        : quantity === "deviation" && both ? distance : lengths(body.u);
      list.push(surface(mesh, places[at], values, ofCells, "coloraxis", scenes[at]));
      list.push(wires(mesh, places[at], "rgba(20,20,20,0.7)", 1.5, scenes[at]));
    });
    let difference = null;
    if (both) {
      if (quantity === "deviation") {
        list.push(wires(mesh, places[1], "#000000", 3, scenes[2]));
        list.push(wires(mesh, places[0], "#0072B2", 2, scenes[2]));
      } else {
        difference = ofCells ? minus(bodies[0].volume, bodies[1].volume).map((v) => 100 * v)
          : distance;
        list.push(surface(mesh, places[0], difference, ofCells, "coloraxis2", scenes[2]));
        list.push(wires(mesh, places[0], "rgba(20,20,20,0.7)", 1.5, scenes[2]));
      }
    }
    const shown = list.filter((trace) => trace.coloraxis === "coloraxis");
    const range = Math.max(...shown.map((trace) => largest(trace.intensity))) || 1;
    return { list, places: places.filter(Boolean), range, difference: difference && (largest(difference) || 1) };
  }

  const heads = {
    displacement: ["displacement [mm]", "distance [mm]"],
    deviation: ["distance [mm]", ""],
    volume: ["V/V₀ − 1 [%]", "difference [points]"],
  };

  function layout(drawn, quantity, camera) {
    // What lies on the range's very end would be cut off here and there.
    const least = [0, 1, 2].map((a) => Math.min(...drawn.places.map((p) => Math.min(...p[a]))));
    const most = [0, 1, 2].map((a) => Math.max(...drawn.places.map((p) => Math.max(...p[a]))));
    const margin = 0.01 * Math.max(...most.map((m, a) => m - least[a]));
    const low = least.map((value) => value - margin);
    const high = most.map((value) => value + margin);
    const size = high.map((h, a) => h - low[a]);
    // The sphere around the body fills the view.
    const longest = Math.hypot(...size) / 1.9;
    const axis = (a) => ({ range: [low[a], high[a]], visible: false });
    const scene = (from, to) => ({
      domain: { x: [from, to], y: [0, 1] }, camera: structuredClone(camera), dragmode: "orbit",
      xaxis: axis(0), yaxis: axis(1), zaxis: axis(2), aspectmode: "manual",
      aspectratio: { x: size[0] / longest, y: size[1] / longest, z: size[2] / longest },
    });
    const diverging = quantity === "volume";
    const bar = (text, x, range) => ({
      cmin: diverging ? -range : 0, cmax: range,
      colorscale: diverging ? "RdBu" : "Viridis", reversescale: diverging,
      colorbar: { title: { text, side: "right", font: { size: 11 } }, x, len: 0.8, thickness: 10,
                  tickfont: { size: 10 } },
    });
    const [text, other] = heads[quantity];
    return {
      scene: scene(0, 0.29), scene2: scene(0.29, 0.58), scene3: scene(0.65, 0.94),
      coloraxis: bar(text, 0.58, drawn.range),
      coloraxis2: { ...bar(other, 0.94, drawn.difference || 1), showscale: drawn.difference !== null },
      margin: { l: 0, r: 0, t: 0, b: 0 }, showlegend: false,
    };
  }

  function choice(label, options, parent) {
    const wrap = document.createElement("label");
    const select = document.createElement("select");
    wrap.append(label + " ", select);
    options.forEach(([value, text]) => select.add(new Option(text, value)));
    parent.append(wrap);
    return select;
  }

  function viewer(element) {
    const groups = tests[element.dataset.test];
    if (!groups || !groups.length) return;
    element.hidden = false;
    const controls = Object.assign(document.createElement("div"), { className: "controls" });
    const names = Object.assign(document.createElement("div"), { className: "names" });
    const plot = Object.assign(document.createElement("div"), { className: "plot" });
    element.append(controls, names, plot);
    const group = choice("Case", groups.map((g, i) => [i, g.label]), controls);
    const springs = choice("springs", [], controls);
    const elements = choice("finite elements", [], controls);
    const quantity = choice("colour", [["displacement", "displacement"],
      ["deviation", "deviation (springs from finite elements)"], ["volume", "volume change"]], controls);
    let camera = { eye: { x: 1.35, y: -1.95, z: 0.85 }, up: { x: 0, y: 0, z: 1 } };
    let drawn = false;

    function fill() {
      const bodies = groups[group.value].bodies;
      const fits = (kind) => bodies.map((body, i) => [i, body])
        .filter(([, body]) => (body.kind === "finite elements") === kind)
        .map(([i, body]) => [i, body.name + (body.status === "ok" ? "" : ` (${body.status.replaceAll("_", " ")})`)]);
      for (const [select, options] of [[springs, fits(false)], [elements, fits(true)]]) {
        const before = select.selectedOptions[0]?.text;
        select.replaceChildren(...options.map(([value, text]) => new Option(text, value)));
        const first = options.findIndex(([i, text]) => before ? text === before : bodies[i].is_usual);
        if (first >= 0) select.selectedIndex = first;
        select.parentElement.hidden = options.length === 0;
      }
    }
    function draw() {
      const chosen = groups[group.value];
      const [left, right] = [springs, elements].map((s) => s.value === "" ? null : chosen.bodies[s.value]);
      quantity.options[1].disabled = !(left && right);  // a body alone deviates from nothing
      if (quantity.selectedOptions[0].disabled) quantity.value = "displacement";
      const found = traces(chosen, left, right, quantity.value);
      names.replaceChildren(...[left?.name ?? "", right?.name ?? "",
        left && right ? (quantity.value === "deviation" ? "both, springs in blue" : "difference") : ""]
        .map((text) => Object.assign(document.createElement("div"), { textContent: text })));
      const settings = { responsive: true, displaylogo: false, displayModeBar: false, scrollZoom: false };
      Plotly.react(plot, found.list, layout(found, quantity.value, camera), settings).then(() => {
        plot.dataset.drawn = "yes";
        if (drawn) return;
        drawn = true;
        const follow = (change) => {
          const moved = scenes.find((name) => change[`${name}.camera`]);
          if (moved) turn(change[`${moved}.camera`], moved);
        };
        plot.on("plotly_relayouting", follow);
        plot.on("plotly_relayout", follow);
      });
    }
    /* The other scenes look from where this one does. */
    function turn(to, from) {
      camera = to;
      const change = {};
      for (const name of scenes)
        if (name !== from && JSON.stringify(plot.layout[name].camera) !== JSON.stringify(to))
          change[`${name}.camera`] = structuredClone(to);
      if (Object.keys(change).length) Plotly.relayout(plot, change);
    }
    /* For links to the body of a case. */
    const groupOf = (key) => groups.findIndex((one) => one.bodies.some((body) => body.case === key));
    element.hasCase = (key) => groupOf(key) >= 0;
    element.showCase = (key) => {
      group.value = groupOf(key);
      fill();
      const { bodies } = groups[group.value];
      const place = bodies.findIndex((body) => body.case === key);
      (bodies[place].kind === "finite elements" ? elements : springs).value = place;
      if (drawn) draw();
    };

    group.addEventListener("change", () => { fill(); draw(); });
    for (const select of [springs, elements, quantity]) select.addEventListener("change", draw);
    fill();

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
        // Browsers allow few contexts; Plotly leaves its own to the garbage collector.
        for (const canvas of plot.querySelectorAll("canvas"))
          canvas.getContext("webgl")?.getExtension("WEBGL_lose_context")?.loseContext();
        window.Plotly?.purge(plot);
        drawn = false;
        delete plot.dataset.drawn;
      },
    };
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) state.show();
    }, { rootMargin: "200px" }).observe(plot);
  }
  document.querySelectorAll(".viewer").forEach(viewer);
})();
