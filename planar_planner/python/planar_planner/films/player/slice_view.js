// The cells that contain the robot's angle, in the plane of its reference point.

const OUTLINED_FROM = 5; // CSS pixels of a cell's shorter side; below this a line hides the colour

/** Return cells from base64: six little-endian uint16 corners and one label each, corners first. */
function decodeCells({ box, shown, data }) {
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  const words = new DataView(bytes.buffer);
  const [low, high] = box;
  const corner = (k) => {
    const axis = k % 3;
    const step = (high[axis] - low[axis]) / 65535;
    return Float64Array.from({ length: shown }, (_, i) => {
      return low[axis] + step * words.getUint16(2 * (k * shown + i), true);
    });
  };
  const [left, bottom, from, right, top, to] = [0, 1, 2, 3, 4, 5].map(corner);
  return { left, bottom, from, right, top, to, label: bytes.subarray(12 * shown), count: shown };
}

/** Return the indices of the cells at an angle; they are always the same if the robot cannot turn. */
function cellsAt(cells, turn, turning) {
  const found = [];
  for (let i = 0; i < cells.count; i += 1) {
    if (!turning || (cells.from[i] <= turn && turn < cells.to[i])) found.push(i);
  }
  return found;
}

class SliceView extends View {
  constructor(canvas, camera, material) {
    super(canvas, camera);
    this.material = material;
    this.cells = decodeCells(material.cells);
    this.found = [];
    this.turn = null;
  }

  /** Find the cells at an angle, unless the angle is the same as before. */
  at(theta) {
    const turn = turnOf(theta);
    if (turn !== this.turn) {
      this.found = cellsAt(this.cells, turn, this.material.rotation);
      this.turn = turn;
    }
    return this.found;
  }

  /** Name of the label at a place of the slice; null outside or where cells are not shown. */
  labelAt([x, y]) {
    const { left, right, bottom, top, label } = this.cells;
    const hit = this.found.find(
      (i) => left[i] <= x && x < right[i] && bottom[i] <= y && y < top[i],
    );
    return hit === undefined ? null : this.material.labels[label[hit]];
  }

  draw(state, theme) {
    const { context, material } = this;
    const { colours, path, travel, start, goal } = material;
    this.enterPixels();
    context.fillStyle = theme.outside;
    context.fillRect(0, 0, this.width, this.height);
    this.drawCells(this.at(state.q[2]), theme);
    this.drawAxes(theme.ink, theme.paper);
    this.enterScene();
    if (path.length) {
      drawLine(this, path, "#000000aa", 1);
      drawLine(this, pointsBehind(path, travel, state.where), "#000000", 2.5);
    }
    if (material.region) drawRegion(this, material.region, colours.goal);
    if (start) drawMark(this, start, colours.start, 5);
    if (goal) drawMark(this, goal, colours.goal, 5);
    if (path.length) {
      drawRobot(this, state.robot, state.q, { edge: colours.robot, wide: 2 });
      drawMark(this, state.q, colours.robot, 6);
    }
    if (state.probe) drawMark(this, state.probe, "#000000", 4);
  }

  drawCells(found, theme) {
    const { context, cells, material } = this;
    const [low, high] = material.cells.box;
    const round = (value, most) => Math.round(Math.min(most + 2, Math.max(-2, value)));
    const corners = (left, bottom, right, top) => {
      const i = round(this.toX(left), this.width);
      const j = round(this.toY(top), this.height);
      const k = round(this.toX(right), this.width);
      const m = round(this.toY(bottom), this.height);
      return [i, j, k - i, m - j];
    };
    context.fillStyle = theme.none;
    context.fillRect(...corners(low[0], low[1], high[0], high[1]));
    const lines = new Path2D();
    const least = OUTLINED_FROM * this.pixels;
    material.labels.forEach((name, label) => {
      context.fillStyle = material.colours[name];
      for (const i of found) {
        if (cells.label[i] !== label) continue;
        const box = corners(cells.left[i], cells.bottom[i], cells.right[i], cells.top[i]);
        if (box[2] <= 0 || box[3] <= 0) continue;
        context.fillRect(...box);
        if (box[2] >= least && box[3] >= least) {
          lines.rect(box[0] + 0.5, box[1] + 0.5, box[2], box[3]);
        }
      }
    });
    Object.assign(context, { strokeStyle: "#00000033", lineWidth: this.pixels });
    context.stroke(lines);
  }
}
