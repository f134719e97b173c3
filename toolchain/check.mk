# make check: see tests/README.md.
