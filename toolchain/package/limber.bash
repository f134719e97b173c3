# Completes limber's command line in bash. It reads the program's --help, so the
# two always agree.
# shellcheck shell=bash

_limber_commands() {
    "$1" --help 2>/dev/null | sed -n 's/^  limber \([a-z]*\) .*/\1/p'
}

# _limber_options PROGRAM COMMAND
_limber_options() {
    "$1" "$2" --help 2>/dev/null | sed -n 's/^  [- ][a-zA-Z ][, ] *\(--[a-z-]*\).*/\1/p'
}

# Prints the name of an option's value in the help: "FILE", "N", or nothing.
_limber_operand() {
    "$1" "$2" --help 2>/dev/null |
        sed -n "s/^  [- ][a-zA-Z ][, ].*$3 \([A-Z][^ ]*\) .*/\1/p; s/^  $3, --[a-z]* \([A-Z][^ ]*\) .*/\1/p"
}

# Prints the values that the help of an option lists between a colon and a
# semicolon: "auto, gles1, soft or osmesa".
_limber_values() {
    "$1" "$2" --help 2>/dev/null | sed -n "s/^ .*$3 [A-Z]* .*: //p" |
        sed 's/;.*//; s/ or /, /; s/,/ /g; s/([^)]*)//g'
}

_limber() {
    local word=$2 previous=$3 program=${COMP_WORDS[0]} command=play
    local commands
    COMPREPLY=()
    commands=$(_limber_commands "$program")
    if [[ " ${commands//$'\n'/ } " == *" ${COMP_WORDS[1]} "* ]]; then
        command=${COMP_WORDS[1]}
    fi
    case $previous in
    --demo | --display | --gl | --math | --kernel | --interpolation | --camera-use | \
        --format | --repeat)
        mapfile -t COMPREPLY < <(compgen -W \
            "$(_limber_values "$program" "$command" "$previous")" -- "$word")
        return
        ;;
    -*)
        case $(_limber_operand "$program" "$command" "$previous") in
        FILE* | DIR)
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
            return
            ;;
        ?*) return ;;
        esac
        ;;
    esac
    case $word in
    -*)
        mapfile -t COMPREPLY < <(compgen -W \
            "$(_limber_options "$program" "$command")" -- "$word")
        ;;
    *)
        mapfile -t COMPREPLY < <(compgen -f -X '!*.@(glb|gltf|x)' -- "$word"
            compgen -d -- "$word")
        if [ "$COMP_CWORD" -eq 1 ]; then
            mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
                compgen -W "$commands" -- "$word")
        fi
        ;;
    esac
}

shopt -s extglob
complete -o filenames -F _limber limber
