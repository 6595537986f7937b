"""`zbot completion SHELL`: prints the script with which a shell completes words of `zbot`."""

from __future__ import annotations

from typing import Annotated

import typer

from zbot_cli.output.listing import new_app

app = new_app("Complete words in your shell with Tab", has_verbs=False)

_BASH = """\
_zbot_complete() {
    local IFS=$'\\n'
    COMPREPLY=($(zbot complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
    [[ ${COMPREPLY[0]} == */ ]] && compopt -o nospace
}
complete -o default -F _zbot_complete zbot
"""
_ZSH = """\
#compdef zbot
_zbot() {
    local -a candidates
    candidates=("${(@f)$(zbot complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
    [[ -n $candidates[1] ]] && compadd -a candidates || _files
}
compdef _zbot zbot
"""
_FISH = """\
function __zbot_complete
    set -l words (commandline -opc)
    set -l unfinished (commandline -ct)
    zbot complete -- $words[2..-1] "$unfinished" 2>/dev/null
end
complete -c zbot -f -a '(__zbot_complete)'
"""
_POWERSHELL = """\
Register-ArgumentCompleter -Native -CommandName zbot -ScriptBlock {
    param($wordToComplete, $commandAst, $cursorPosition)
    $words = @($commandAst.CommandElements | Select-Object -Skip 1 | ForEach-Object { "$_" })
    if ($wordToComplete -eq '') { $words += '""' }
    zbot complete -- @words 2>$null | ForEach-Object {
        [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_)
    }
}
"""
_SCRIPTS = {"bash": _BASH, "zsh": _ZSH, "fish": _FISH, "powershell": _POWERSHELL}
_INSTALL = {
    "bash": 'eval "$(zbot completion bash)"          # add this line to ~/.bashrc',
    "zsh": 'eval "$(zbot completion zsh)"           # add this line to ~/.zshrc, after compinit',
    "fish": "zbot completion fish | source            # add it to ~/.config/fish/config.fish",
    "powershell": "zbot completion powershell | Out-String | iex    # add it to $PROFILE",
}


@app.command()
def completion(
    shell: Annotated[str | None, typer.Argument(help="bash, zsh, fish or powershell")] = None,
) -> None:
    """Print the completion script of a shell; without SHELL, print how to install it."""
    if shell is None:
        print("To complete words of zbot with Tab, install the script of your shell:\n")
        for line in _INSTALL.values():
            print(f"    {line}")
        return
    if shell not in _SCRIPTS:
        raise typer.BadParameter(f"no script for {shell!r}; choose from {', '.join(_SCRIPTS)}")
    print(_SCRIPTS[shell], end="")
