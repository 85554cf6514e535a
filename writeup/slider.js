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
