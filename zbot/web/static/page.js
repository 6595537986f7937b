// What every page needs in the browser: asking for what is new, the theme, copying a command.
"use strict";
window.zbot = (() => {
  const FRAME_MS = 1000 / 60;
  const FASTEST_MS = 2 * FRAME_MS;
  const SLOWEST_MS = 100; // while nothing changes
  const PATIENCE_MS = 3000; // an answer can be lost when the connection is made anew
  let pause = FASTEST_MS;
  let askedAt = -Infinity;
  let isWaiting = false;
  let timer = 0;

  // With the display: that stands still in a hidden page, and is slow on a slow machine. Only then,
  // as whoever waits for the display makes the browser draw sixty times a second.
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

  // NiceGUI runs this behind the changes that it sent before: they are drawn now.
  function answered(isChanged) {
    isWaiting = false;
    pause = isChanged ? FASTEST_MS : Math.min(SLOWEST_MS, pause * 1.3);
    askIn(askedAt + pause - performance.now() - FRAME_MS / 2); // half way to its frame
  }

  // Whoever looks or touches something wants to see what it does at once.
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

  // Once Quasar is there; until somebody chooses, the page follows the system.
  function restoreTheme() {
    const chosen = localStorage.getItem(THEME);
    if (window.Quasar && window.did_handshake !== undefined) {
      if (chosen) Quasar.Dark.set(chosen === "dark");
    } else {
      setTimeout(restoreTheme, 5);
    }
  }
  restoreTheme();

  async function copyText(text) {
    if (navigator.clipboard) return navigator.clipboard.writeText(text);
    // Browsers give pages from other machines the clipboard by this old way only.
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
  }

  return { answered, copyCommand, copyText, isDark, save, setQuery, switchTheme };
})();
