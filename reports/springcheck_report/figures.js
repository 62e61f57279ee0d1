"use strict";

/* The figures lie packed together. Where that fails, their files beside the page are shown. */
(async function () {
  const images = [...document.querySelectorAll("img[data-figure]")];
  if (!images.length) return;
  let drawings = {};
  try {
    drawings = await (await unpacked("figures")).json();
  } catch { /* a browser that cannot unpack, before 2023 */ }
  for (const image of images) {
    const drawing = drawings[image.dataset.figure];
    image.src = drawing ? URL.createObjectURL(new Blob([drawing], { type: "image/svg+xml" })) : `figures/${image.dataset.figure}.svg`;
  }
})();
