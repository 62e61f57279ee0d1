"use strict";

/* What the explorer's choice offers and shows. A choice: test, x, y: measures, models: names of methods, fixed:
   {column: value as text}, log: axes. Cases are told by their places. */
const selection = (function () {
  const value = allCases.value;
  const distinct = (values) => [...new Set(values)].filter((one) => one !== null);
  const every = [...Array(allCases.count).keys()];

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
  /* Measures that they have; the one that the test answers with even where all of them failed. */
  const measured = (test, places) => {
    const own = allCases.answers[test];
    return measures.filter((name) => name === own || places.some((place) => value(name, place) !== null));
  };

  /* Columns that can be held fixed: the mesh and the load in words stand for their settings, unless one of
     these runs along the axis. */
  function fixable(choice, places) {
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
  function telling(choice, places) {
    const names = fixable(choice, places).filter(isProblem);
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

  /* Its method; where a setting that names tell runs along the axis, without it. */
  const model = (choice, place) => value(allCases.column(choice.x)?.variant ? "model" : "name", place);

  const models = (choice, places) => distinct(places.map((place) => model(choice, place))).sort();

  /* {curves: [{label, method, name, places}], merged: how many cases stand there once with another, the same
     simulation beside another reference}. */
  function shown(choice) {
    const fixed = Object.entries(choice.fixed);
    const kept = ofTest(choice.test).filter((place) => value(choice.x, place) !== null
      && choice.models.includes(model(choice, place))
      && fixed.every(([name, text]) => String(value(name, place)) === text));
    const free = fixable(choice, kept).filter((name) => name !== "material");
    const curves = models(choice, kept).flatMap((name) => curvesOf(choice, name, kept.filter((place) => model(choice, place) === name), free));
    return { curves, merged: kept.length - curves.reduce((sum, { places }) => sum + places.length, 0) };
  }
  /* Of one method: a curve for each of what else its cases differ in. The reference tells them apart only where
     what is shown depends on it. */
  function curvesOf(choice, method, places, free) {
    const differing = free.filter((name) => new Set(places.map((place) => value(name, place))).size > 1);
    const simulation = (place) => JSON.stringify([choice.x, ...differing].filter((name) => name !== "reference").map((name) => value(name, place)));
    const figures = (place) => JSON.stringify(choice.y.map((name) => value(name, place)));
    const once = new Map();
    for (const place of places) {
      const own = simulation(place) + figures(place);
      if (!once.has(own)) once.set(own, place);
    }
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
  const isMeasureAlong = (choice) => measures.includes(choice.x);
  const ok = (place) => value("status", place) === "ok";

  return { along, distinct, fixable, isMeasureAlong, isNumber, measured, measures, model, models, ofTest, ok, settings, shown, telling, tests };
})();
