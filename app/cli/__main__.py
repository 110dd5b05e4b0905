"""``python -m app.cli``, the same as ``progprompt``."""

from app.cli import main

main(prog_name="progprompt")
