// Functions of all pages, which request changes, set the theme, and copy the command.
"use strict";
window.zbot = (() => {
  const FRAME_MS = 1000 / 60;
  const FASTEST_MS = 2 * FRAME_MS;
  const SLOWEST_MS = 100; // pause while nothing changes
  const PATIENCE_MS = 3000; // longest wait, because an answer can be lost with the connection
  let pause = FASTEST_MS;
  let askedAt = -Infinity;
  let isWaiting = false;
  let timer = 0;

  // requestAnimationFrame pauses in a hidden page, and slows down on a slow machine. It is called
  // only after the delay, because a waiting call makes the browser draw sixty times a second.
  function askIn(delay) {
    clearTimeout(timer);
    timer = setTimeout(requestAnimationFrame, delay, ask);
  }

  function ask(now) {
    if (document.hidden || !window.did_handshake || !window.socket?.connected) {
      askIn(SLOWEST_MS);
      return;
    }
    isWaiting = true;
    askedAt = now;
    emitEvent("zbot_ask");
    askIn(PATIENCE_MS);
  }
  askIn(0);

  // NiceGUI applies the changes that it sent before this call, so the page already shows them.
  function answered(isChanged) {
    isWaiting = false;
    pause = isChanged ? FASTEST_MS : Math.min(SLOWEST_MS, pause * 1.3);
    askIn(askedAt + pause - performance.now() - FRAME_MS / 2); // half a frame before the next frame
  }

  // After a user's input, changes should be visible immediately.
  function hurry() {
    pause = FASTEST_MS;
    if (!isWaiting) askIn(0);
  }

  document.addEventListener("visibilitychange", () => {
    if (document.hidden && window.did_handshake) emitEvent("zbot_sleep");
    hurry();
  });
  for (const event of ["pointerdown", "keydown"]) document.addEventListener(event, hurry, true);

  const THEME = "zbot-theme";

  function isDark() {
    return document.body.classList.contains("body--dark");
  }

  function switchTheme() {
    const dark = !isDark();
    localStorage.setItem(THEME, dark ? "dark" : "light");
    Quasar.Dark.set(dark);
  }

  // Waits until Quasar is loaded. If the user chose no theme, the page uses the system's theme.
  function restoreTheme() {
    const chosen = localStorage.getItem(THEME);
    if (window.Quasar && window.did_handshake !== undefined) {
      if (chosen) Quasar.Dark.set(chosen === "dark");
    } else {
      setTimeout(restoreTheme, 5);
    }
  }
  restoreTheme();
  // The user has changed the theme in another window, or around this frame.
  window.addEventListener("storage", (event) => {
    if (event.key === THEME && window.Quasar) Quasar.Dark.set(event.newValue === "dark");
  });

  // In a frame of the panel Layout, a page shows only its panel.
  const isInside = window.parent !== window;
  document.documentElement.classList.toggle("zb-inside", isInside);

  async function copyText(text) {
    if (navigator.clipboard) return navigator.clipboard.writeText(text);
    // Browsers provide navigator.clipboard to pages of other machines only with HTTPS.
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }

  async function copyCommand() {
    await copyText(document.querySelector(".zb-command").textContent);
    Quasar.Notify.create({ message: "Copied", timeout: 800, position: "bottom-right" });
  }

  function save(name, text, type) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    URL.revokeObjectURL(link.href);
  }

  function setQuery(query) {
    const words = new URLSearchParams(query).toString();
    history.replaceState(history.state, "", words ? `?${words}` : location.pathname);
    if (isInside) window.parent.zbot?.layout.changed(window, location.pathname + location.search);
  }

  return { answered, copyCommand, copyText, isDark, save, setQuery, switchTheme };
})();
