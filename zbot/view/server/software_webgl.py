"""Script for browsers that draw WebGL in software: half of the processor time for each picture.

viser asks the browser for smooth edges (four samples a pixel), and has no setting against it. In
software these samples cost more than all else: docs/design/view.md has the figures. So the guard
adds a script to viser's page, which asks for one sample, and for fewer pixels by viser's own
parameter `fixedDpr`. With a graphics card the script changes nothing.
"""

from __future__ import annotations

import re

_PLACE = b"<head>"
_SCRIPT = b"""<script>(() => {
  const seen = document.createElement("canvas").getContext("webgl2");
  const names = seen?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? seen.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  seen?.getExtension("WEBGL_lose_context")?.loseContext();
  if (!/swiftshader|llvmpipe|softpipe|software|basic render/i.test(name)) return;
  const make = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return make.call(this, kind, kind === "webgl2" ? { ...options, antialias: false } : options);
  };
  const address = new URL(location.href);
  if (address.searchParams.has("fixedDpr")) return;
  address.searchParams.set("fixedDpr", "0.6");
  history.replaceState(null, "", address);
})();</script>"""


def with_script(head: bytes, body: bytes) -> tuple[bytes, bytes]:
    """Return the head and the body of an answer, with the script if it is viser's page."""
    if b"text/html" not in head.lower() or _PLACE not in body:
        return head, body
    whole = body.replace(_PLACE, _PLACE + _SCRIPT, 1)
    length = b"Content-Length: %d" % len(whole)
    return re.sub(rb"(?i)content-length: *\d+", length, head), whole
