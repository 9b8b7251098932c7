# Completion of bash for timeshade: commands, the options that a command's --help lists, else names of files.
_timeshade() {
    local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W "view shot record pictures verify measure epipolar cases list --help --version" \
            -- "$word"; compgen -f -- "$word")
    elif [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(timeshade "$command" --help 2>/dev/null |
            grep -oE '^ +(-[a-z],)?--[a-z0-9-]+(,--[a-z0-9-]+)*' | tr ',' '\n')" -- "$word")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _timeshade timeshade
