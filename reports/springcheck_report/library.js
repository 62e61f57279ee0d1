"use strict";

/* The drawing library is long: it is unpacked and run when the first plot comes into sight. */
const loadPlotly = (function () {
  let loading = null;
  async function load() {
    const script = document.createElement("script");
    script.textContent = await (await unpacked("plotly")).text();
    document.head.append(script);
  }
  return () => (loading ??= load());
})();
