// The 3D view in a frame. It is another page of this machine, which another port serves.
"use strict";
zbot.showView = (id, address) => {
  const frame = getHtmlElement(id);
  const target = new URL(address);
  if (!frame || target.protocol !== "http:" || target.hostname !== location.hostname) return;
  if (zbot.isDark()) target.searchParams.set("darkMode", "1");
  frame.src = target.href;
};
