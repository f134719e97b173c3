#!/bin/sh
# optimized.sh LIMBER MODEL...: writes each model with limber optimize, and
# validates the files with validate.js. It prints TAP.
set -eu
limber=$1
shift
here=$(dirname "$0")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=0
for model in "$@"; do
    count=$((count + 1))
    "$limber" optimize "$model" -o "$folder/$count.glb" >"$folder/report" || {
        echo "Bail out! limber optimize $model failed"
        exit 1
    }
done
node "$here/validate.js" "$folder"/*.glb
