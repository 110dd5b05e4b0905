"""Writing: what is shown, as the text of an answer."""

from fastapi import Response

from app.api.schemas.base import Shown


def written(shown: Shown, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Written once: a response model would be checked and written a second time."""
    return Response(shown.model_dump_json(), status, headers, media_type="application/json")
