#!/bin/sh
# man.sh LIMBER: the manual page, made of what the program says of itself, so
# that the two never differ.
set -eu
limber=$1
version=$("$limber" --version | sed -n '1s/^limber \([^ ]*\).*/\1/p')
commands=$("$limber" --help | sed -n 's/^  limber \([a-z]*\) .*/\1/p')

# What troff would take for its own.
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
Plays glTF and DirectX .x models with morphing, hierarchical and skeletal
animation, and demos that are steered by buttons: a desktop's keys, a board's
GPIO lines or its keypad. Without a command it plays.
END

# The first line of a command's help is its usage, then come paragraphs with
# indented examples, then "Options:".
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

cat <<'END'
.SH "EXIT STATUS"
0 when all went well, 1 when a file, a device or memory failed, 2 when the
command line is wrong. Messages go to standard error, a sentence each.
When something does not play,
.B limber doctor
says why and which command mends it.
.SH FILES
.TP
.I ~/.config/limber/limber.conf
.TQ
.I /etc/limber.conf
Options of
.BR "limber play" ,
by their names without dashes; the first of these files that is there. The
command line wins over them.
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
The folder of the demos' models, before the one that was installed.
.TP
.B LIMBER_CONFIG
A file in place of limber.conf, or none.
.TP
.BR LIMBER_EGL ", " LIMBER_GLES
The vendor's libraries, as --egl-library and --gles-library.
.TP
.BR DISPLAY ", " WAYLAND_DISPLAY
Where the desktop is. Without one pictures go to the screen itself.
END
