// Plays, scrubs and turns the arm in space (scene.js). The data are those of replay_json.h.
(() => {
  const section = document.getElementById("replay");
  if (!section) return;
  const part = (name) => section.querySelector("." + name);
  const canvas = part("scene"), scene = armScene(canvas), slider = part("time"), clock = part("clock");
  let replay = null, frame = 0, playing = false, started = 0, startTime = 0;
  let fraction = 0;  // of the way to the next frame, for the picture alone

  function load(index) {
    const text = JSON.parse(document.getElementById("replay-" + index).textContent);
    const posture = (packed) => packed && {p: unpacked(packed.p), q: unpacked(packed.q)};
    replay = {
      index, name: text.name, joints: text.joints, segments: text.segments, bones: text.bones,
      time: new Float64Array(packedBytes(text.time)), notes: text.notes,
      estimate: posture(text.estimate), reference: posture(text.reference),
      deviation: text.deviation && {joint: text.deviation.joint, sd: unpacked(text.deviation.sd)},
      angles: text.angles.map((angle) => ({
        name: angle.name, value: unpacked(angle.value), sd: unpacked(angle.sd),
        reference: angle.reference && unpacked(angle.reference),
      })),
    };
    frame = fraction = 0;
    replay.step = replay.time.length > 1 ? (replay.time.at(-1) - replay.time[0]) / (replay.time.length - 1) : 1;
    slider.max = String(replay.time.length - 1);
    scene.take(replay);
    part("with-reference").disabled = !replay.reference;
    part("with-deviation").disabled = !replay.deviation;
    part("notes").textContent = replay.notes.join(" ");
    buildReadout();
    show();
  }

  function draw() {
    scene.draw(frame, fraction, {
      reference: part("with-reference").checked, deviation: part("with-deviation").checked,
    });
  }

  // --- numbers --------------------------------------------------------------------------------
  const degrees = (value) => Number.isFinite(value) ? value.toFixed(2) : "–";

  function buildReadout() {
    const body = part("readout").tBodies[0];
    body.replaceChildren(...replay.angles.map((angle) => {
      const row = document.createElement("tr"), name = document.createElement("th");
      name.scope = "row";
      name.textContent = angle.name.replaceAll("_", " ");
      row.dataset.angle = angle.name;
      row.append(name, ...[0, 1, 2].map(() => document.createElement("td")));
      return row;
    }));
  }

  function show() {
    slider.value = String(frame);
    const time = replay.time[frame];
    clock.textContent = `${time.toFixed(3)} s`;
    slider.setAttribute("aria-valuetext", clock.textContent);
    replay.angles.forEach((angle, i) => {
      const cells = part("readout").tBodies[0].rows[i].cells;
      [angle.value, angle.sd, angle.reference].forEach((values, k) => {
        cells[k + 1].textContent = values ? degrees(values[frame]) : "–";
      });
    });
    draw();
    document.dispatchEvent(new CustomEvent("moment", {detail: {estimate: replay.index, time}}));
  }

  // --- time -----------------------------------------------------------------------------------
  function frameAt(time) {
    let low = 0, high = replay.time.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (replay.time[middle] <= time) low = middle; else high = middle - 1;
    }
    return low;
  }

  function seek(to) {
    frame = Math.min(Math.max(to, 0), replay.time.length - 1);
    fraction = 0;
    restart();
    show();
  }

  function restart() {
    started = performance.now();
    startTime = replay.time[frame];
  }

  function play(on) {
    if (on && frame === replay.time.length - 1) frame = 0;
    playing = on;
    fraction = 0;
    part("play").textContent = on ? "Pause" : "Play";
    restart();
    if (on) requestAnimationFrame(step);
  }

  function step(now) {
    if (!playing) return;
    const speed = Number(part("speed").value);
    const time = startTime + speed * Math.max(now - started, 0) / 1000, next = frameAt(time);
    const length = replay.time[next + 1] - replay.time[next];
    fraction = length < 1.8 * replay.step ? Math.max(time - replay.time[next], 0) / length : 0;
    if (next !== frame) {
      frame = next;
      show();
    } else {
      draw();
    }
    if (frame === replay.time.length - 1) play(false);
    else requestAnimationFrame(step);
  }

  // --- hands ----------------------------------------------------------------------------------
  const turn = (yaw, pitch) => { scene.turn(yaw, pitch); draw(); };
  const zoom = (factor) => { scene.zoom(factor); draw(); };

  function second() { return Math.max(1, frameAt(replay.time[frame] + 1) - frame); }

  function onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const control = event.target;
    if (control.tagName === "SELECT" || (event.key === " " && control.tagName !== "CANVAS" && control !== slider && control !== section)) return;
    const keys = {
      " ": () => play(!playing), ArrowLeft: () => seek(frame - (event.shiftKey ? second() : 1)),
      ArrowRight: () => seek(frame + (event.shiftKey ? second() : 1)),
      Home: () => seek(0), End: () => seek(replay.time.length - 1),
      ArrowUp: () => turn(0, 0.1), ArrowDown: () => turn(0, -0.1),
      a: () => turn(-0.1, 0), d: () => turn(0.1, 0), "+": () => zoom(1.2), "=": () => zoom(1.2), "-": () => zoom(1 / 1.2),
    };
    if (!keys[event.key]) return;
    keys[event.key]();
    event.preventDefault();
  }

  let drag = null;
  canvas.addEventListener("pointerdown", (event) => {
    drag = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({preventScroll: true});
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!drag) return;
    turn(-(event.clientX - drag[0]) / 150, (event.clientY - drag[1]) / 150);
    drag = [event.clientX, event.clientY];
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { drag = null; });

  part("play").addEventListener("click", () => play(!playing));
  slider.addEventListener("input", () => seek(Number(slider.value)));
  part("speed").addEventListener("change", restart);
  for (const name of ["with-reference", "with-deviation"]) part(name).addEventListener("change", draw);
  part("which").addEventListener("change", (event) => { play(false); load(Number(event.target.value)); });
  section.addEventListener("keydown", onKey);
  document.addEventListener("seek", (event) => {
    if (event.detail.estimate !== replay.index) {
      part("which").value = String(event.detail.estimate);
      load(event.detail.estimate);
    }
    seek(frameAt(event.detail.time));
  });
  new ResizeObserver(draw).observe(canvas);
  section.classList.add("is-live");
  load(0);
  document.documentElement.dataset.replay = "ready";
})();
