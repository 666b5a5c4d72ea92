// The position of the film, from 0 to 1, while it plays and while it is paused.

class Clock {
  constructor(seconds, redraw) {
    this.seconds = seconds;
    this.redraw = redraw;
    this.share = 0;
    this.rate = 1;
    this.playing = false;
    this.last = null; // when the last frame was shown, in milliseconds
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.share >= 1) this.share = 0;
    this.playing = true;
    this.last = null;
    this.redraw();
  }

  pause() {
    this.playing = false;
    this.redraw();
  }

  /** Go to a share of the travel, and pause there. */
  seek(share) {
    this.share = Math.min(1, Math.max(0, share));
    this.last = null;
    this.pause();
  }

  /** Advance to the present time; a tab that was hidden continues from its old position. */
  tick(now) {
    if (!this.playing) return;
    const elapsed = this.last === null ? 0 : Math.min(100, now - this.last);
    this.last = now;
    this.share += (this.rate * elapsed) / (1000 * this.seconds);
    if (this.share >= 1) {
      this.share = 1;
      this.playing = false;
    }
  }
}
