"use strict";

/* What the 3D views draw: a method's body, the reference's, and one over the other, with one camera and one scale.
   A state of a body has `u`, displacements of the surface's nodes [m], and `strain` and `volume` of its faces' cells. */
const bodyTraces = (function () {
  const scenes = ["scene", "scene2", "scene3"];

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
  const percent = (values) => Array.from(values, (value) => 100 * value);
  const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

  /* values(state, reference's state): on nodes, or on faces. difference: how the first panel differs from the second,
     where that is not the distance. */
  const quantities = {
    displacement: { label: "displacement", head: "displacement [mm]", values: (state) => lengths(state.u) },
    deviation: {
      label: "deviation from the reference", head: "deviation [mm]", needsBoth: true,
      values: (state, reference) => lengths(minus(state.u, reference.u)),
    },
    strain: {
      label: "strain (equivalent)", head: "equivalent strain [%]", difference: "difference [points]",
      values: (state) => percent(state.strain),
    },
    volume: {
      label: "volume change of cells", head: "V/V₀ − 1 [%]", difference: "difference [points]", isSigned: true,
      values: (state) => percent(state.volume),
    },
  };

  // Blue, white, red of ColorBrewer's RdBu, none of which the reference below has.
  const signed = [[0, "#2166ac"], [0.25, "#92c5de"], [0.5, "#f7f7f7"], [0.75, "#f4a582"], [1, "#b2182b"]];

  function surface(mesh, place, colouring, scene) {
    const [i, j, k] = [[], [], []];
    const { triangles } = mesh;
    for (let t = 0; t < triangles.length; t += 3) {
      i.push(triangles[t]); j.push(triangles[t + 1]); k.push(triangles[t + 2]);
    }
    return {
      type: "mesh3d", x: place[0], y: place[1], z: place[2], i, j, k, scene, flatshading: true,
      lighting: { ambient: 0.7, diffuse: 0.45, specular: 0.05, roughness: 0.9 }, ...colouring,
    };
  }
  function coloured(mesh, values, axis) {
    const ofFaces = values.length !== mesh.nodes.length / 3;
    return {
      intensity: ofFaces ? Array.from(mesh.faces, (face) => values[face]) : Array.from(values),
      intensitymode: ofFaces ? "cell" : "vertex", coloraxis: axis, hovertemplate: "%{intensity:.3g}<extra></extra>",
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
    const extreme = (values, pick) => values.reduce((found, one) => pick(found, one), values[0]);
    const size = Math.max(...place.map((values) => extreme(values, Math.max) - extreme(values, Math.min)));
    return place.map((values, axis) => values.map((value, i) => {
      const length = Math.hypot(normals[0][i], normals[1][i], normals[2][i]) || 1;
      return value + fraction * size * normals[axis][i] / length;
    }));
  }

  /* Edges of cells, a trace above the surface, which would hide half of them. */
  function wires(mesh, place, colour, scene) {
    const line = [[], [], []];
    const above = raised(mesh, place, 0.006);
    for (let e = 0; e < mesh.edges.length; e += 2)
      for (let axis = 0; axis < 3; ++axis)
        line[axis].push(above[axis][mesh.edges[e]], above[axis][mesh.edges[e + 1]], null);
    return {
      type: "scatter3d", mode: "lines", x: line[0], y: line[1], z: line[2], scene,
      line: { color: colour, width: 1.5 }, hoverinfo: "skip", showlegend: false,
    };
  }

  /* The traces of a pair of states, of which either may lack. The reference below the method's body is a little
     smaller than it is: of two that agree, the method's is seen, with all that it hides hidden. */
  function traces(mesh, pair, name) {
    const quantity = quantities[name];
    const places = pair.map((state) => state && positions(mesh.nodes, state.u));
    const list = [];
    pair.forEach((state, at) => {
      if (!state) return;
      const values = quantity.values(state, pair[1]);
      list.push(surface(mesh, places[at], coloured(mesh, values, "coloraxis"), scenes[at]));
      list.push(wires(mesh, places[at], "rgba(20,20,20,0.7)", scenes[at]));
    });
    if (pair[0] && pair[1]) {
      const [method, reference] = places;
      const axis = quantity.needsBoth ? "coloraxis" : "coloraxis2";
      list.push(surface(mesh, method, coloured(mesh, differences(pair, name), axis), scenes[2]));
      list.push(wires(mesh, method, "rgba(20,20,20,0.7)", scenes[2]));
      const below = raised(mesh, reference, -0.008);
      list.push(surface(mesh, below, { color: "#3a3f47", hoverinfo: "skip" }, scenes[2]));
      list.push(wires(mesh, below, "rgba(220,220,220,0.5)", scenes[2]));
    }
    return list;
  }

  function differences(pair, name) {
    const quantity = quantities[name];
    if (!quantity.difference) return quantities.deviation.values(pair[0], pair[1]);
    return minus(quantity.values(pair[0]), quantity.values(pair[1]));
  }

  /* Ranges over all pairs of states that the views go through, which thus keep scale and place. */
  function ranges(mesh, pairs, name) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    let values = 0, difference = 0;
    for (const pair of pairs) {
      for (const state of pair.filter(Boolean)) {
        values = Math.max(values, largest(quantities[name].values(state, pair[1])));
        positions(mesh.nodes, state.u).forEach((along, axis) => {
          low[axis] = along.reduce((least, one) => Math.min(least, one), low[axis]);
          high[axis] = along.reduce((most, one) => Math.max(most, one), high[axis]);
        });
      }
      if (pair[0] && pair[1]) difference = Math.max(difference, largest(differences(pair, name)));
    }
    // What lies on the range's very end would be cut off here and there.
    const margin = 0.01 * Math.max(...high.map((h, axis) => h - low[axis]));
    return {
      low: low.map((value) => value - margin), high: high.map((value) => value + margin),
      values: values || 1, difference: difference || 1,
    };
  }

  function layout(range, name, hasBoth, camera) {
    const size = range.high.map((h, axis) => h - range.low[axis]);
    // The sphere around the body fills the view.
    const longest = Math.hypot(...size) / 1.9;
    const axis = (a) => ({ range: [range.low[a], range.high[a]], visible: false });
    const scene = (from, to) => ({
      domain: { x: [from, to], y: [0, 1] }, camera: structuredClone(camera), dragmode: "orbit",
      xaxis: axis(0), yaxis: axis(1), zaxis: axis(2), aspectmode: "manual",
      aspectratio: { x: size[0] / longest, y: size[1] / longest, z: size[2] / longest },
    });
    const quantity = quantities[name];
    const bar = (text, x, most, isSigned) => ({
      cmin: isSigned ? -most : 0, cmax: most, colorscale: isSigned ? signed : "Viridis",
      colorbar: { title: { text, side: "right", font: { size: 11 } }, x, len: 0.8, thickness: 10, tickfont: { size: 10 } },
    });
    const other = quantity.difference ?? quantities.deviation.head;
    return {
      scene: scene(0, 0.29), scene2: scene(0.29, 0.58), scene3: scene(0.65, 0.94),
      coloraxis: bar(quantity.head, 0.58, range.values, Boolean(quantity.isSigned)),
      coloraxis2: { ...bar(other, 0.94, range.difference, Boolean(quantity.difference)),
                    showscale: hasBoth && !quantity.needsBoth },
      margin: { l: 0, r: 0, t: 0, b: 0 }, showlegend: false,
    };
  }

  return { layout, quantities, ranges, scenes, traces };
})();
