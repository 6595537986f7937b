// Sensors of this browser: camera, microphone, motion and position. The server publishes what the
// functions here send. A source runs only while its switch in the panel is on.
"use strict";
window.zbotSensors = (() => {
  const KEPT = "zbot-sensors";
  const MOST_PICTURE = 930000; // characters; the server takes 700,000 bytes
  const MOST_SAMPLES = 32768; // the limit of an AnalyserNode in the Web Audio API
  const QUALITY = 0.8; // of a JPEG
  const SILENCE_MS = 4000;
  const PATIENCE_MS = 2000; // longest wait for an answer, which may be lost with the connection
  const MOST_WAITING = { camera: 2, microphone: 10, motion: 10, position: 10 };
  const options = {}; // of each source, from the server
  const runs = {}; // the running sources: {isOver, end, sent}
  let lock = null; // keeps the screen of a phone on

  const isConnected = () => Boolean(window.did_handshake && window.socket?.connected);

  class Problem extends Error {
    constructor(code) {
      super(code);
      this.code = code;
    }
  }

  const CODES = {
    NotAllowedError: "denied",
    SecurityError: "denied",
    NotFoundError: "absent",
    OverconstrainedError: "absent",
    NotReadableError: "busy",
    AbortError: "busy",
  };

  function fail(run, code) {
    if (run.isOver) return;
    stop(run.key);
    emitEvent("zbot_sensor_problem", [run.key, code]);
  }

  // A slow connection loses readings, and does not delay them more and more.
  function mayWait(run) {
    const now = performance.now();
    if (run.sent.length && now - run.sent[0][1] > PATIENCE_MS) run.sent = [];
    return !run.isOver && isConnected() && run.sent.length < MOST_WAITING[run.key];
  }

  function send(run, reading) {
    if (!mayWait(run)) return;
    run.count += 1;
    run.sent.push([run.count, performance.now()]);
    emitEvent("zbot_sensor", [run.key, run.count, reading]);
  }

  function taken(key, number) {
    const run = runs[key];
    if (run) run.sent = run.sent.filter(([one]) => one > number);
  }

  async function media(constraints) {
    if (!navigator.mediaDevices?.getUserMedia) throw new Problem("unsupported");
    return navigator.mediaDevices.getUserMedia(constraints);
  }

  function endTracks(run, stream) {
    for (const track of stream.getTracks()) {
      track.onended = () => fail(run, "ended"); // e.g. the camera was unplugged
    }
    return () => stream.getTracks().forEach((track) => track.stop());
  }

  async function camera(run, { hz, width, facing }) {
    const stream = await media({ video: { facingMode: facing, width: { ideal: width } } });
    const end = endTracks(run, stream);
    const video = document.querySelector(".zb-sensor-video");
    const canvas = document.createElement("canvas");
    video.muted = true; // only then iOS plays it without a click
    video.srcObject = stream;
    video.hidden = false;
    video.play().catch(() => {}); // it is interrupted if the source ends at once
    function grab() {
      if (!video.videoWidth || !mayWait(run)) return;
      const scale = Math.min(1, width / Math.max(video.videoWidth, video.videoHeight));
      canvas.width = Math.round(video.videoWidth * scale);
      canvas.height = Math.round(video.videoHeight * scale);
      canvas.getContext("2d").drawImage(video, 0, 0, canvas.width, canvas.height);
      const text = canvas.toDataURL("image/jpeg", QUALITY).split(",")[1];
      if (text.length > MOST_PICTURE) fail(run, "large");
      else send(run, [text, canvas.width, canvas.height]);
    }
    const timer = setInterval(grab, 1000 / hz);
    return () => {
      clearInterval(timer);
      end();
      video.srcObject = null;
      video.hidden = true;
    };
  }

  async function microphone(run, { hz }) {
    // The processing for phone calls would change the level.
    const plain = { echoCancellation: false, autoGainControl: false, noiseSuppression: false };
    const stream = await media({ audio: plain });
    const end = endTracks(run, stream);
    const context = new AudioContext();
    context.resume();
    const analyser = context.createAnalyser();
    // The level is that of the whole time since the last one: a short sound is not missed.
    const count = Math.min(MOST_SAMPLES, Math.ceil(context.sampleRate / hz));
    analyser.fftSize = Math.max(32, 2 ** Math.ceil(Math.log2(count)));
    context.createMediaStreamSource(stream).connect(analyser);
    const kept = new Float32Array(analyser.fftSize);
    const samples = kept.subarray(-count);
    const timer = setInterval(() => {
      analyser.getFloatTimeDomainData(kept);
      const sum = samples.reduce((total, value) => total + value * value, 0);
      send(run, [Math.sqrt(sum / samples.length)]);
    }, 1000 / hz);
    return () => {
      clearInterval(timer);
      end();
      context.close();
    };
  }

  async function motion(run, { hz }) {
    if (!window.DeviceMotionEvent || !window.DeviceOrientationEvent) throw new Problem("unsupported");
    // iOS asks the user, and only during a click.
    const asked = [DeviceMotionEvent, DeviceOrientationEvent].map((one) => one.requestPermission?.());
    if ((await Promise.all(asked)).includes("denied")) throw new Problem("denied");
    let angles = [null, null, null];
    let hasNorth = false;
    let moved = [null, null, null, null, null, null, null, null, null];
    let sentAt = -Infinity;
    const three = (value) => [value?.x ?? null, value?.y ?? null, value?.z ?? null];

    function tell() {
      const reading = [...angles, ...moved];
      const now = performance.now();
      // Browsers give values 60 times a second, and not at exact times.
      if (reading.every((value) => value === null) || now - sentAt < 1000 / hz - 8) return;
      sentAt = now;
      clearTimeout(timer);
      send(run, reading);
    }
    function turn(event) {
      const compass = event.webkitCompassHeading; // iOS: degrees from north to the east
      const isNorth = event.absolute || compass !== undefined;
      if (event.beta === null || (hasNorth && !isNorth)) return;
      hasNorth = isNorth;
      angles = [compass === undefined ? event.alpha : 360 - compass, event.beta, event.gamma];
      tell();
    }
    function move({ accelerationIncludingGravity, acceleration, rotationRate }) {
      const rates = [rotationRate?.alpha ?? null, rotationRate?.beta ?? null, rotationRate?.gamma ?? null];
      moved = [...three(accelerationIncludingGravity), ...three(acceleration), ...rates];
      tell();
    }
    const timer = setTimeout(() => fail(run, "silent"), SILENCE_MS);
    const listeners = { devicemotion: move, deviceorientation: turn, deviceorientationabsolute: turn };
    for (const [name, listener] of Object.entries(listeners)) window.addEventListener(name, listener);
    return () => {
      clearTimeout(timer);
      for (const [name, listener] of Object.entries(listeners)) window.removeEventListener(name, listener);
    };
  }

  async function position(run, { hz }) {
    if (!navigator.geolocation) throw new Problem("unsupported");
    let sentAt = -Infinity;
    function found({ coords }) {
      if (performance.now() - sentAt < 1000 / hz - 8) return;
      sentAt = performance.now();
      const { latitude, longitude, altitude, accuracy, altitudeAccuracy } = coords;
      send(run, [latitude, longitude, altitude, accuracy, altitudeAccuracy]);
    }
    function lost(error) {
      if (error.code === error.PERMISSION_DENIED) fail(run, "denied");
      else send(run, []);
    }
    const precise = { enableHighAccuracy: true, maximumAge: 0, timeout: 30000 };
    const number = navigator.geolocation.watchPosition(found, lost, precise);
    return () => navigator.geolocation.clearWatch(number);
  }

  const SOURCES = { camera, microphone, motion, position };

  async function start(key) {
    stop(key);
    const run = { key, isOver: false, count: 0, sent: [], end: () => {} };
    runs[key] = run;
    keepScreenOn();
    if (!window.isSecureContext) return fail(run, "insecure");
    if (!options[key]) return; // the page was just opened: `configure` starts it
    try {
      run.end = await SOURCES[key](run, options[key]);
    } catch (error) {
      return fail(run, error.code && error instanceof Problem ? error.code : CODES[error.name]);
    }
    if (run.isOver) run.end(); // the switch is off again
  }

  function stop(key) {
    const run = runs[key];
    if (!run) return;
    delete runs[key];
    run.isOver = true;
    run.end();
    if (!Object.keys(runs).length) {
      lock?.release();
      lock = null;
    }
  }

  function change(key, isOn) {
    if (isOn) start(key);
    else stop(key);
  }

  function configure(key, changed) {
    options[key] = changed;
    if (runs[key]) start(key);
  }

  function keep(settings) {
    localStorage.setItem(KEPT, JSON.stringify(settings));
  }

  // Tells the server what the browser has kept, and whether it gives sensors to this page.
  function begin() {
    let kept = null;
    try {
      kept = JSON.parse(localStorage.getItem(KEPT));
    } catch {
      localStorage.removeItem(KEPT);
    }
    emitEvent("zbot_sensors", [window.isSecureContext, kept]);
  }

  async function keepScreenOn() {
    try {
      lock ??= await navigator.wakeLock?.request("screen");
    } catch {
      lock = null; // e.g. the battery is low
    }
  }

  document.addEventListener("visibilitychange", () => {
    lock = null; // the browser has released it
    if (!document.hidden && Object.keys(runs).length) keepScreenOn();
  });

  return { begin, change, configure, keep, stop, taken };
})();
