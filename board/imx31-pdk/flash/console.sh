# The serial console: sends lines and waits for the board's answers.
# shellcheck shell=bash disable=SC2034,SC2154 # flash.sh's variables
#
# A command is sent without its end of line first. The end follows only when the
# board has echoed the command correctly, so a lost character cannot turn it into
# another command.

received=  # the board's output since the last command
reason= # of the last failure
autoboot_pattern='stop autoboot|\^C to abort'
prompt_pattern='(RedBoot>|U-Boot ?>|[uU][bB]oot ?>|=>) ?$'
linux_pattern='(login:|[#$]) ?$'

console_list() {
    find /dev -maxdepth 1 -name 'tty[UA][SC][BM]*' | sort | tr '\n' ' '
}

console_open() {
    [ -c "$1" ] ||
        fail "$1: no such serial line: choose one with --port ($(console_list))"
    if ! [[ -r $1 && -w $1 ]]; then
        fail "$1: no permission: join its group (usermod -aG $(stat -c %G "$1") USER) and log in again"
    fi
    stty -F "$1" 115200 raw -echo cs8 -cstopb -parenb -crtscts clocal ||
        fail "$1: not a serial line"
    exec {console}<>"$1" || fail "$1: cannot be opened"
}

# Adds what arrives within 0.05 s to $received, without CR; false if nothing does.
console_hear() {
    local part='' status=0
    IFS= read -r -u "$console" -t 0.05 -N 512 part 2>/dev/null || status=$?
    # A time-out has a status above 128.
    if [ $status -gt 0 ] && [ $status -le 128 ]; then
        fail "$port: the serial line has gone: plug its adapter in and start the same command again, which skips the finished steps"
    fi
    part=${part//$'\r'/}
    received+=$part
    [ -n "$part" ]
}

# console_wait SECONDS PATTERN: waits until $received matches. The time starts again
# whenever something arrives, so that a slow transfer does not time out.
console_wait() {
    local until=$((SECONDS + $1 + 1))
    while [ $SECONDS -le $until ]; do
        if console_hear; then
            until=$((SECONDS + $1 + 1))
        fi
        if [[ $received =~ $2 ]]; then
            return 0
        fi
    done
    return 1
}

console_put() {
    printf %s "$1" >&"$console"
}

# Interrupts the current command and drops its output.
console_settle() {
    $dry_run && return 0
    received=
    console_put $'\x03'
    console_wait 1 "$prompt_pattern" || true
    while console_hear; do :; done
    received=
}

# console_echo TEXT PAUSE: sends the text and waits for its echo.
console_echo() {
    local i
    received=
    for ((i = 0; i < ${#1}; i++)); do
        console_put "${1:i:1}"
        [ "$2" = 0 ] || sleep "$2"
    done
    for ((i = 0; i < 20; i++)); do
        console_hear || true
        if [ "$received" = "$1" ]; then
            return 0
        fi
    done
    return 1
}

# console_type TEXT: sends one line, more slowly each time it is not echoed.
console_type() {
    local pause
    for pause in 0 0.005 0.02 0.05; do
        if console_echo "$1" $pause; then
            received=
            console_put $'\r'
            return 0
        fi
        console_settle
    done
    reason="the console does not echo what is sent (\"$1\"): check the cable and 115200 baud"
    return 1
}

# console_run TEXT [SECONDS]: runs a command; its output is in $received.
console_run() {
    echo "  > $1"
    $dry_run && return 0
    console_type "$1" || return 1
    if ! console_wait "${2:-$seconds}" "$prompt_pattern|$autoboot_pattern"; then
        reason="no answer to \"$1\" within ${2:-$seconds} s"
        return 1
    fi
    if [[ $received =~ $autoboot_pattern ]]; then
        reason="the board was reset during \"$1\""
        return 1
    fi
}

# Recognizes the boot loader. Asks for a reset when nothing answers.
console_find_loader() {
    received=
    console_put $'\r'
    if ! console_wait 1 "$prompt_pattern|$linux_pattern"; then
        echo "Nothing answers on $port: press the board's reset button."
        console_stop_autoboot
    fi
    case $received in
    *RedBoot\>*) loader=redboot ;;
    *)
        [[ $received =~ $prompt_pattern ]] || fail_wrong_prompt
        loader=uboot
        ;;
    esac
    echo "The boot loader is $loader."
}

# Both boot loaders announce that they will boot; Ctrl-C stops that.
console_stop_autoboot() {
    console_wait "$seconds" "$autoboot_pattern" ||
        fail "$port: the board sends nothing: check its power and the cable, and that no other program uses the line"
    received=
    console_put $'\x03'
    console_wait 3 "$prompt_pattern" || fail_wrong_prompt
}

fail_wrong_prompt() {
    if [[ $received =~ $linux_pattern ]]; then
        fail "$port: the board runs Linux: reset it and start flash.sh at once"
    fi
    fail "$port: this is neither the prompt of RedBoot nor of U-Boot: \"${received##*$'\n'}\""
}

console_want_prompt() {
    received=
    console_put $'\r'
    console_wait 2 "$prompt_pattern|$linux_pattern" || console_find_loader
    [[ $received =~ $prompt_pattern ]] || fail_wrong_prompt
    case $loader$received in
    redboot*RedBoot\>*) ;;
    redboot* | uboot*RedBoot\>*)
        fail "$port: the prompt is not that of $loader: leave --loader out" ;;
    esac
}
