"use strict";

/* The drawing library is long: it is unpacked and run when the first plot comes into sight. */
const loadPlotly = (function () {
  let loading = null;
  async function load() {
    const packed = Uint8Array.from(atob(document.getElementById("plotly").textContent), (c) => c.charCodeAt(0));
    const script = document.createElement("script");
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    script.textContent = await new Response(stream).text();
    document.head.append(script);
  }
  return () => (loading ??= load());
})();
