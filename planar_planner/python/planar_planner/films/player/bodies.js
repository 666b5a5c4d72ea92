// Drawing functions of both views: the robot, the path of its reference point, and marks.

/** Draw a function's shapes in the robot's own frame at a configuration. */
function atConfiguration(context, [x, y, theta], draw) {
  context.save();
  context.translate(x, y);
  context.rotate(theta);
  draw(context);
  context.restore();
}

/** Draw the robot, filled and outlined; either colour may be null, and the outline may be dashed. */
function drawRobot(view, shapes, q, { fill = null, edge = null, wide = 1.5, dashed = false }) {
  atConfiguration(view.context, q, (context) => {
    context.lineWidth = view.line(wide);
    context.lineJoin = "round";
    context.setLineDash(dashed ? [view.line(5), view.line(4)] : []);
    for (const shape of shapes) {
      if (fill) {
        context.fillStyle = fill;
        context.fill(shape, "evenodd");
      }
      if (edge) {
        context.strokeStyle = edge;
        context.stroke(shape);
      }
    }
    context.setLineDash([]);
  });
}

function drawLine(view, points, colour, wide) {
  const { context } = view;
  if (points.length < 2) return;
  context.beginPath();
  points.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
  Object.assign(context, { strokeStyle: colour, lineWidth: view.line(wide), lineJoin: "round" });
  context.stroke();
}

/** Draw the outline of a goal region, filled unless the robot has to leave it. */
function drawRegion(view, region, colour, context = view.context) {
  context.lineWidth = view.line(2);
  context.strokeStyle = colour;
  context.fillStyle = `${colour}26`;
  context.setLineDash(region.escape ? [view.line(7), view.line(4)] : []);
  for (const shape of region.outline.map(pathOf)) {
    if (!region.escape) context.fill(shape, "evenodd");
    context.stroke(shape);
  }
  context.setLineDash([]);
}

/** Draw a point with a white rim. */
function drawMark(view, [x, y], colour, radius) {
  const { context } = view;
  context.beginPath();
  context.arc(x, y, view.line(radius), 0, TAU);
  Object.assign(context, { fillStyle: colour, strokeStyle: "#ffffff", lineWidth: view.line(1.5) });
  context.fill();
  context.stroke();
}

/** Return the waypoints before a travel, and the place reached. */
function pointsBehind(path, travel, where) {
  const behind = path.filter((_, k) => travel[k] < where);
  behind.push(configurationAt(path, travel, where));
  return behind;
}
