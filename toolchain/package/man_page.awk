# Turns app/character/format.md into a section of the manual page.

function plain(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    gsub(/`/, "", text)
    return text
}

/^# / { print ".SH \"CHARACTER FILES\""; next }
/^## / { sub(/^## /, ""); print ".SS \"" plain($0) "\""; next }
/^```/ { code = !code; print code ? ".PP\n.nf" : ".fi"; next }
code { text = plain($0); print (text ~ /^[.']/ ? "\\&" : "") "  " text; next }
/^\|---/ { next }
/^\| (Key|Section|Action) / { next }
/^\| / {
    n = split($0, cell, / \| */)
    sub(/^\| /, "", cell[1])
    sub(/ *\|$/, "", cell[2])
    print ".TP\n.B " plain(cell[1]) "\n" plain(cell[2])
    next
}
/^- / { print ".IP \\(bu 2"; sub(/^- /, "") }
/^$/ { print ".PP"; next }
{ print plain($0) }
