#!/bin/sh
# Includes run cmd -> demo -> character -> compare -> scene -> anim -> model, from any of them
# to platform's public headers, and from platform to nothing of app. TREE is the
# folder of app/ and platform/.
rules=$(cd "$(dirname "$0")" && pwd)/includes.awk
cd "${TREE:-.}" || exit 1

find app platform -name '*.[chS]' \
    -exec grep -HE '^[[:space:]]*#[[:space:]]*include' {} + |
    sed -E 's/^([^:]*):[[:space:]]*#[[:space:]]*include[[:space:]]*("([^"]*)"|(<[^>]*>)).*/\1 \3\4/' |
    sort | awk -f "$rules"
