// Panels side by side. Each is a page in a frame, and reports the changes of its address.
"use strict";
zbot.layout = (() => {
  const KEPT = "zbot-layout";

  function ask(key) {
    // The handshake must be over, because an earlier event would be lost.
    if (!window.did_handshake) return setTimeout(ask, 20, key);
    emitEvent("zbot_layout_kept", localStorage.getItem(`${KEPT} ${key}`));
  }

  function keep(key, text) {
    if (text === null) localStorage.removeItem(`${KEPT} ${key}`);
    else localStorage.setItem(`${KEPT} ${key}`, text);
  }

  async function copyLink() {
    await zbot.copyText(location.href);
    Quasar.Notify.create({ message: "Copied", timeout: 800, position: "bottom-right" });
  }

  // A panel in a frame calls this.
  function changed(page, address) {
    for (const frame of document.querySelectorAll("iframe[data-tile]")) {
      if (frame.contentWindow === page) emitEvent("zbot_tile", frame.dataset.tile, address);
    }
  }

  return { ask, keep, copyLink, changed };
})();
