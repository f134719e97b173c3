#!/bin/sh
# See tree.py.
exec python3 -B "$(dirname "$0")/tree.py"
