// Mouse, touch and wheel in a view: drag to pan, pinch or wheel to zoom, tap or point to probe.

const TAP = 6; // CSS pixels that a finger may move in a tap

function listenToGestures(view, camera, probe) {
  const { canvas } = view;
  const down = new Map(); // pointers that touch, by id: where they are on the page
  let slipped = 0;

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    if (down.size === 0) slipped = 0;
    down.set(event.pointerId, [event.clientX, event.clientY]);
    if (event.isTrusted) canvas.setPointerCapture(event.pointerId);
  });

  canvas.addEventListener("pointermove", (event) => {
    const here = [event.clientX, event.clientY];
    const before = down.get(event.pointerId);
    if (!before) {
      if (event.pointerType === "mouse") probe(view.pointAt(...here));
      return;
    }
    slipped += Math.hypot(here[0] - before[0], here[1] - before[1]);
    const others = [...down].filter(([id]) => id !== event.pointerId);
    const old = view.pointAt(...before);
    const now = view.pointAt(...here);
    if (others.length === 0 && slipped > TAP) {
      camera.move(old[0] - now[0], old[1] - now[1]);
    } else if (others.length === 1) {
      const fixed = others[0][1];
      const spread = (place) => Math.hypot(place[0] - fixed[0], place[1] - fixed[1]);
      if (spread(before) > 1) {
        camera.zoomAt(spread(here) / spread(before), ...view.pointAt(...fixed));
      }
    }
    down.set(event.pointerId, here);
  });

  const lift = (event) => {
    if (!down.delete(event.pointerId)) return;
    if (event.type === "pointerup" && down.size === 0 && slipped <= TAP) {
      probe(view.pointAt(event.clientX, event.clientY));
    }
  };
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);
  canvas.addEventListener("pointerleave", (event) => {
    if (event.pointerType === "mouse" && down.size === 0) probe(null);
  });

  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
      const amount = Math.min(200, Math.max(-200, event.deltaY * lines));
      camera.zoomAt(Math.exp(-amount / 300), ...view.pointAt(event.clientX, event.clientY));
    },
    { passive: false },
  );
}
