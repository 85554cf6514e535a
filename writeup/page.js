// Lays the second picture of each comparison over the first; a slider, or a finger on the picture, moves the edge between.
"use strict";
for (const figure of document.querySelectorAll("figure.compare")) {
  const pair = figure.querySelector(".pair");
  const slider = document.createElement("input");
  slider.type = "range";
  slider.min = "0";
  slider.max = "100";
  slider.value = "50";
  slider.setAttribute("aria-label", [...pair.querySelectorAll(".label")].map((l) => l.textContent).join(" against "));
  const show = () => pair.style.setProperty("--cut", slider.value + "%");
  slider.addEventListener("input", show);
  const follow = (event) => {
    const box = pair.getBoundingClientRect();
    slider.value = String((100 * (event.clientX - box.left)) / box.width);
    show();
  };
  pair.addEventListener("pointerdown", follow);
  pair.addEventListener("pointermove", (event) => event.buttons && follow(event));
  pair.addEventListener("dragstart", (event) => event.preventDefault());
  pair.after(slider);
  figure.classList.add("live");
  show();
}

// A click on a picture shows it as large as the window allows; another click, or Escape, closes it.
const light = document.createElement("dialog");
light.className = "light";
light.append(document.createElement("img"));
light.addEventListener("click", () => light.close());
document.body.append(light);
for (const image of document.querySelectorAll("figure > img")) {
  image.tabIndex = 0;
  const open = () => {
    const shown = light.firstChild;
    shown.src = image.src;
    shown.alt = image.alt;
    shown.className = image.className;
    light.showModal();
  };
  image.addEventListener("click", open);
  image.addEventListener("keydown", (event) => event.key === "Enter" && open());
}

// A button that copies the command.
if (navigator.clipboard)
  for (const command of document.querySelectorAll("code.command")) {
    const button = document.createElement("button");
    button.textContent = "copy";
    const text = command.textContent;
    button.addEventListener("click", () =>
      navigator.clipboard.writeText(text).then(() => (button.textContent = "copied")));
    command.append(button);
  }

// On a phone, every section but the first is folded to its heading; a link to it, or a click, opens it.
const isNarrow = matchMedia("(max-width: 45rem)");
const mayFold = () => document.body.classList.toggle("foldable", isNarrow.matches);
isNarrow.addEventListener("change", mayFold);
mayFold();
const sections = [...document.querySelectorAll("main > section[id]")];
for (const section of sections.slice(1)) {
  const heading = section.querySelector("h2");
  const button = document.createElement("button");
  button.className = "fold";
  const fold = (isFolded) => {
    section.classList.toggle("folded", isFolded);
    button.textContent = isFolded ? "show" : "hide";
    button.setAttribute("aria-expanded", String(!isFolded));
  };
  button.setAttribute("aria-label", "Section " + heading.textContent);
  button.addEventListener("click", () => fold(!section.classList.contains("folded")));
  heading.append(button);
  section.unfold = () => fold(false);
  fold(true);
}
const unfoldTarget = () => {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  target?.closest("section")?.unfold?.();
  target?.scrollIntoView();
};
addEventListener("hashchange", unfoldTarget);
if (location.hash) unfoldTarget();
