// The arm in space on a canvas: take(replay) what is shown, draw(frame, fraction, {reference, deviation}), turn, zoom.
function armScene(canvas) {
  const colours = {estimate: [0, 114, 178], reference: "#d55e00", deviation: "#cc79a7"};
  const widths = {  // half width and half thickness at both ends [m]
    upper_arm: [0.045, 0.045, 0.038, 0.036], forearm: [0.042, 0.036, 0.028, 0.02],
    hand: [0.04, 0.014, 0.036, 0.01], girdle: [0.03, 0.03, 0.03, 0.03],
    thorax: [0.13, 0.08, 0.11, 0.07],
  };
  const ninetyFive = 2.448;  // standard deviations around 95 % in the plane
  const trailSeconds = 2;

  let replay = null, frame = 0, fraction = 0;
  const view = {yaw: 0, pitch: 0.35, zoom: 1};

  // Numbers of a frame; of the one that is shown, on the way to the next.
  function moment(numbers, at, perFrame, first, count) {
    const begin = at * perFrame + first, values = Array.from(numbers.subarray(begin, begin + count));
    if (at !== frame || fraction === 0) return values;
    const next = numbers.subarray(begin + perFrame, begin + perFrame + count);
    const sign = count === 4 && values.reduce((dot, value, k) => dot + value * next[k], 0) < 0 ? -1 : 1;
    return values.map((value, k) => value + fraction * (sign * next[k] - value));
  }
  const joint = (posture, at, j) => moment(posture.p, at, 3 * replay.joints.length, 3 * j, 3);
  const known = (point) => point.every(Number.isFinite);

  // Turns the view so that the way of the last joint goes from left to right, a little aslant.
  function lookAcross(root) {
    const last = replay.deviation ? replay.deviation.joint : replay.joints.length - 1;
    const step = Math.max(1, Math.floor(replay.time.length / 2000)), ways = [];
    for (let at = 0; at < replay.time.length; at += step) {
      const p = joint(replay.estimate, at, last), from = root < 0 ? [0, 0, 0] : joint(replay.estimate, at, root);
      if (known(p) && known(from)) ways.push([p[0] - from[0], p[1] - from[1]]);
    }
    const mean = [0, 1].map((axis) => ways.reduce((total, way) => total + way[axis], 0) / ways.length);
    const spread = (a, b) => ways.reduce((total, way) => total + (way[a] - mean[a]) * (way[b] - mean[b]), 0);
    view.yaw = Math.atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1)) / 2 + 0.35;
    if (!Number.isFinite(view.yaw)) view.yaw = 0.35;
  }

  // What the scene is centred on: below the shoulder, or the middle of a lone sensor's way.
  function fit() {
    const root = replay.joints.indexOf("shoulder");
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    let reach = 0.3;
    const step = Math.max(1, Math.floor(replay.time.length / 2000));
    for (let at = 0; at < replay.time.length; at += step) {
      const centre = root < 0 ? null : joint(replay.estimate, at, root);
      for (let j = 0; j < replay.joints.length; j++) {
        const p = joint(replay.estimate, at, j);
        if (!known(p)) continue;
        for (let axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis], p[axis]);
          high[axis] = Math.max(high[axis], p[axis]);
        }
        if (centre && known(centre)) reach = Math.max(reach, Math.hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]));
      }
    }
    lookAcross(root);
    replay.root = root;
    replay.centre = low.map((value, axis) => Number.isFinite(value) ? (value + high[axis]) / 2 : 0);
    if (root < 0 && low[0] <= high[0])
      reach = Math.max(reach, Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2);
    replay.reach = reach;
    replay.floor = Number.isFinite(low[2]) ? low[2] - 0.04 : 0;
  }

  // --- geometry -------------------------------------------------------------------------------
  function rotated(posture, at, segment, v) {
    const q = moment(posture.q, at, 4 * replay.segments.length, 4 * segment, 4), norm = Math.hypot(...q);
    const [w, x, y, z] = q.map((component) => component / norm);
    const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
    return [
      v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
      v[2] + w * t[2] + x * t[1] - y * t[0],
    ];
  }
  const sum = (a, b, factor = 1) => [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];

  // Orthographic: what lies to the right, up and towards the eye in the picture.
  function camera(width, heightPx, centre) {
    const cy = Math.cos(view.yaw), sy = Math.sin(view.yaw);
    const cp = Math.cos(view.pitch), sp = Math.sin(view.pitch);
    const right = [cy, sy, 0], toEye = [cp * sy, -cp * cy, sp], up = [-sp * sy, sp * cy, cp];
    const scale = view.zoom * 0.6 * Math.min(width, heightPx) / replay.reach;
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return {
      scale, right, up,
      at: (p) => {
        const d = sum(p, centre, -1);
        return [width / 2 + scale * dot(d, right), heightPx / 2 - scale * dot(d, up), dot(d, toEye)];
      },
    };
  }

  function corners(posture, at, [from, to, segment]) {
    let a = joint(posture, at, from), b = joint(posture, at, to);
    const lone = from === to;
    const name = replay.segments[segment];
    const girdle = name === "thorax" && replay.joints[to] === "shoulder";
    let size = girdle ? widths.girdle : widths[name];
    if (lone) {
      const half = Math.max(0.03, 0.05 * replay.reach);
      const y = rotated(posture, at, segment, [0, half, 0]);
      b = sum(a, y, -1);
      a = sum(a, y);
      size = [0.7 * half, 0.25 * half, 0.7 * half, 0.25 * half];
    }
    if (!known(a) || !known(b)) return null;
    const thick = rotated(posture, at, segment, [1, 0, 0]);
    const wide = girdle ? rotated(posture, at, segment, [0, 1, 0]) : rotated(posture, at, segment, [0, 0, 1]);
    if (!known(thick)) return null;
    const ring = (p, w, t) => [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(
      ([s, r]) => sum(sum(p, thick, s * t), wide, r * w));
    return ring(a, size[0], size[1]).concat(ring(b, size[2], size[3]));
  }
  const faces = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [0, 1, 2, 3], [4, 5, 6, 7]];
  const light = [0.35, 0.55, 0.95, 0.55, 0.75, 0.75];  // the volar side is the palest

  // --- drawing --------------------------------------------------------------------------------
  function polygon(context, points) {
    context.beginPath();
    points.forEach((p) => context.lineTo(p[0], p[1]));
    context.closePath();
  }

  function drawFloor(context, eye, centre) {
    const cell = replay.reach > 3 ? 1 : 0.25, half = Math.ceil(1.3 * replay.reach / cell) * cell;
    const x0 = Math.round(centre[0] / cell) * cell, y0 = Math.round(centre[1] / cell) * cell;
    context.strokeStyle = "#dcdcdc";
    context.lineWidth = 1;
    for (let d = -half; d <= half + 1e-9; d += cell)
      for (const [p, q] of [[[x0 + d, y0 - half], [x0 + d, y0 + half]], [[x0 - half, y0 + d], [x0 + half, y0 + d]]]) {
        context.beginPath();
        context.moveTo(...eye.at([...p, replay.floor]).slice(0, 2));
        context.lineTo(...eye.at([...q, replay.floor]).slice(0, 2));
        context.stroke();
      }
  }

  function drawTriad(context, eye, heightPx) {
    const origin = [46, heightPx - 46];
    context.font = "12px sans-serif";
    context.lineWidth = 2;
    [["x", 0], ["y", 1], ["z up", 2]].forEach(([name, axis]) => {
      const end = [origin[0] + 30 * eye.right[axis], origin[1] - 30 * eye.up[axis]];
      context.strokeStyle = context.fillStyle = "#444444";
      context.beginPath();
      context.moveTo(...origin);
      context.lineTo(...end);
      context.stroke();
      context.fillText(name, end[0] + 3, end[1] - 3);
    });
  }

  function drawTrail(context, eye, posture, colour) {
    const last = replay.deviation ? replay.deviation.joint : replay.joints.length - 1;
    context.strokeStyle = colour;
    context.globalAlpha = 0.5;
    context.lineWidth = 1.5;
    context.beginPath();
    let pen = false;
    for (let at = frame; at >= 0 && replay.time[frame] - replay.time[at] < trailSeconds; at--) {
      const p = joint(posture, at, last);
      if (!known(p)) { pen = false; continue; }
      const [x, y] = eye.at(p);
      pen ? context.lineTo(x, y) : context.moveTo(x, y);
      pen = true;
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  function drawSolid(context, eye) {
    const all = [];
    for (const bone of replay.bones) {
      const box = corners(replay.estimate, frame, bone);
      if (!box) continue;
      const points = box.map(eye.at), thorax = replay.segments[bone[2]] === "thorax";
      faces.forEach((face, f) => all.push({
        points: face.map((corner) => points[corner]), light: light[f], thorax,
        depth: face.reduce((depth, corner) => depth + points[corner][2], 0),
      }));
    }
    all.sort((a, b) => a.depth - b.depth);
    for (const face of all) {
      const tone = face.thorax ? [150, 150, 150] : colours.estimate;
      const shade = tone.map((c) => Math.round(c + (255 - c) * (1 - face.light) * 0.75));
      polygon(context, face.points);
      context.fillStyle = `rgb(${shade})`;
      context.strokeStyle = face.thorax ? "#777777" : "#003e63";
      context.lineWidth = 1;
      context.fill();
      context.stroke();
    }
  }

  function drawOutline(context, eye) {
    context.strokeStyle = colours.reference;
    context.lineWidth = 1.4;
    context.setLineDash([6, 4]);
    for (const bone of replay.bones) {
      const box = corners(replay.reference, frame, bone);
      if (!box) continue;
      const points = box.map(eye.at);
      for (const face of faces) {
        polygon(context, face.map((corner) => points[corner]));
        context.stroke();
      }
    }
    context.setLineDash([]);
  }

  function drawDeviation(context, eye) {
    const place = joint(replay.estimate, frame, replay.deviation.joint);
    const sd = [0, 1, 2].map((axis) => replay.deviation.sd[3 * frame + axis]);
    if (!known(place) || !known(sd)) return;
    let a = 0, b = 0, c = 0;  // covariance in the plane of the picture [[a, b], [b, c]]
    for (let axis = 0; axis < 3; axis++) {
      const variance = sd[axis] * sd[axis];
      a += variance * eye.right[axis] * eye.right[axis];
      b += variance * eye.right[axis] * eye.up[axis];
      c += variance * eye.up[axis] * eye.up[axis];
    }
    const mean = (a + c) / 2, half = Math.hypot((a - c) / 2, b), factor = ninetyFive * eye.scale;
    const [x, y] = eye.at(place);
    context.beginPath();
    context.ellipse(x, y, factor * Math.sqrt(mean + half), factor * Math.sqrt(Math.max(mean - half, 0)),
      -Math.atan2(2 * b, a - c) / 2, 0, 2 * Math.PI);
    context.fillStyle = colours.deviation;
    context.globalAlpha = 0.35;
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = "#7a3d5f";
    context.lineWidth = 1.5;
    context.stroke();
  }

  function draw(at, part, shown) {
    frame = at;
    fraction = part;
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, heightPx = canvas.clientHeight;
    if (width === 0) return;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(heightPx * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(heightPx * ratio);
    }
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = "#ffffff";
    context.fillRect(0, 0, width, heightPx);
    let centre = replay.root < 0 ? replay.centre : joint(replay.estimate, frame, replay.root);
    if (!known(centre)) centre = replay.centre;
    else if (replay.root >= 0) centre[2] -= 0.3 * replay.reach;
    const eye = camera(width, heightPx, centre);
    drawFloor(context, eye, centre);
    drawTriad(context, eye, heightPx);
    drawTrail(context, eye, replay.estimate, "#0072b2");
    drawSolid(context, eye);
    if (replay.reference && shown.reference) drawOutline(context, eye);
    if (replay.deviation && shown.deviation) drawDeviation(context, eye);
  }

  return {
    draw,
    take(taken) {
      replay = taken;
      frame = fraction = 0;
      fit();
    },
    turn(yaw, pitch) {
      view.yaw += yaw;
      view.pitch = Math.min(Math.max(view.pitch + pitch, -1.5), 1.5);
    },
    zoom(factor) {
      view.zoom = Math.min(Math.max(view.zoom * factor, 0.2), 8);
    },
  };
}
