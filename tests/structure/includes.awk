# Reads lines "FILE HEADER", with system headers in <>, and prints TAP: a test for
# each rule about what may include what.

BEGIN {
    # Each layer may include itself and those before it.
    layers = split("model embed anim scene compare character demo cmd", layer)
    for (i = 1; i <= layers; i++) {
        rank_of[layer[i]] = i
    }
    listed("<assert.h> <ctype.h> <errno.h> <fenv.h> <float.h> <inttypes.h> " \
        "<limits.h> <locale.h> <math.h> <setjmp.h> <stdalign.h> <stdarg.h> " \
        "<stdatomic.h> <stdbool.h> <stddef.h> <stdint.h> <stdlib.h> " \
        "<stdnoreturn.h> <string.h> <wchar.h>", plain)
    listed("<dirent.h> <fcntl.h> <libgen.h> <signal.h> <stdio.h> " \
        "<strings.h> <sys/stat.h> <sys/types.h> <time.h> <unistd.h>", outside)
    listed("<jansson.h> <png.h> <jpeglib.h> <jerror.h> <zlib.h>", library_model)
    listed("<jansson.h> <png.h>", library_compare)
    listed("<ini.h>", library_character)
    listed("<jansson.h> <ini.h>", library_cmd)

    rule("named", "include paths begin at the top folder")
    rule("placed", "every folder of app is a layer")
    rule("upward", "includes run from cmd down to model")
    rule("app", "platform includes nothing of app")
    rule("private", "app includes only public headers of platform")
    rule("seam", "of platform, model and anim include base alone")
    rule("outside", "anim does no input and no output")
    rule("foreign", "app includes only C, POSIX, cglm and file libraries")
}

function listed(text, set,    word, n, i) {
    n = split(text, word)
    for (i = 1; i <= n; i++) {
        set[word[i]] = 1
    }
}

function rule(key, name) {
    rules++
    key_of[rules] = key
    name_of[rules] = name
}

function broken(key) {
    found[key] = found[key] "# " file " includes " header "\n"
}

# The layer of a path: 0 outside app, -1 in a folder of app that is no layer.
function rank(path,    part) {
    split(path, part, "/")
    if (part[1] != "app") {
        return 0
    }
    if (path == "app/main.c") {
        return layers + 1
    }
    return part[2] in rank_of ? rank_of[part[2]] : -1
}

{
    file = $1
    header = $2
    count++
    from = rank(file)
    to = rank(header)
    in_app = file ~ /^app\//
    system_header = header ~ /^</
    if (!system_header && header !~ /^(app|platform)\// &&
        header !~ /_drivers\.h$/) {
        broken("named")
    }
    if (from < 0 || to < 0) {
        broken("placed")
    }
}

!in_app && header ~ /^app\// { broken("app") }

!in_app { next }

to > from { broken("upward") }

header ~ /^platform\// && header !~ /^platform\/[a-z]+\/[a-z0-9_]+\.h$/ {
    broken("private")
}

from <= rank_of["anim"] && header ~ /^platform\// &&
    header !~ /^platform\/base\// {
    broken("seam")
}

from == rank_of["anim"] && header in outside { broken("outside") }

system_header && !(header in plain) && !(header in outside) &&
    header !~ /^<cglm\// &&
    !(from == rank_of["model"] && header in library_model) &&
    !(from == rank_of["compare"] && header in library_compare) &&
    !(from == rank_of["character"] && header in library_character) &&
    !(from == rank_of["cmd"] && header in library_cmd) {
    broken("foreign")
}

END {
    for (i = 1; i <= rules; i++) {
        bad = key_of[i] in found
        failed += bad
        print (bad ? "not ok " : "ok ") i " - " name_of[i]
        printf "%s", found[key_of[i]]
    }
    # Without any input, nothing was checked.
    print "1.." (count ? rules : 0)
    exit (failed > 0)
}
