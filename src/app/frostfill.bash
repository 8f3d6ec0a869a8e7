# SPDX-License-Identifier: MIT
# Completion of frostfill for bash: commands, options, their words and the keys of --set, as the help
# of the program has them. Files are completed where nothing else is known.
_frostfill()
{
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} program=${COMP_WORDS[0]}
    local command=${COMP_WORDS[1]} words
    if ((COMP_CWORD == 1)); then
        words=$("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')\ --help\ --version
    elif [[ $before == --set ]]; then
        words=$("$program" "$command" --help-all | sed -n '/^Keys /,$s/^  \([a-z_.]*\) .*/\1=/p')
        compopt -o nospace
    elif [[ $before == --* ]]; then
        words=$("$program" "$command" --help | sed -n "s/^  $before \([^ ]*|[^ ]*\) .*/\1/p" | tr '|' '\n' |
            grep -x '[a-z0-9-]*')
    fi
    [[ -z $words ]] && words=$("$program" "$command" --help | grep -o '^  --[a-z-]*')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o bashdefault -o default -F _frostfill frostfill
