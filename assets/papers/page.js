"use strict";
// Pairs: the seam follows the slider and the pointer; the wheel or the buttons magnify both pictures at the same place.
for (const pair of document.querySelectorAll(".pair")) {
    const wipe = pair.querySelector(".wipe"), slider = pair.querySelector("input");
    const images = wipe.querySelectorAll("img");
    const view = {scale: 1, x: 0, y: 0};
    const seam = () => wipe.style.setProperty("--seam", slider.value / 10 + "%");
    const place = () => {
        view.x = Math.min(0, Math.max(view.x, wipe.clientWidth * (1 - view.scale)));
        view.y = Math.min(0, Math.max(view.y, wipe.clientHeight * (1 - view.scale)));
        for (const image of images) image.style.transform = `translate(${view.x}px,${view.y}px) scale(${view.scale})`;
        wipe.classList.toggle("near", view.scale > 1.5);
    };
    const magnify = (factor, x, y) => {
        const scale = Math.min(16, Math.max(1, view.scale * factor)), by = scale / view.scale;
        view.x = x - (x - view.x) * by;
        view.y = y - (y - view.y) * by;
        view.scale = scale;
        place();
    };
    slider.addEventListener("input", seam);
    wipe.addEventListener("wheel", event => {
        event.preventDefault();
        const box = wipe.getBoundingClientRect();
        magnify(event.deltaY < 0 ? 1.25 : 0.8, event.clientX - box.left, event.clientY - box.top);
    }, {passive: false});
    wipe.addEventListener("pointerdown", event => wipe.setPointerCapture(event.pointerId));
    wipe.addEventListener("pointermove", event => {
        if (!event.buttons) return;
        if (event.shiftKey) {
            view.x += event.movementX;
            view.y += event.movementY;
            place();
            return;
        }
        const box = wipe.getBoundingClientRect();
        slider.value = 1000 * (event.clientX - box.left) / box.width;
        seam();
    });
    const tools = document.createElement("div");
    tools.className = "tools";
    for (const [name, factor] of [["closer", 2], ["farther", 0.5]]) {
        const button = document.createElement("button");
        button.textContent = name;
        button.addEventListener("click", () => magnify(factor, wipe.clientWidth / 2, wipe.clientHeight / 2));
        tools.append(button);
    }
    const hint = document.createElement("span");
    hint.textContent = "drag: seam; wheel: zoom; shift-drag: move";
    hint.className = "where";
    tools.append(hint);
    slider.after(tools);
    for (const image of images) image.draggable = false;
    seam();
}
// Single pictures: a click shows them at twice their size, each further click at twice that, until they go away.
const zoom = document.getElementById("zoom");
for (const image of document.querySelectorAll(".pictures img")) {
    image.addEventListener("click", () => {
        let scale = 2;
        const shown = image.cloneNode();
        const fit = () => { shown.style.width = scale * image.naturalWidth + "px"; };
        shown.addEventListener("click", event => {
            event.stopPropagation();
            scale *= 2;
            if (scale > 8) zoom.hidden = true;
            fit();
        });
        fit();
        zoom.replaceChildren(shown);
        zoom.hidden = false;
    });
}
zoom.addEventListener("click", () => { zoom.hidden = true; });
addEventListener("keydown", event => { if (event.key === "Escape") zoom.hidden = true; });
