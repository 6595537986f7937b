"""Style of the drawn graph, with colours for light and dark screens and widths of texts.

The CSS rules contain plain colours. CSS variables do not work in many programs that show SVG.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

FONT_SIZE = 15
LABEL_SIZE = 13
_FAMILY = '"Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif'

# Widths in Helvetica and Arial, in thousandths of the font size (Adobe's font metrics).
_WIDTHS = {
    **dict.fromkeys("ijl", 222),
    **dict.fromkeys(" ft/.,:I", 278),
    **dict.fromkeys("r-()", 333),
    **dict.fromkeys("ckvxyzsJ", 500),
    **dict.fromkeys("FTZ", 611),
    **dict.fromkeys("ABEKPSVXY", 667),
    **dict.fromkeys("wCDHNRU", 722),
    **dict.fromkeys("GOQ", 778),
    **dict.fromkeys("mM", 833),
    "W": 944,
}
_OTHER_WIDTH = 556
_WIDE = 700  # for characters that are not ASCII


@dataclass(frozen=True)
class Palette:
    """Colours of the drawing. The order in a tuple is filling, border and, if given, text."""

    ground: str
    text: str
    node: tuple[str, str]
    topic: tuple[str, str]
    group: tuple[str, str]
    wrong: tuple[str, str, str]
    frame: tuple[str, str, str]
    line: str
    label: str
    chosen: str
    incoming: str
    outgoing: str
    both: str


LIGHT = Palette(
    ground="#ffffff",
    text="#1b1f24",
    node=("#e3eefd", "#2f6fd0"),
    topic=("#fff7e0", "#b98a1c"),
    group=("#efe7fb", "#7a55c0"),
    wrong=("#fde7e5", "#c5221f", "#a01714"),
    frame=("#f4f6f8", "#aab4c0", "#5b6672"),
    line="#5f6b78",
    label="#3d4752",
    chosen="#d9480f",
    incoming="#1763d1",
    outgoing="#0d8a3c",
    both="#00838f",
)
DARK = Palette(
    ground="#14181d",
    text="#eef2f6",
    node=("#1c3050", "#79aef5"),
    topic=("#3a3018", "#e0b64a"),
    group=("#322650", "#b795f0"),
    wrong=("#47201f", "#ff8a80", "#ffb4ad"),
    frame=("#1b2027", "#55616e", "#a7b2be"),
    line="#9aa7b5",
    label="#c6d0da",
    chosen="#ff9d5c",
    incoming="#7db4ff",
    outgoing="#6fdc8c",
    both="#5fd7e0",
)


def text_width(text: str, size: float) -> float:
    """Return the estimated width of a text in pixels. The estimate may be a little too large."""
    units = sum(
        _WIDTHS.get(character, _OTHER_WIDTH if character < "\x7f" else _WIDE) for character in text
    )
    return units * size / 1000 * 1.04


@lru_cache(maxsize=1)
def style() -> str:
    """Return the CSS. The classes `light` and `dark` override the colour scheme of the browser."""
    dark = _colours(".zbot-graph:not(.light)", DARK)
    return "\n".join(
        [
            _shapes(),
            _colours(".zbot-graph", LIGHT),
            f"@media (prefers-color-scheme: dark) {{\n{dark}\n}}",
            _colours(".zbot-graph.dark", DARK),
        ]
    )


def _shapes() -> str:
    return f"""
.zbot-graph text {{ font-family: {_FAMILY}; font-size: {FONT_SIZE}px; text-anchor: middle; }}
.zbot-graph .edge text {{ font-size: {LABEL_SIZE}px; paint-order: stroke; stroke-width: 4px;
  stroke-linejoin: round; }}
.zbot-graph .frame text {{ font-size: {LABEL_SIZE}px; text-anchor: start; }}
.zbot-graph .line {{ fill: none; stroke-width: 1.6; }}
.zbot-graph .node ellipse, .zbot-graph .topic rect {{ stroke-width: 1.8; }}
.zbot-graph .topic rect.inner {{ stroke-width: 0.8; }}
.zbot-graph .frame path {{ stroke-width: 1.2; stroke-dasharray: 5 4; }}
.zbot-graph .wrong rect, .zbot-graph .wrong .line {{ stroke-dasharray: 6 4; stroke-width: 2.2; }}
""".strip()


def _colours(at: str, palette: Palette) -> str:
    rules = [
        (".ground", f"fill: {palette.ground}"),
        ("text", f"fill: {palette.text}"),
        (".node ellipse", _filled(palette.node)),
        (".topic rect", _filled(palette.topic)),
        *((f".{kind} rect", _filled(palette.group)) for kind in ("action", "tf", "images")),
        (".frame path", _filled(palette.frame)),
        (".frame text", f"fill: {palette.frame[2]}"),
        (".line", f"stroke: {palette.line}"),
        (".head", f"fill: {palette.line}"),
        (".edge text", f"fill: {palette.label}; stroke: {palette.ground}"),
        (".topic.wrong rect", _filled(palette.wrong)),
        (".wrong text", f"fill: {palette.wrong[2]}"),
        *_edge_rules(".wrong", palette.wrong[1]),
        *_lit("chosen", palette.chosen),
        *_lit("incoming", palette.incoming),
        *_lit("outgoing", palette.outgoing),
        *_lit("both", palette.both),
    ]
    return "\n".join(f"{at} {where} {{ {what}; }}" for where, what in rules)


def _filled(colours: tuple[str, ...]) -> str:
    return f"fill: {colours[0]}; stroke: {colours[1]}"


def _edge_rules(where: str, colour: str) -> list[tuple[str, str]]:
    return [(f"{where} .line", f"stroke: {colour}"), (f"{where} .head", f"fill: {colour}")]


def _lit(name: str, colour: str) -> list[tuple[str, str]]:
    """Return the CSS rules for nodes, topics and edges that a web page highlights."""
    shapes = [
        (f".{name} {shape}", f"stroke: {colour}; stroke-width: 3") for shape in ("ellipse", "rect")
    ]
    return [*shapes, *_edge_rules(f".{name}", colour)]
