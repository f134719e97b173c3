# The serial console: sends lines and waits for what the board says.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables
#
# A command is sent without its end of line first; only when the board has
# echoed it as it was sent does the end follow. So a character that the line
# lost never makes another command of it.

heard=  # all that came since the last command
reason= # of the last failure, for a sentence
prompt_pattern='(RedBoot>|U-Boot ?>|[uU][bB]oot ?>|=>) ?$'
linux_pattern='(login:|[#$]) ?$'

console_list() {
    find /dev -maxdepth 1 -name 'tty[UA][SC][BM]*' | sort | tr '\n' ' '
}

console_open() {
    [ -c "$1" ] ||
        fail "$1: no such serial line: give --port (there is: $(console_list))"
    if ! [[ -r $1 && -w $1 ]]; then
        fail "$1: no permission: join its group (usermod -aG $(stat -c %G "$1") USER) and log in again"
    fi
    stty -F "$1" 115200 raw -echo cs8 -cstopb -parenb -crtscts clocal ||
        fail "$1: not a serial line"
    exec {console}<>"$1" || fail "$1: cannot be opened"
}

# What came within a twentieth of a second, without CR, is added to $heard.
console_hear() {
    local part=
    IFS= read -r -u "$console" -t 0.05 -N 512 part || true
    part=${part//$'\r'/}
    heard+=$part
    [ -n "$part" ]
}

# console_wait SECONDS PATTERN: until $heard's end has it; resets the time
# whenever something comes, so that progress is never cut short.
console_wait() {
    local until=$((SECONDS + $1 + 1))
    while [ $SECONDS -le $until ]; do
        if console_hear; then
            until=$((SECONDS + $1 + 1))
        fi
        if [[ $heard =~ $2 ]]; then
            return 0
        fi
    done
    return 1
}

console_put() {
    printf %s "$1" >&"$console"
}

# Drops what is under way, up to silence.
console_settle() {
    $dry_run && return 0
    heard=
    console_put $'\x03'
    console_wait 1 "$prompt_pattern" || true
    while console_hear; do :; done
    heard=
}

# console_echo TEXT PAUSE: sends it and waits for its echo.
console_echo() {
    local i
    heard=
    for ((i = 0; i < ${#1}; i++)); do
        console_put "${1:i:1}"
        [ "$2" = 0 ] || sleep "$2"
    done
    for ((i = 0; i < 20; i++)); do
        console_hear || true
        if [ "$heard" = "$1" ]; then
            return 0
        fi
    done
    return 1
}

# console_type TEXT: one line, unchanged, then its end.
console_type() {
    local pause
    for pause in 0 0.005 0.02 0.05; do
        if console_echo "$1" $pause; then
            heard=
            console_put $'\r'
            return 0
        fi
        console_settle
    done
    reason="the console does not echo what is sent (\"$1\"): check the cable and 115200 baud"
    return 1
}

# tell TEXT [SECONDS]: runs it; what it said is in $heard.
tell() {
    echo "  > $1"
    $dry_run && return 0
    console_type "$1" || return 1
    if ! console_wait "${2:-$seconds}" "$prompt_pattern"; then
        reason="no answer to \"$1\" within ${2:-$seconds} s"
        return 1
    fi
}

# Which boot loader is there; waits for a reset when nothing answers.
console_find_loader() {
    heard=
    console_put $'\r'
    if ! console_wait 1 "$prompt_pattern|$linux_pattern"; then
        echo "Nothing answers on $port: press the board's reset button."
        console_stop_autoboot
    fi
    case $heard in
    *RedBoot\>*) loader=redboot ;;
    *)
        [[ $heard =~ $prompt_pattern ]] || say_wrong_prompt
        loader=uboot
        ;;
    esac
    echo "The boot loader is $loader."
}

# Both loaders announce their autoboot; any key or ^C ends it.
console_stop_autoboot() {
    console_wait "$seconds" 'stop autoboot|\^C to abort' ||
        fail "$port: nothing comes from the board: check its power, the cable and that no other program has the line"
    heard=
    console_put $'\x03'
    console_wait 3 "$prompt_pattern" || say_wrong_prompt
}

say_wrong_prompt() {
    if [[ $heard =~ $linux_pattern ]]; then
        fail "$port: the board runs Linux: reset it and start flash.sh at once"
    fi
    fail "$port: this is neither RedBoot's nor U-Boot's prompt: \"${heard##*$'\n'}\""
}

console_want_prompt() {
    heard=
    console_put $'\r'
    console_wait 2 "$prompt_pattern|$linux_pattern" || console_find_loader
    [[ $heard =~ $prompt_pattern ]] || say_wrong_prompt
    case $loader$heard in
    redboot*RedBoot\>*) ;;
    redboot* | uboot*RedBoot\>*)
        fail "$port: the prompt is not $loader's: leave --loader out" ;;
    esac
}
