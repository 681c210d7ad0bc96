// Buttons and keys of the picture that all pages have.

function connectScheme(view) {
  const root = document.documentElement, button = document.getElementById("scheme");
  const use = (scheme) => {
    root.dataset.scheme = scheme;
    button.textContent = scheme === "dark" ? "Light" : "Dark";
    view.useScheme();
  };
  const preference = matchMedia("(prefers-color-scheme: dark)");
  preference.addEventListener("change", () => use(preference.matches ? "dark" : "light"));
  button.addEventListener("click", () => use(root.dataset.scheme === "dark" ? "light" : "dark"));
  use(preference.matches ? "dark" : "light");
}

function connectViews(view) {
  const directions = { x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, 1] };
  const direction = (name) => {
    if (name === "fit") return view.direction();
    return directions[name] ? new THREE.Vector3(...directions[name]) : isoDirection;
  };
  for (const button of document.querySelectorAll("#views button"))
    button.addEventListener("click", () => view.look(direction(button.dataset.view)));
  const step = Math.PI / 24;
  const keys = {
    ArrowLeft: () => view.turn(-step, 0), ArrowRight: () => view.turn(step, 0),
    ArrowUp: () => view.turn(0, -step), ArrowDown: () => view.turn(0, step),
    "+": () => view.zoomBy(1.2), "=": () => view.zoomBy(1.2), "-": () => view.zoomBy(1 / 1.2),
    Home: () => view.look(view.direction()),
  };
  view.canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  });
}
