"use strict";

/* All cases of the file: columns by name, each with a place for every case. */
const allCases = (function () {
  let data = null;
  function read() {
    data ??= JSON.parse(document.getElementById("cases-data").textContent);
    return data;
  }
  const column = (name) => read().columns[name];

  return {
    get file() { return read().file; },
    get columns() { return read().columns; },
    get looks() { return read().looks; },
    get answers() { return read().answers; },
    get usual() { return read().usual; },
    get statuses() { return read().statuses; },
    get count() { return column("key").codes.length; },

    /* A number or a text, null for none. */
    value(name, place) {
      const found = column(name);
      if (!found) return null;
      return found.values ? found.values[place] : found.texts[found.codes[place]] ?? null;
    },
    heading(name) {
      const { label, unit } = column(name);
      return unit ? `${label} [${unit}]` : label;
    },
    /* Places of the cases whose key begins so. */
    withKey(start) {
      const { texts, codes } = column("key");
      const found = [];
      codes.forEach((code, place) => { if (texts[code].startsWith(start)) found.push(place); });
      return found;
    },
    namesOf(role) {
      return Object.keys(read().columns).filter((name) => column(name).role === role);
    },
  };
})();
