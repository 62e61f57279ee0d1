"use strict";

/* The section that is read is marked in the navigation; on a narrow screen this opens as a menu. */
(function () {
  const root = document.documentElement;
  root.classList.add("scripted");  // without scripts the menu stays open
  const menu = document.getElementById("menu");
  const navigation = document.getElementById("navigation");
  const links = new Map([...navigation.querySelectorAll("nav a")].map((link) => [link.hash.slice(1), link]));

  function open(isOpen) {
    menu.setAttribute("aria-expanded", String(isOpen));
    navigation.classList.toggle("open", isOpen);
  }
  menu.addEventListener("click", () => open(menu.getAttribute("aria-expanded") !== "true"));
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || menu.getAttribute("aria-expanded") !== "true") return;
    open(false);
    menu.focus();
  });
  navigation.addEventListener("click", (event) => {
    if (event.target.closest("a")) open(false);
  });

  /* The last section that begins above the upper third of the window. */
  const sections = [...document.querySelectorAll("main > section")];
  let current = null;
  function mark() {
    const line = window.innerHeight / 3;
    const isAtEnd = window.innerHeight + window.scrollY >= root.scrollHeight - 2;
    const begun = sections.filter((section) => section.getBoundingClientRect().top <= line);
    // At the end several sections are in sight: the one that was asked for, else the last.
    const asked = sections.find((one) => `#${one.id}` === location.hash && one.getBoundingClientRect().top >= 0);
    const section = isAtEnd ? asked ?? sections.at(-1) : begun.at(-1) ?? sections[0];
    const link = links.get(section?.id);
    if (link === current) return;
    current?.removeAttribute("aria-current");
    current = link;
    if (!link) return;
    link.setAttribute("aria-current", "true");
    const [box, frame] = [link.getBoundingClientRect(), navigation.getBoundingClientRect()];
    if (box.top < frame.top || box.bottom > frame.bottom)
      navigation.scrollTop += box.top - frame.top - frame.height / 3;
  }
  /* What is folded is printed as well. */
  window.addEventListener("beforeprint", () => {
    for (const fold of document.querySelectorAll(".answers details, details.folded")) fold.open = true;
  });

  let isWaiting = false;
  function markSoon() {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => { isWaiting = false; mark(); });
  }
  window.addEventListener("scroll", markSoon, { passive: true });
  window.addEventListener("resize", markSoon);
  mark();
})();
