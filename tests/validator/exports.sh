#!/bin/sh
# exports.sh LIMBER MODEL[@CLIP]...: exports every technique that limber compare
# bakes of a model's clip, or of all clips, and validates the files with
# validate.js. It prints TAP.
set -eu
limber=$1
shift
here=$(dirname "$0")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=0
for model in "$@"; do
    count=$((count + 1))
    file=${model%@*}
    clip=${model#"$file"}
    "$limber" compare "$file" ${clip:+--clip "${clip#@}"} --error 2 \
        --export "$folder/$count" >"$folder/report" || {
        echo "Bail out! limber compare $model failed"
        exit 1
    }
done
node "$here/validate.js" "$folder"/*/*.glb
