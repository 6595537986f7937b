"""QR codes, which the camera of a phone reads."""

from __future__ import annotations

import base64
import io

_QUIET_ZONE = 4  # white border of a QR code, in squares of the code (ISO/IEC 18004)


def qr_code(text: str) -> str:
    """Return the address of a picture with a QR code."""
    import segno  # noqa: PLC0415 - few pages need it

    svg = io.BytesIO()
    segno.make_qr(text).save(svg, kind="svg", border=_QUIET_ZONE, light="white", scale=8)
    return f"data:image/svg+xml;base64,{base64.b64encode(svg.getvalue()).decode()}"
