"""StandingPage: HTML that stays the same while the service runs."""

import gzip
import hashlib

from fastapi import Request, Response


class StandingPage:
    """Compressed once, and sent only to browsers that have not kept it."""

    def __init__(self, html: str) -> None:
        self._plain = html.encode()
        self._packed = gzip.compress(self._plain, mtime=0)
        digest = hashlib.sha256(self._plain).hexdigest()[:20]
        self._headers = {
            "ETag": f'W/"{digest}"',  # Weak: the same page, packed or not.
            "Cache-Control": "no-cache",  # Kept, but asked for anew: a release may change it.
            "Vary": "Accept-Encoding",
        }

    def answer(self, request: Request) -> Response:
        """What this browser needs of it."""
        if self._headers["ETag"] in request.headers.get("if-none-match", ""):
            return Response(status_code=304, headers=self._headers)
        if "gzip" in request.headers.get("accept-encoding", ""):
            headers = {**self._headers, "Content-Encoding": "gzip"}
            return Response(self._packed, headers=headers, media_type="text/html")
        return Response(self._plain, headers=self._headers, media_type="text/html")
