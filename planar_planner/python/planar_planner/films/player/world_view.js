// The robot among the obstacles. The still parts are drawn once for each place of the camera.

class WorldView extends View {
  constructor(canvas, camera, material) {
    super(canvas, camera);
    this.material = material;
    const { workspace, obstacles, bounds } = material.world;
    this.room = workspace && pathOf(workspace);
    this.obstacles = obstacles.map(pathOf);
    this.bounds = bounds;
    this.still = document.createElement("canvas");
    this.stale = true;
  }

  drawStill(theme) {
    const { still, material } = this;
    Object.assign(still, { width: this.width, height: this.height });
    const context = still.getContext("2d");
    context.fillStyle = this.room ? theme.outside : theme.room;
    context.fillRect(0, 0, this.width, this.height);
    this.enterScene(context);
    context.save();
    if (this.room) {
      context.fillStyle = theme.room;
      context.fill(this.room, "evenodd");
      context.clip(this.room, "evenodd");
    }
    const outlined = this.obstacles.length <= 300;
    Object.assign(context, { fillStyle: theme.obstacle, strokeStyle: theme.ink });
    context.lineWidth = this.line(0.8);
    for (const obstacle of this.obstacles) {
      context.fill(obstacle, "evenodd");
      if (outlined) context.stroke(obstacle);
    }
    context.restore();
    if (this.room) {
      Object.assign(context, { strokeStyle: theme.ink, lineWidth: this.line(1.8) });
      context.stroke(this.room);
    }
    if (material.region) drawRegion(this, material.region, material.colours.goal, context);
    if (this.bounds) {
      const [left, bottom, right, top] = this.bounds;
      Object.assign(context, { strokeStyle: material.colours.bounds, lineWidth: this.line(1.8) });
      context.setLineDash([this.line(6), this.line(4)]);
      context.strokeRect(left, bottom, right - left, top - bottom);
      context.setLineDash([]);
    }
    this.drawAxes(theme.ink, theme.paper, context);
    this.stale = false;
  }

  draw(state, theme) {
    if (this.stale) this.drawStill(theme);
    const { context, material } = this;
    const { colours, path, travel, start, goal } = material;
    this.enterPixels();
    context.drawImage(this.still, 0, 0);
    this.enterScene();
    for (const [q, colour] of [[start, colours.start], [goal, colours.goal]]) {
      if (q) drawRobot(this, state.robot, q, { fill: `${colour}66`, edge: colour, wide: 2 });
    }
    if (path.length) {
      drawLine(this, path, `${theme.ink}88`, 1);
      drawLine(this, pointsBehind(path, travel, state.where), theme.ink, 2);
      drawRobot(this, state.robot, state.q, { fill: colours.robot, edge: theme.ink });
      drawMark(this, state.q, theme.ink, 3);
    } else {
      for (const end of [start, goal]) {
        if (end) drawRobot(this, state.robot, [end[0], end[1], state.q[2]], { edge: theme.ink });
      }
    }
    if (state.probe) {
      const q = [...state.probe, state.q[2]];
      drawRobot(this, state.robot, q, { edge: theme.ink, wide: 2, dashed: true });
      drawMark(this, q, theme.ink, 3);
    }
  }
}
