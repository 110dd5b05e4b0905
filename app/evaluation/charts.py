"""Charts: bars with intervals and lines, as inline SVG that follows the page's colours.

Drawn 360 units wide, so that the text is as large as the page's on a telephone.
"""

from collections.abc import Sequence
from html import escape

from app.evaluation.metrics import Figure

WIDTH = 360
_ROW = 40
_RIGHT = 44


def bars(title: str, rows: Sequence[tuple[str, Figure | None]]) -> str:
    """One bar for each row, its interval as a whisker; the label stands above its bar."""
    rows = [(label, figure) for label, figure in rows if figure is not None]
    height = _ROW * len(rows) + 8
    parts = [_open(title, height)]
    for index, (label, figure) in enumerate(rows):
        assert figure is not None
        parts.append(_bar(label, figure, index * _ROW + 4))
    return "".join([*parts, "</svg>"])


def lines(title: str, series: Sequence[tuple[str, Sequence[tuple[float, Figure]]]]) -> str:
    """Each series as a line through its means, with whiskers; x from 1 on, y from 0 to 1."""
    xs = [x for _, points in series for x, _ in points]
    if not xs:
        return ""
    left, right = min(xs), max(max(xs), min(xs) + 1)
    height = 210
    parts = [_open(title, height + 18 * len(series))]
    for level in (0.0, 0.25, 0.5, 0.75, 1.0):
        y = _y(level)
        parts.append(f'<line class="grid" x1="34" x2="350" y1="{y}" y2="{y}"/>')
        parts.append(f'<text class="tick" x="28" y="{y + 4}" text-anchor="end">{level:g}</text>')
    for x in sorted(set(xs)):
        place = _x(x, left, right)
        parts.append(f'<text class="tick" x="{place}" y="200" text-anchor="middle">{x:g}</text>')
    for number, (label, points) in enumerate(series):
        parts.append(_line(number, [(_x(x, left, right), figure) for x, figure in points]))
        y = height + 18 * number + 6
        parts.append(f'<circle class="s{number % 6} dot" cx="40" cy="{y - 4}" r="4"/>')
        parts.append(f'<text x="52" y="{y}">{escape(label)}</text>')
    return "".join([*parts, "</svg>"])


def _open(title: str, height: int) -> str:
    return (
        f'<svg class="chart" viewBox="0 0 {WIDTH} {height}" role="img" '
        f'aria-label="{escape(title)}"><title>{escape(title)}</title>'
    )


def _bar(label: str, figure: Figure, top: int) -> str:
    scale = WIDTH - _RIGHT
    end, low, high = (round(value * scale, 1) for value in (figure.mean, figure.low, figure.high))
    middle = top + 25
    told = f"{label}: {figure}, 95 % interval {figure.low:.2f} to {figure.high:.2f}"
    return (
        f"<g><title>{escape(told)}</title>"
        f'<text x="0" y="{top + 11}">{escape(label)}</text>'
        f'<rect class="rail" x="0" y="{top + 17}" width="{scale}" height="16" rx="3"/>'
        f'<rect class="bar" x="0" y="{top + 17}" width="{end}" height="16" rx="3"/>'
        f'<path class="whisker" d="M{low} {middle}H{high}M{low} {middle - 4}v8M{high} '
        f'{middle - 4}v8"/>'
        f'<text class="value" x="{WIDTH}" y="{top + 30}" text-anchor="end">{figure.mean:.2f}</text>'
        "</g>"
    )


def _line(number: int, points: Sequence[tuple[float, Figure]]) -> str:
    path = " ".join(
        f"{'M' if index == 0 else 'L'}{x} {_y(figure.mean)}"
        for index, (x, figure) in enumerate(points)
    )
    style = f"s{number % 6}"
    marks = [
        f'<g><title>{figure}</title><path class="{style} line" d="M{x} {_y(figure.low)}V'
        f'{_y(figure.high)}"/><circle class="{style} dot" cx="{x}" cy="{_y(figure.mean)}" r="4"/></g>'
        for x, figure in points
    ]
    return f'<path class="{style} line" d="{path}"/>' + "".join(marks)


def _x(value: float, left: float, right: float) -> float:
    return round(44 + (value - left) / (right - left) * 296, 1)


def _y(share: float) -> float:
    return round(180 - share * 168, 1)
