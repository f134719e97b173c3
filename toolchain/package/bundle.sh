#!/bin/sh
# bundle.sh SYSROOT LIMBER HOST-LIMBER OUT: packs limber, its models and all libraries
# that it needs as OUT/limber-VERSION-armv6.tar.gz. What it holds runs on any board
# with an ARMv6 core or a later one, VFP and Linux 3.2, whatever libraries the board
# has. The same input gives the same bytes. HOST-LIMBER is the program for this
# machine, which makes the levels of detail.
set -eu
export LC_ALL=C
sysroot=$1
program=$2
host_limber=$3
out=$4
top=$(dirname "$0")/../..
libraries=$sysroot/usr/lib/arm-linux-gnueabi
version=$("$host_limber" --version | sed -n '1s/^limber \([^ ]*\).*/\1/p')
stage=$out/bundle.new
tree=$stage/limber
trap 'rm -rf "$stage"' EXIT

rm -rf "$stage"
mkdir -p "$tree/bin" "$tree/lib" "$tree/share/limber" "$tree/share/doc"

# add NAME: copies a library, those that it needs, and its licence.
add() {
    [ ! -e "$tree/lib/$1" ] || return 0
    [ -e "$libraries/$1" ] || {
        echo "limber: $libraries/$1 is missing: make build/sysroot.stamp" >&2
        exit 1
    }
    cp -L "$libraries/$1" "$tree/lib/$1"
    add_needed "$tree/lib/$1"
}

# add_needed FILE: copies the libraries that a program or library needs.
add_needed() {
    for name in $(arm-linux-gnueabi-readelf -d "$1" |
        sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'); do
        add "$name"
    done
}

arm-linux-gnueabi-strip -o "$tree/bin/limber" "$program"
add_needed "$tree/bin/limber"
# limber opens it with a camera.
add libv4lconvert.so.0
for package in libc6 libjpeg62-turbo libv4lconvert0t64 libjansson4 libpng16-16t64 \
    zlib1g libgif7 libgpiod3 libdrm2 libinih1; do
    cp -L "$sysroot/usr/share/doc/$package/copyright" "$tree/share/doc/$package.txt"
done
cp "$top/LICENSE" "$tree/share/doc/limber.txt"

cp "$top"/assets/*.glb "$top"/assets/*.character "$top/assets/presets.ini" \
    "$tree/share/limber"
for model in "$tree"/share/limber/*.glb; do
    "$host_limber" levels "$model" -o "${model%.glb}.levels"
done

cat >"$tree/limber" <<'END'
#!/bin/sh
# Starts limber with the libraries of this folder.
here=$(dirname "$(readlink -f "$0")")
exec "$here/lib/ld-linux.so.3" --library-path "$here/lib" "$here/bin/limber" "$@"
END
chmod -R u=rwX,go=rX "$stage"
chmod 755 "$tree/limber" "$tree/bin/limber" "$tree/lib/ld-linux.so.3"

tar -C "$stage" --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner \
    -cf - limber | gzip -9n >"$out/limber-$version-armv6.tar.gz"
echo "  BUNDLE  $out/limber-$version-armv6.tar.gz"
