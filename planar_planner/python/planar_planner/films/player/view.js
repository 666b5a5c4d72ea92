// A canvas on which the plane is drawn through the camera.

class View {
  constructor(canvas, camera) {
    this.canvas = canvas;
    this.camera = camera;
    this.context = canvas.getContext("2d");
    this.pixels = 1; // device pixels per CSS pixel
    this.width = 0;
    this.height = 0;
  }

  /** Take the size that the layout gives; return true if it has changed. */
  resize() {
    const pixels = Math.min(3, globalThis.devicePixelRatio || 1);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * pixels));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * pixels));
    if (width === this.width && height === this.height && pixels === this.pixels) return false;
    Object.assign(this, { pixels, width, height });
    Object.assign(this.canvas, { width, height });
    return true;
  }

  get scale() {
    return this.camera.scale(this.width, this.height);
  }

  /** Set the transform for drawing in scene units, with y upwards. */
  enterScene(context = this.context) {
    const s = this.scale;
    const { x, y } = this.camera;
    context.setTransform(s, 0, 0, -s, this.width / 2 - s * x, this.height / 2 + s * y);
  }

  enterPixels(context = this.context) {
    context.setTransform(1, 0, 0, 1, 0, 0);
  }

  /** Width in scene units of a line of so many CSS pixels. */
  line(cssPixels) {
    return (cssPixels * this.pixels) / this.scale;
  }

  toX(x) {
    return this.width / 2 + this.scale * (x - this.camera.x);
  }

  toY(y) {
    return this.height / 2 - this.scale * (y - this.camera.y);
  }

  /** The point of the plane under a place on the page. */
  pointAt(clientX, clientY) {
    const box = this.canvas.getBoundingClientRect();
    const i = (clientX - box.left - this.canvas.clientLeft) * this.pixels;
    const j = (clientY - box.top - this.canvas.clientTop) * this.pixels;
    return [
      this.camera.x + (i - this.width / 2) / this.scale,
      this.camera.y - (j - this.height / 2) / this.scale,
    ];
  }

  /** Numbers along the lower and the left edge. */
  drawAxes(ink, paper, context = this.context) {
    const step = roundStep((55 * this.pixels) / this.scale);
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const size = 11 * this.pixels;
    this.enterPixels(context);
    Object.assign(context, { font: `${size}px system-ui, sans-serif`, lineWidth: 3 * this.pixels });
    Object.assign(context, { fillStyle: ink, strokeStyle: paper, lineJoin: "round" });
    const write = (text, x, y) => {
      context.strokeText(text, x, y);
      context.fillText(text, x, y);
    };
    const [left, bottom] = this.cornerAt(0, this.height);
    const [right, top] = this.cornerAt(this.width, 0);
    context.textAlign = "center";
    context.textBaseline = "bottom";
    for (let k = Math.ceil(left / step); k * step <= right; k += 1) {
      const x = this.toX(k * step);
      context.fillRect(x, this.height - 4 * this.pixels, this.pixels, 4 * this.pixels);
      if (x > 3 * size && x < this.width - 2 * size) {
        write((k * step).toFixed(digits), x, this.height - 5 * this.pixels);
      }
    }
    context.textAlign = "left";
    context.textBaseline = "middle";
    for (let k = Math.ceil(bottom / step); k * step <= top; k += 1) {
      const y = this.toY(k * step);
      context.fillRect(0, y, 4 * this.pixels, this.pixels);
      if (y > 2 * size && y < this.height - 2 * size) {
        write((k * step).toFixed(digits), 6 * this.pixels, y);
      }
    }
    write("y", 6 * this.pixels, size);
    context.textAlign = "right";
    context.textBaseline = "bottom";
    write("x", this.width - 6 * this.pixels, this.height - 5 * this.pixels);
  }

  cornerAt(i, j) {
    return [
      this.camera.x + (i - this.width / 2) / this.scale,
      this.camera.y - (j - this.height / 2) / this.scale,
    ];
  }
}
