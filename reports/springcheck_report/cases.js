"use strict";

/* All cases of the file: columns by name, each with a value for every case; from when `ready` is fulfilled. */
const allCases = (function () {
  let data = null;
  const ready = unpacked("cases-data").then((text) => text.json()).then((found) => { data = found; });
  const column = (name) => (Object.hasOwn(data.columns, name) ? data.columns[name] : null);
  const count = () => (column("key").codes ?? column("key").values).length;

  /* A number or a text, null for none. */
  function value(name, place) {
    const found = column(name);
    return found && (found.values[found.codes ? found.codes[place] : place] ?? null);
  }

  /* The same in the unit that people read it in, which its heading names. */
  function shown(name, place) {
    const found = value(name, place), factor = column(name)?.factor;
    return (factor ?? 1) !== 1 && found !== null ? Number((factor * found).toPrecision(15)) : found;
  }

  return {
    ready,
    get isThere() { return data !== null; },
    get file() { return data.file; },
    get looks() { return data.looks; },
    get answers() { return data.answers; },
    get usual() { return data.usual; },
    get statuses() { return data.statuses; },
    get count() { return count(); },
    column,
    value,
    shown,
    heading(name) {
      const { label, unit } = column(name);
      return unit ? `${label} [${unit}]` : label;
    },
    /* Places of the cases whose key begins so. */
    withKey(start) {
      return [...Array(count()).keys()].filter((place) => value("key", place).startsWith(start));
    },
    namesOf(role) {
      return Object.keys(data.columns).filter((name) => column(name).role === role);
    },
  };
})();
