// Buttons, slider, keys and texts.

const byId = (id) => document.getElementById(id);

const STEP = 0.01; // share of the film for an arrow key; with Shift it is ten times as much
const ZOOM = 1.25; // factor for a key or button
const FOLLOW_ZOOM = 3; // without zoom the whole scene is visible, and following has no effect

function listenToControls(clock, camera) {
  const nearer = () => camera.zoomAt(ZOOM, camera.x, camera.y);
  const farther = () => camera.zoomAt(1 / ZOOM, camera.x, camera.y);
  byId("play").addEventListener("click", () => clock.toggle());
  byId("scrub").addEventListener("input", (event) => clock.seek(Number(event.target.value)));
  byId("rate").addEventListener("change", (event) => {
    clock.rate = Number(event.target.value);
  });
  byId("in").addEventListener("click", nearer);
  byId("out").addEventListener("click", farther);
  byId("fit").addEventListener("click", () => camera.fit());

  const follow = byId("follow");
  const followOrNot = () => {
    camera.following = follow.checked;
    if (follow.checked && camera.zoom <= 1) camera.zoomAt(FOLLOW_ZOOM, camera.x, camera.y);
    camera.changed();
  };
  follow.addEventListener("change", followOrNot);

  const keys = {
    f: () => {
      follow.checked = !follow.checked;
      followOrNot();
    },
    " ": () => clock.toggle(),
    ArrowLeft: (event) => clock.seek(clock.share - (event.shiftKey ? 10 : 1) * STEP),
    ArrowRight: (event) => clock.seek(clock.share + (event.shiftKey ? 10 : 1) * STEP),
    Home: () => clock.seek(0),
    End: () => clock.seek(1),
    "+": nearer,
    "=": nearer,
    "-": farther,
    0: () => camera.fit(),
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.closest("select, summary")) return;
    if (event.key === " " && event.target.closest("button, [type=checkbox]")) return; // its own
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act(event);
  });
}

function row(name, value) {
  const line = document.createElement("tr");
  const head = document.createElement("th");
  const cell = document.createElement("td");
  head.scope = "row";
  head.textContent = name;
  cell.textContent = value;
  line.append(head, cell);
  return line;
}

function legendEntry(text, colour, dashed = false) {
  const entry = document.createElement("li");
  const patch = document.createElement("i");
  if (dashed) patch.style.border = `2px dashed ${colour}`;
  else patch.style.background = colour;
  entry.append(patch, text);
  return entry;
}

/** Return whether anything changes with time: a robot on its path, or the angle. */
const moves = (material) => material.path.length > 0 || material.rotation;

/** Fill in the parts of the page that never change. */
function writeTexts(material) {
  const { colours, cells } = material;
  byId("name").textContent = material.name;
  byId("verdict").textContent = material.verdict;
  byId("statistics").append(...material.statistics.map(([name, value]) => row(name, value)));
  byId("note").textContent = material.note;
  const legend = [["start", colours.start]];
  if (material.goal) legend.push(["goal", colours.goal]);
  if (material.region) {
    const { text, escape } = material.region;
    legend.push([text, escape ? colours.goal : `${colours.goal}59`, escape]);
  }
  if (material.world.bounds) legend.push(["bounds of the reference point", colours.bounds, true]);
  if (material.path.length) legend.push(["robot", colours.robot]);
  if (cells) {
    legend.push(...material.labels.map((name) => [`${name}: ${material.meanings[name]}`, colours[name]]));
    if (cells.shown < cells.count) legend.push(["smaller cells than are shown", "var(--none)"]);
  }
  byId("legend").append(...legend.map((entry) => legendEntry(...entry)));
  byId("cells").hidden = !cells;
  byId("following").hidden = !material.path.length;
  for (const id of ["play", "scrub", "clock", "rate"]) byId(id).hidden = !moves(material);
  const [wide, high] = material.size ?? [];
  if (wide) document.body.style.setProperty("--most-wide", `${wide}px`);
  if (high) byId("views").style.setProperty("--most-high", `${high}px`);
  if (globalThis.innerWidth < 640) byId("details").open = false;
}

/** Update the parts of the page outside the views. */
function showState(material, clock, state) {
  const degrees = ((180 / Math.PI) * state.q[2]).toFixed(1);
  byId("play").setAttribute("aria-pressed", String(clock.playing));
  byId("play").setAttribute("aria-label", clock.playing ? "Pause" : "Play");
  byId("scrub").value = String(clock.share);
  const text = material.path.length
    ? `${state.where.toFixed(2)} of ${state.total.toFixed(2)}`
    : `θ = ${degrees}°`;
  byId("clock").textContent = text;
  byId("scrub").setAttribute("aria-valuetext", text);
  byId("angle").textContent = `at θ = ${degrees}°`;
  const places = material.path.length ? state.q.slice(0, 2).map((v) => v.toPrecision(4)) : null;
  byId("where").textContent = places ? `at (${places.join(", ")}, ${degrees}°)` : "";
  byId("probe").textContent = state.probeText;
}
