"""The command line: every module of this folder with a ``command`` is one sub-command."""

import ast
import importlib
import os
import pkgutil
from pathlib import Path

import click

from app.domain.errors import ProgPromptError
from app.settings import SettingRefused

# All arrays here are small: a second thread of numpy's linear algebra would only spin, which costs a
# pick half as much CPU again. It counts only if it is set before numpy is loaded.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


class Commands(click.Group):
    """Sub-commands by the names of their modules, read for the list and imported when called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names, in order."""
        del ctx  # Unused.
        return [module.name for module in pkgutil.iter_modules(__path__) if _about(module.name)]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of this name, if there is one."""
        if cmd_name not in self.list_commands(ctx):
            return None
        return importlib.import_module(f"{__name__}.{cmd_name}").command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The list, without importing what they need, which takes seconds."""
        rows = [(name, _about(name)) for name in self.list_commands(ctx)]
        with formatter.section("Commands"):
            formatter.write_dl(rows)

    def invoke(self, ctx: click.Context) -> object:
        """Run one; what is the user's to mend is told without a traceback."""
        try:
            return super().invoke(ctx)
        except (ProgPromptError, SettingRefused) as error:
            raise click.ClickException(str(error)) from error


def _about(module: str) -> str:
    """The first paragraph of what a module's command says it does; empty where it has none."""
    text = Path(__file__).with_name(f"{module}.py").read_text(encoding="utf-8")
    functions = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef))
    found = next((each for each in functions if each.name == "command"), None)
    told = ast.get_docstring(found) if found else None
    return " ".join(told.partition("\n\n")[0].split()) if told else ""


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="progprompt")
def main() -> None:
    """ProgPrompt: a sentence becomes a robot program, is carried out in physics, and scored."""
