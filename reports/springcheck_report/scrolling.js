"use strict";

/* Brings an element to the top of the window. Sections get their height when they come into sight, so it is
   done again while they do, until the reader scrolls. */
function bringToTop(element) {
  const stop = new AbortController();
  setTimeout(() => {  // not by the key or click that leads here
    for (const event of ["wheel", "touchmove", "keydown", "pointerdown"])
      window.addEventListener(event, () => stop.abort(), { once: true, passive: true, signal: stop.signal });
  });
  for (const wait of [0, 80, 200, 400, 800])
    setTimeout(() => { if (!stop.signal.aborted) element.scrollIntoView(); }, wait);
}

(function () {
  function follow() {
    const element = location.hash.length > 1 && document.getElementById(location.hash.slice(1));
    if (element) bringToTop(element);
  }
  window.addEventListener("hashchange", follow);
  document.addEventListener("click", (event) => {  // to where the address leads already
    const link = event.target.closest("a[href^='#']");
    if (link && link.hash === location.hash) follow();
  });
  follow();
})();
