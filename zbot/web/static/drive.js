// Controls that drive a robot: sticks on the screen, keys, and a gamepad. While the user holds a
// control, the page repeats the values 20 times a second. The server stops the robot when they
// cease, so everything here that stops the robot only makes the stop faster.
"use strict";
window.zbotDrive = (() => {
  const WORD_MS = 50;
  const PATIENCE_MS = 500; // longest time without an answer of the server
  const DEAD_ZONE = 0.1; // of a gamepad's stick
  const SHOULDERS = [4, 5, 6, 7];
  const KEPT = "zbot-drive";
  // Ahead, left, turn to the left. The codes are places on the keyboard, not letters.
  const KEYS = {
    KeyW: [1, 0, 0], ArrowUp: [1, 0, 0], KeyS: [-1, 0, 0], ArrowDown: [-1, 0, 0],
    KeyA: [0, 0, 1], ArrowLeft: [0, 0, 1], KeyD: [0, 0, -1], ArrowRight: [0, 0, -1],
    KeyQ: [0, 1, 0], KeyE: [0, -1, 0],
  };
  const grips = new Map(); // the pointers that hold a stick: {stick, x (right), y (up)}
  const keys = new Set();
  const buttons = new Set(); // pressed buttons of the gamepad on the screen
  let mustRelease = false; // whether a gamepad's shoulder button must be released first
  let press = 0; // number of the press that is sent now, or 0
  let presses = 0;
  let words = 0;
  let sent = []; // words without an answer: [number, time]
  let timer = 0;

  const controls = () => document.querySelector(".zb-drive-controls");
  const limited = (value) => Math.max(-1, Math.min(1, value));

  function held(name) {
    for (const grip of grips.values()) if (grip.stick.dataset.stick === name) return grip;
    return { x: 0, y: 0 };
  }

  function keyed() {
    const sum = [0, 0, 0];
    for (const key of keys) KEYS[key].forEach((value, index) => (sum[index] += value));
    return sum;
  }

  // Returns the axes of the gamepad whose shoulder button is held: right and down are positive.
  function gamepad() {
    const pads = [...(navigator.getGamepads?.() ?? [])].filter((pad) => pad?.connected);
    const pad = pads.find((one) => SHOULDERS.some((button) => one.buttons[button]?.pressed));
    if (!pad || !document.hasFocus()) {
      if (!pad) mustRelease = false;
      return [0, 0, 0];
    }
    if (mustRelease) return [0, 0, 0];
    return [0, 1, 2].map((axis) => outside(pad.axes[axis] ?? 0));
  }

  function outside(value) {
    const size = Math.abs(value);
    return size < DEAD_ZONE ? 0 : (Math.sign(value) * (size - DEAD_ZONE)) / (1 - DEAD_ZONE);
  }

  // Ahead, left and turn of all controls together.
  function velocity(root) {
    const isOmni = Boolean(root.querySelector("[data-stick=turn]")?.offsetParent);
    const [keyAhead, keyLeft, keyTurn] = keyed();
    const [padX, padY, padTurn] = gamepad();
    const move = held("move");
    const across = -move.x - padX;
    const turn = keyTurn - held("turn").x - padTurn;
    const ahead = move.y + keyAhead - padY;
    return (isOmni ? [ahead, across + keyLeft, turn] : [ahead, 0, turn + across]).map(limited);
  }

  function sticksAndButtons(root) {
    const [ahead, , turn] = keyed();
    const [left, right] = [held("left"), held("right")];
    const count = root.querySelectorAll("[data-button]").length;
    const pressed = Array.from({ length: count }, (_, number) => Number(buttons.has(number)));
    return [limited(left.x - turn), limited(left.y + ahead), right.x, right.y, ...pressed];
  }

  function values(root) {
    return root.dataset.kind === "gamepad" ? sticksAndButtons(root) : velocity(root);
  }

  function draw(root, now) {
    const isGamepad = root.dataset.kind === "gamepad";
    const isOmni = !isGamepad && root.querySelector("[data-stick=turn]")?.offsetParent;
    const places = isGamepad
      ? { left: now.slice(0, 2), right: now.slice(2, 4) }
      : { move: [isOmni ? -now[1] : -now[2], now[0]], turn: [-now[2], 0] };
    for (const [name, [x, y]] of Object.entries(places)) {
      const stick = root.querySelector(`[data-stick=${name}]`);
      stick?.style.setProperty("--x", x);
      stick?.style.setProperty("--y", -y);
    }
    for (const button of root.querySelectorAll("[data-button]")) {
      button.setAttribute("aria-pressed", buttons.has(Number(button.dataset.button)));
    }
  }

  const isConnected = () => Boolean(window.did_handshake && window.socket?.connected);

  function say(now) {
    words += 1;
    sent.push([words, performance.now()]);
    emitEvent("zbot_drive", [press, words, now, performance.now()]);
  }

  // Sends the values. An event sends only the begin and the end of a press, so that a fast mouse
  // does not send more than 20 words a second.
  function update(isTick) {
    const root = controls();
    if (!root) return letGo("");
    const now = values(root);
    draw(root, now);
    const isHeld = now.some(Boolean);
    if (!press && !isHeld) return;
    if (!isConnected() || (sent.length && performance.now() - sent[0][1] > PATIENCE_MS)) {
      letGo("The page has lost its connection. The robot stops by itself.");
      return;
    }
    if (!isHeld) {
      say(now);
      press = 0;
    } else if (!press) {
      press = ++presses;
      sent = [];
      complain("");
      say(now);
    } else if (isTick) {
      say(now);
    }
  }

  // Releases all controls, and ends the press.
  function letGo(why) {
    const wasHeld = press;
    grips.clear();
    keys.clear();
    buttons.clear();
    mustRelease = true;
    press = 0;
    sent = [];
    const root = controls();
    if (root) draw(root, values(root).map(() => 0));
    if (wasHeld && isConnected()) {
      const zeros = root ? values(root).map(() => 0) : [];
      emitEvent("zbot_drive", [wasHeld, ++words, zeros, performance.now()]);
    }
    if (why) complain(why);
  }

  function complain(text) {
    const place = document.querySelector(".zb-drive-said");
    if (place) place.textContent = text;
  }

  function heard(number) {
    sent = sent.filter(([one]) => one > number);
  }

  // The server has stopped the robot, because it heard nothing new for 0.2 s.
  function refused(number) {
    if (number === press) letGo("The connection was too slow: the robot was stopped. Let go, and hold the control again.");
  }

  function start() {
    clearInterval(timer);
    timer = setInterval(update, WORD_MS, true);
    const kept = localStorage.getItem(KEPT);
    if (kept) emitEvent("zbot_drive_kept", JSON.parse(kept));
  }

  function keep(...limits) {
    localStorage.setItem(KEPT, JSON.stringify(limits));
  }

  function place(grip, event) {
    const box = grip.stick.getBoundingClientRect();
    const reach = box.width * 0.32; // as in drive.css
    const x = (event.clientX - box.left - box.width / 2) / reach;
    const y = (box.top + box.height / 2 - event.clientY) / reach;
    const far = Math.max(1, Math.hypot(x, y));
    [grip.x, grip.y] = [x / far, y / far];
  }

  function onPointer(type, act) {
    document.addEventListener(type, (event) => {
      const grip = grips.get(event.pointerId);
      if (grip) act(grip, event);
    });
  }

  document.addEventListener("pointerdown", (event) => {
    const stick = event.target.closest?.(".zb-stick");
    if (!stick || event.button) return;
    event.preventDefault();
    document.activeElement?.blur(); // keys shall drive, and not change the input that had the focus
    stick.setPointerCapture(event.pointerId);
    const grip = { stick };
    place(grip, event);
    grips.set(event.pointerId, grip);
    update();
  });
  onPointer("pointermove", (grip, event) => {
    // A mouse button that was released outside of the browser.
    if (event.pointerType === "mouse" && !(event.buttons & 1)) grips.delete(event.pointerId);
    else place(grip, event);
    update();
  });
  for (const type of ["pointerup", "pointercancel", "lostpointercapture"]) {
    onPointer(type, (_, event) => {
      grips.delete(event.pointerId);
      update();
    });
  }
  document.addEventListener("contextmenu", (event) => {
    if (event.target.closest?.(".zb-stick")) event.preventDefault(); // of a long touch
  });
  document.addEventListener("click", (event) => {
    const button = event.target.closest?.(".zb-drive-controls [data-button]");
    if (!button) return;
    const number = Number(button.dataset.button);
    if (!buttons.delete(number)) buttons.add(number);
    update();
  });

  function isTyping(target) {
    return target.closest?.("input, textarea, select, [contenteditable], .q-menu, .q-dialog");
  }

  document.addEventListener("keydown", (event) => {
    if (!controls()) return;
    // With these keys, some systems do not report that another key is released.
    if (event.ctrlKey || event.metaKey || event.altKey) return letGo("");
    if (isTyping(event.target)) {
      if (["Enter", "Escape"].includes(event.key)) event.target.blur();
      return;
    }
    if (!(event.code in KEYS)) return;
    event.preventDefault(); // arrows would scroll the page
    if (event.repeat) return;
    keys.add(event.code);
    update();
  });
  document.addEventListener("keyup", (event) => {
    if (keys.delete(event.code)) update();
  });

  document.addEventListener("visibilitychange", () => document.hidden && letGo(""));
  document.addEventListener("freeze", () => letGo(""));
  for (const type of ["blur", "pagehide", "gamepaddisconnected"]) {
    window.addEventListener(type, () => letGo(""));
  }

  return { heard, keep, refused, start };
})();
