"""A viser server on a loopback port of its own that leaves the terminal to the service."""

import warnings

import rich
import viser

LOOPBACK = "127.0.0.1"


def open_server() -> viser.ViserServer:
    """A running server on a port the system chooses.

    viser announces every server and its end on rich's global console even when told not to be
    verbose; nothing else of this process writes there.
    """
    rich.get_console().quiet = True
    # A browser may leave while its next picture is being made.
    warnings.filterwarnings("ignore", message="Queued a .* on a closed connection")
    return viser.ViserServer(host=LOOPBACK, port=0, verbose=False)
