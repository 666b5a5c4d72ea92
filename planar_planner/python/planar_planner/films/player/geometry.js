// The robot's configuration at a travel, and the part of the plane on the screen.

const TAU = 2 * Math.PI;
const MOST_ZOOM = 1e4; // above this the single precision of canvases becomes visible

/** Configuration [x, y, theta] at a travel from the start; between waypoints it is linear. */
function configurationAt(path, travel, where) {
  const last = path.length - 1;
  if (where >= travel[last]) return path[last];
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (travel[middle] <= where) low = middle;
    else high = middle;
  }
  const length = travel[high] - travel[low];
  const share = length > 0 ? (where - travel[low]) / length : 0;
  return path[low].map((value, k) => value + share * (path[high][k] - value));
}

/** An angle in [0, 2π). */
function turnOf(theta) {
  const turn = ((theta % TAU) + TAU) % TAU;
  return turn < TAU ? turn : 0;
}

/** The part of the plane that all views show: a centre, and a zoom, 1 where everything fits. */
class Camera {
  constructor([left, bottom, right, top]) {
    this.box = { left, bottom, width: right - left, height: top - bottom };
    this.changed = () => {};
    this.following = false; // the robot stays in the middle
    this.fit();
  }

  fit() {
    const { left, bottom, width, height } = this.box;
    this.x = left + width / 2;
    this.y = bottom + height / 2;
    this.zoom = 1;
    this.changed();
  }

  /** Pixels per scene unit in a view of this size. */
  scale(width, height) {
    return this.zoom * Math.min(width / this.box.width, height / this.box.height);
  }

  /** Zoom about a point of the plane, which stays where it is on the screen. */
  zoomAt(factor, x, y) {
    const zoom = Math.min(MOST_ZOOM, Math.max(0.5, this.zoom * factor));
    const applied = zoom / this.zoom;
    this.x = x + (this.x - x) / applied;
    this.y = y + (this.y - y) / applied;
    this.zoom = zoom;
    this.keepNear();
  }

  move(dx, dy) {
    this.x += dx;
    this.y += dy;
    this.keepNear();
  }

  /** Keep the centre in the scene, so that the scene stays visible. */
  keepNear() {
    const { left, bottom, width, height } = this.box;
    this.x = Math.min(left + width, Math.max(left, this.x));
    this.y = Math.min(bottom + height, Math.max(bottom, this.y));
    this.changed();
  }
}

/** Polygon as rings of [x, y, x, y, …] → Path2D in scene units; fill it by the even-odd rule. */
function pathOf(rings) {
  const path = new Path2D();
  for (const ring of rings) {
    path.moveTo(ring[0], ring[1]);
    for (let k = 2; k < ring.length; k += 2) path.lineTo(ring[k], ring[k + 1]);
    path.closePath();
  }
  return path;
}

/** A step of 1, 2 or 5 times a power of ten, at least this long. */
function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= least);
}
