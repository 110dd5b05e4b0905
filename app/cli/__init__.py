"""The command line: every module of this folder with a ``command`` is one sub-command."""

import importlib
import os
import pkgutil

import click

# All arrays here are small: a second thread of numpy's linear algebra would only spin, which costs a
# pick half as much CPU again. It counts only if it is set before numpy is loaded.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


class Commands(click.Group):
    """Sub-commands by the names of their modules, imported when they are asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names, in order."""
        names = [module.name for module in pkgutil.iter_modules(__path__)]
        return [name for name in names if self.get_command(ctx, name) is not None]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of this name, if there is one."""
        del ctx  # Unused.
        if cmd_name not in {module.name for module in pkgutil.iter_modules(__path__)}:
            return None
        module = importlib.import_module(f"{__name__}.{cmd_name}")
        return getattr(module, "command", None)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="progprompt")
def main() -> None:
    """ProgPrompt: a sentence becomes a robot program, is carried out in physics, and scored."""
