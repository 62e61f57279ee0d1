"use strict";

/* All cases of the file: columns by name, each with a value for every case. */
const allCases = (function () {
  let data = null;
  function read() {
    data ??= JSON.parse(document.getElementById("cases-data").textContent);
    return data;
  }
  const column = (name) => (Object.hasOwn(read().columns, name) ? read().columns[name] : null);
  const count = () => (column("key").codes ?? column("key").values).length;

  /* A number or a text, null for none. */
  function value(name, place) {
    const found = column(name);
    return found && (found.values[found.codes ? found.codes[place] : place] ?? null);
  }

  return {
    get file() { return read().file; },
    get looks() { return read().looks; },
    get answers() { return read().answers; },
    get usual() { return read().usual; },
    get statuses() { return read().statuses; },
    get count() { return count(); },
    column,
    value,
    heading(name) {
      const { label, unit } = column(name);
      return unit ? `${label} [${unit}]` : label;
    },
    /* Places of the cases whose key begins so. */
    withKey(start) {
      return [...Array(count()).keys()].filter((place) => value("key", place).startsWith(start));
    },
    namesOf(role) {
      return Object.keys(read().columns).filter((name) => column(name).role === role);
    },
  };
})();
