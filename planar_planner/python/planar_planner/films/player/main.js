// The page: it creates views, clock and controls from the material, and draws frames.

const material = JSON.parse(document.getElementById("material").textContent);
const camera = new Camera(material.world.view);
const world = new WorldView(document.getElementById("world"), camera, material);
const slice = material.cells
  ? new SliceView(document.getElementById("slice"), camera, material)
  : null;
const views = slice ? [world, slice] : [world];
const robot = material.robot.map(pathOf);
const total = material.travel.length ? material.travel[material.travel.length - 1] : 0;
const state = { robot, total, q: [0, 0, 0], where: 0, probe: null, probeText: "" };

let asked = false;
let theme = readTheme();

function redraw() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(frame);
}

const clock = new Clock(material.seconds, redraw);

/** Colours of the page's light or dark style. */
function readTheme() {
  const style = getComputedStyle(document.documentElement);
  const names = ["paper", "ink", "room", "outside", "obstacle", "none"];
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** Set the robot's configuration; without a path only the angle changes, through one turn. */
function place() {
  state.where = clock.share * total;
  if (material.path.length) {
    state.q = configurationAt(material.path, material.travel, state.where);
  } else {
    const [x, y, theta] = material.start;
    state.q = [x, y, material.rotation ? clock.share * TAU : theta];
  }
}

function follow() {
  const [x, y] = state.q;
  if (camera.x === x && camera.y === y) return;
  Object.assign(camera, { x, y });
  world.stale = true;
}

function probeText() {
  if (!state.probe || !slice) return "";
  slice.at(state.q[2]);
  const name = slice.labelAt(state.probe);
  const [x, y] = state.probe.map((value) => value.toPrecision(4));
  const what = name ? `${name}: ${material.meanings[name]}` : "no cell is shown here";
  return `(${x}, ${y}): ${what}`;
}

function frame(now) {
  asked = false;
  clock.tick(now);
  place();
  if (camera.following) follow();
  state.probeText = probeText();
  for (const view of views) {
    if (view.resize()) world.stale = true;
    view.draw(state, theme);
  }
  showState(material, clock, state);
  if (clock.playing) redraw();
}

camera.changed = () => {
  world.stale = true;
  redraw();
};

function probe(point) {
  state.probe = point;
  redraw();
}

writeTexts(material);
listenToControls(clock, camera);
listenToGestures(world, camera, () => {});
if (slice) listenToGestures(slice, camera, probe);
new ResizeObserver(redraw).observe(document.getElementById("views"));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  theme = readTheme();
  world.stale = true;
  redraw();
});

/** The state that is shown, for tests and debugging. */
globalThis.planarPlanner = () => ({
  share: clock.share,
  playing: clock.playing,
  configuration: [...state.q],
  zoom: camera.zoom,
  centre: [camera.x, camera.y],
  cells: slice ? slice.found.length : 0,
  probe: state.probe,
});

if (matchMedia("(prefers-reduced-motion: reduce)").matches) redraw();
else if (moves(material)) clock.play();
else redraw();
