// How the vehicle holds itself: an artificial horizon for aircraft, the front wheels of a truck.

const DIAL = { width: 240, height: 180, radius: 74, x: 120, y: 80 };
const PER_DEGREE = 2.2; // [px] of pitch

function drawAttitude(canvas, one, state) {
  const context = overlay(canvas, canvas);
  if (one.kind === "ground") drawSteering(context, one, state);
  else drawHorizon(context, state);
}

function drawHorizon(context, { bank, pitch }) {
  const { radius, x, y, width, height } = DIAL;
  const roll = ((Number.isFinite(bank) ? bank : 0) * Math.PI) / 180;
  const up = Math.max(-30, Math.min(30, Number.isFinite(pitch) ? pitch : 0)) * PER_DEGREE;
  context.save();
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.clip();
  context.translate(x, y);
  context.rotate(roll); // to the left is positive: the horizon turns clockwise
  context.fillStyle = "#cfe6f5";
  context.fillRect(-200, -200, 400, 400);
  context.fillStyle = "#d9c7ae";
  context.fillRect(-200, up, 400, 300);
  context.strokeStyle = INK;
  context.lineWidth = 1.4;
  ray(context, -200, up, 200, up);
  context.lineWidth = 1;
  context.fillStyle = INK;
  context.font = `10px ${FONT}`;
  for (const mark of [-20, -10, 10, 20]) {
    const at = up - mark * PER_DEGREE;
    ray(context, -18, at, 18, at);
    context.fillText(String(Math.abs(mark)), 22, at + 3);
  }
  ray(context, 0, -radius, 0, -radius + 12);
  context.restore();
  context.strokeStyle = AXIS;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
  for (const angle of [-60, -45, -30, -20, -10, 0, 10, 20, 30, 45, 60]) {
    const a = ((angle - 90) * Math.PI) / 180;
    const inner = radius - (angle % 30 === 0 ? 8 : 5);
    ray(context, x + inner * Math.cos(a), y + inner * Math.sin(a), x + radius * Math.cos(a), y + radius * Math.sin(a));
  }
  context.strokeStyle = VERMILION;
  context.lineWidth = 3;
  ray(context, x - 38, y, x - 14, y);
  ray(context, x + 14, y, x + 38, y);
  context.fillStyle = VERMILION;
  context.fillRect(x - 2, y - 2, 4, 4);
  const side = (value, left, right) => `${steady(Math.abs(value), 1)}° ${Math.abs(value) < 0.05 ? "" : value > 0 ? left : right}`;
  caption(context, `bank ${side(bank, "left", "right")}${Number.isFinite(pitch) ? ` · pitch ${side(pitch, "up", "down")}` : ""}`, width, height);
}

/** The truck from above, its front wheels turned as they are. */
function drawSteering(context, one, { steering }) {
  const { width, height } = DIAL;
  const angle = Number.isFinite(steering) ? steering : 0;
  const { length, width: across } = one.body;
  const size = 118 / length;
  const [l, w] = [length * size, Math.min(60, across * size)];
  context.save();
  context.translate(width / 2, height / 2 - 12);
  context.strokeStyle = AXIS;
  context.fillStyle = "#f4f6f8";
  context.lineWidth = 1.5;
  context.fillRect(-w / 2, -l / 2, w, l);
  context.strokeRect(-w / 2, -l / 2, w, l);
  context.fillStyle = "#dfe7ee";
  context.fillRect(-w / 2, -l / 2, w, l * 0.22);
  context.strokeRect(-w / 2, -l / 2, w, l * 0.22);
  context.fillStyle = INK;
  for (const side of [-1, 1]) {
    wheel(context, (side * w) / 2, l * 0.3, 0);
    wheel(context, (side * w) / 2, -l * 0.3, (-angle * Math.PI) / 180);
  }
  context.restore();
  const side = Math.abs(angle) < 0.05 ? "" : angle > 0 ? " left" : " right";
  caption(context, `steering ${steady(Math.abs(angle), 1)}°${side}`, width, height);
}

function wheel(context, x, y, turn) {
  context.save();
  context.translate(x, y);
  context.rotate(turn);
  context.fillRect(-4, -11, 8, 22);
  context.restore();
}

function ray(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}

function caption(context, words, width, height) {
  context.fillStyle = INK;
  context.font = `600 12px ${FONT}`;
  context.textAlign = "center";
  context.fillText(words, width / 2, height - 6);
  context.textAlign = "start";
}
