#!/bin/sh
# man.sh LIMBER: prints the manual page. It takes commands and options from the
# program's --help, so the two always agree.
set -eu
limber=$1
version=$("$limber" --version | sed -n '1s/^limber \([^ ]*\).*/\1/p')
commands=$("$limber" --help | sed -n 's/^  limber \([a-z]*\) .*/\1/p')

# Characters that troff would interpret.
quote='s/\\/\\e/g; s/-/\\-/g; s/^\./\\\&./; s/^'\''/\\\&'\''/'

cat <<END
.TH LIMBER 1 "" "limber $version" "User Commands"
.SH NAME
limber \\- 3D character animation for ARM11 boards and desktops
.SH SYNOPSIS
.nf
END
"$limber" --help | sed -n 's/^  \(limber [a-z]* .*[^ ]\)   *[a-z].*/\1/p' |
    sed "$quote"
cat <<'END'
.fi
.SH DESCRIPTION
limber plays glTF and DirectX .x models with morphing, hierarchical and skeletal
animation. It also plays built-in demos, which you control with buttons: the keys
of a desktop, or the GPIO lines or the keypad of a board. Without a command,
limber plays.
END

# The help of a command begins with a line of usage. Paragraphs and indented
# examples follow, then "Options:".
for command in $commands; do
    "$limber" "$command" --help | sed "$quote" | awk '
        function literal(on) {
            if (on != open) {
                print on ? ".nf" : ".fi"
                open = on
            }
        }
        NR == 1 { print ".SS " $0; next }
        /^Options:$/ { literal(0); print ".PP\nOptions:"; options = 1; next }
        options && match($0, /\\-\\-[a-z\\-]+( [A-Z][A-Za-z.:]*)?/) {
            name = substr($0, 1, RSTART + RLENGTH - 1)
            gsub(/^ +/, "", name)
            text = substr($0, RSTART + RLENGTH)
            gsub(/^ +/, "", text)
            print ".TP\n.B " name "\n" text
            next
        }
        /^$/ { literal(0); print ".PP"; next }
        /^  / { literal(1) }
        !/^  / { literal(0) }
        { print }
        END { literal(0) }'
done

here=$(dirname "$0")
awk -f "$here/man_page.awk" "$here/../../app/character/format.md"

cat <<'END'
.SH "EXIT STATUS"
The exit status is 0 for success, 1 when a file, a device or memory failed, and 2
when the command line is wrong. limber writes each error to standard error, as
one sentence that says what is wrong and what to do.
When something does not play, run
.BR "limber doctor" :
it says why, and which command repairs it.
.SH FILES
.TP
.I ~/.config/limber/limber.conf
.TQ
.I /etc/limber.conf
limber reads the first of these files that exists. It contains options of
.BR "limber play" ,
by their names without dashes. Options on the command line override it.
.PP
.nf
  [start]
  demo = walker
  [display]
  display = fbdev
  [buttons]
  UP = gpio 53fd0000.gpio 18
  [actions]
  F9 = UP
  [options]
  frames = 100
.fi
.SH ENVIRONMENT
.TP
.B LIMBER_ASSETS
The folder in which limber looks for the demos' models first.
.TP
.B LIMBER_CONFIG
The file that limber reads instead of limber.conf; "none" reads no file.
.TP
.BR LIMBER_EGL ", " LIMBER_GLES
The libraries of the GPU's vendor, like --egl-library and --gles-library.
.TP
.BR DISPLAY ", " WAYLAND_DISPLAY
The desktop on which limber opens its window. Without a desktop, limber shows
pictures on the whole screen.
END
