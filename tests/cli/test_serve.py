import asyncio
import socket
from concurrent.futures import ThreadPoolExecutor

from app.cli.serve import _listening
from app.settings import Settings


def test_answers_leave_at_once_and_not_when_nagle_lets_them():
    async def accepted(listener):
        told = asyncio.get_running_loop().create_future()

        def serve(_reader, writer):
            peer = writer.get_extra_info("socket")
            told.set_result(peer.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY))
            writer.close()

        async with await asyncio.start_server(serve, sock=listener):
            _, writer = await asyncio.open_connection(*listener.getsockname())
            found = await told
            writer.close()
            return found

    with (
        _listening(Settings(port=0)) as (listener, _url),
        ThreadPoolExecutor(1) as aside,
    ):  # A loop of another test may be running in this thread.
        assert aside.submit(asyncio.run, accepted(listener)).result()
