"use strict";

/* What is long lies packed in the page: gzip in base64, as report.py's _packed makes it. */
async function unpacked(id) {
  const packed = await fetch(`data:application/gzip;base64,${document.getElementById(id).textContent}`);
  return new Response(packed.body.pipeThrough(new DecompressionStream("gzip")));
}
